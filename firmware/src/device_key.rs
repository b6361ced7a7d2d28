//! The key of this instrument: it signs every record (Ed25519, RFC 8032).
//!
//! It is made on the instrument, under a hand, from the part's generator of random numbers, and leaves it in no
//! message. Who reads the flash through the debug port has it: `docs/safety.md` says what that means.

use calib_protocol::signature::{Message, PublicKey, Signature};
use ed25519_dalek::{Signer, SigningKey};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// Words of the generator that are condensed to a key: twice as many as it has.
pub const RANDOM_BYTES: usize = 64;

/// Seed of the key, and from which record on it signs.
#[derive(Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Secret {
    seed: [u8; 32],
    /// Running number of the first record that is signed.
    pub(crate) since: u32,
}

impl Secret {
    /// Of bytes that nobody knows.
    pub fn new(random: &[u8; RANDOM_BYTES], since: u32) -> Self {
        Self {
            seed: Sha256::digest(random).into(),
            since,
        }
    }
}

/// Nothing of it, whoever logs it.
impl core::fmt::Debug for Secret {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(formatter, "Secret(.., since {})", self.since)
    }
}

/// The key.
pub struct DeviceKey(SigningKey);

impl DeviceKey {
    /// The key of this secret.
    pub fn new(secret: &Secret) -> Self {
        Self(SigningKey::from_bytes(&secret.seed))
    }

    /// Its public half.
    pub fn public(&self) -> PublicKey {
        self.0.verifying_key().to_bytes()
    }

    /// Signs what is to be signed of a record.
    pub fn sign(&self, message: &Message) -> Signature {
        let signature = self.0.sign(message);
        Signature {
            key: self.public(),
            halves: [*signature.r_bytes(), *signature.s_bytes()],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ed25519_dalek::Verifier;

    #[test]
    fn what_it_signs_its_public_half_verifies() {
        let key = DeviceKey::new(&Secret::new(&[7; RANDOM_BYTES], 1));
        let message: Message = [9; 44];
        let signature = key.sign(&message);
        assert_eq!(signature.key, key.public());
        let public = ed25519_dalek::VerifyingKey::from_bytes(&key.public()).expect("a point");
        let [r, s] = signature.halves;
        let same = ed25519_dalek::Signature::from_components(r, s);
        assert!(public.verify(&message, &same).is_ok());
        assert!(public.verify(&[8; 44], &same).is_err());
    }

    /// RFC 8032, 7.1, test 1: the public key of a seed.
    #[test]
    fn the_public_key_is_that_of_the_rfc() {
        let seed = "9d61b19deffd5a60ba844af492ec2cc44449c5697b326919703bac031cae7f60";
        let public = "d75a980182b10ab7d54bfed3c964073a0ee172f3daa62325af021a68f707511a";
        let byte = |text: &str, i: usize| u8::from_str_radix(&text[2 * i..2 * i + 2], 16);
        let bytes = |text| core::array::from_fn(|i| byte(text, i).expect("two digits"));
        let secret = Secret {
            seed: bytes(seed),
            since: 1,
        };
        assert_eq!(DeviceKey::new(&secret).public(), bytes(public));
    }

    #[test]
    fn nothing_of_it_is_logged() {
        let secret = Secret::new(&[7; RANDOM_BYTES], 12);
        assert_eq!(format!("{secret:?}"), "Secret(.., since 12)");
    }
}
