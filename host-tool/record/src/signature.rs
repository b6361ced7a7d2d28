//! Whose signature a record carries (Ed25519, RFC 8032).

use calib_protocol::record::RecordError;
use calib_protocol::signature::{self, PublicKey};
use ed25519_dalek::{Signature, VerifyingKey};

/// Signature of a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signed {
    /// It carries none.
    No,
    /// Every byte of it is as the holder of this key signed it.
    By(PublicKey),
    /// It carries one that does not fit: of what was signed something was altered.
    Falsely,
}

/// Signature of the record whose bytes these are.
///
/// # Errors
/// Those of [`calib_protocol::record::check`]: the bytes are no record.
pub fn signed(bytes: &[u8]) -> Result<Signed, RecordError> {
    let Some((signature, message)) = signature::of(bytes)? else {
        return Ok(Signed::No);
    };
    let [r, s] = signature.halves;
    // Strictly: neither a key nor a signature that several messages fit.
    let fits = VerifyingKey::from_bytes(&signature.key).is_ok_and(|key| {
        let signature = Signature::from_components(r, s);
        key.verify_strict(&message, &signature).is_ok()
    });
    Ok(match fits {
        true => Signed::By(signature.key),
        false => Signed::Falsely,
    })
}

/// The key that signed these bytes, whole; none where they are no record, not signed, or altered since.
pub fn signer(bytes: &[u8]) -> Option<PublicKey> {
    match signed(bytes) {
        Ok(Signed::By(key)) => Some(key),
        _ => None,
    }
}

/// A key as people compare it: its first 64 bits in four groups of hexadecimal digits. That none can be made
/// to look like another is not promised; programs compare the whole.
pub fn short(key: &PublicKey) -> String {
    let groups: Vec<String> = key[..8].chunks(2).map(hex::encode).collect();
    groups.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    const SEED: [u8; 32] = [5; 32];

    #[test]
    fn a_record_that_was_signed_is_by_its_key() {
        let record = sample::record(&[160.0]);
        assert_eq!(signed(&sample::bytes(&record)), Ok(Signed::No));
        let bytes = sample::signed(&record, &SEED);
        let public = ed25519_dalek::SigningKey::from_bytes(&SEED).verifying_key();
        assert_eq!(signed(&bytes), Ok(Signed::By(public.to_bytes())));
    }

    /// A record altered anywhere, with its checksum mended: the signature does not fit, or it is no record.
    #[test]
    fn every_flipped_bit_of_a_signed_record_shows() {
        let bytes = sample::signed(&sample::record(&[160.0]), &SEED);
        let own = signed(&bytes);
        for bit in 0..(bytes.len() - 4) * 8 {
            let mut flipped = bytes.clone();
            flipped[bit / 8] ^= 1 << (bit % 8);
            sample::mend(&mut flipped);
            let found = signed(&flipped);
            assert!(found != own, "bit {bit}: {found:?}");
            assert!(!matches!(found, Ok(Signed::By(_))), "bit {bit}: {found:?}");
        }
    }

    #[test]
    fn a_key_is_told_by_four_groups() {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&[0x3F, 0x2A, 0x91, 0xC0, 0x77, 0xDE, 0x1B, 0x04]);
        assert_eq!(short(&key), "3f2a 91c0 77de 1b04");
    }
}
