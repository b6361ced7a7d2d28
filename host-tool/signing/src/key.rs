//! The laboratory's key: what it signs with, and the certificates that say whose it is.

use crate::certificate::{ECDSA_SHA256, RSA_SHA256, Scheme};
use crate::pkcs12::{self, Closed, Content};
use crate::{Certificate, Problem};
use calib_files::{Error, Result};
use der::oid::ObjectIdentifier;
use jiff::Timestamp;
use p256::ecdsa::signature::Signer;
use p256::ecdsa::{Signature, SigningKey};
use p256::pkcs8::DecodePrivateKey;
use ring::rand::SystemRandom;
use ring::signature::{RSA_PKCS1_SHA256, RsaKeyPair};
use std::fmt;
use std::path::Path;

/// Text that is signed to learn that key and certificate belong together.
const TRIAL: &[u8] = b"calib: key and certificate are of one another";

/// A private key with its certificate and those of its issuers.
pub struct LaboratoryKey {
    pair: Pair,
    /// That of the key first.
    certificates: Vec<Certificate>,
}

/// Either signs the same message in the same way each time (PKCS#1 1.5; RFC 6979): what was given out can be made
/// once more.
enum Pair {
    Rsa(Box<RsaKeyPair>),
    P256(Box<SigningKey>),
}

impl fmt::Debug for LaboratoryKey {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "LaboratoryKey({})", self.certificate().subject())
    }
}

impl LaboratoryKey {
    /// Opens a PKCS#12 file: one RSA (2048 to 4096 bits) or P-256 key, its certificate, and where there are
    /// some those of its issuers.
    ///
    /// # Errors
    /// [`Error::File`] when it cannot be read; [`Error::Input`] when the password is another, when it holds no
    /// such key or no certificate of it, and when the certificate is not in force `now`.
    pub fn open(path: &Path, password: &str, now: Timestamp) -> Result<Self> {
        let file = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
        let refused = |problem: String, hint: &str| {
            Error::input(path.display().to_string(), problem, hint.to_owned())
        };
        let content = pkcs12::open(&file, password).map_err(|closed| match closed {
            Closed::Password => refused(
                "the password does not open it".into(),
                "the one it was made with; CALIB_KEY_PASSWORD or --password-file state it",
            ),
            Closed::Old => refused(
                "is protected in an old way (3DES, RC2, SHA-1) that is not read".into(),
                "renew it: `openssl pkcs12 -legacy -in OLD -nodes | openssl pkcs12 -export -out NEW`",
            ),
            Closed::Malformed(problem) => refused(
                format!("is no PKCS#12 file: {problem}"),
                "docs/certificate.md says how to make one",
            ),
        })?;
        let key = Self::of(content).map_err(|Problem(problem)| {
            refused(problem, "docs/certificate.md says how to make a key")
        })?;
        key.may_sign(now)
            .map_err(|Problem(problem)| refused(problem, "renew the certificate of the key"))?;
        Ok(key)
    }

    fn of(content: Content) -> std::result::Result<Self, Problem> {
        let [key] = &content.keys[..] else {
            let found = content.keys.len();
            return Err(Problem::new(format!("holds {found} keys in place of one")));
        };
        let pair = Pair::of(key)?;
        let trial = pair.sign(Scheme::Sha256, TRIAL)?;
        let of_key = |one: &Certificate| one.signed(Scheme::Sha256, TRIAL, &trial);
        let (own, issuers): (Vec<_>, Vec<_>) = content.certificates.into_iter().partition(of_key);
        if own.is_empty() {
            return Err(Problem::new("holds no certificate of its key"));
        }
        let certificates = own.into_iter().chain(issuers).collect();
        Ok(Self { pair, certificates })
    }

    fn may_sign(&self, now: Timestamp) -> std::result::Result<(), Problem> {
        let (from, to) = self.certificate().period();
        if now < from {
            return Err(Problem::new(format!("its certificate begins on {from}")));
        }
        if now > to {
            return Err(Problem::new(format!("its certificate ended on {to}")));
        }
        match self.certificate().may_sign() {
            true => Ok(()),
            false => Err(Problem::new(
                "its certificate is not for signatures (key usage)",
            )),
        }
    }

    /// The certificate of the key.
    pub fn certificate(&self) -> &Certificate {
        // Note(index): made of one at least.
        &self.certificates[0]
    }

    /// All certificates, that of the key first.
    pub fn certificates(&self) -> &[Certificate] {
        &self.certificates
    }

    pub(crate) fn algorithm(&self) -> ObjectIdentifier {
        match self.pair {
            Pair::Rsa(_) => RSA_SHA256,
            Pair::P256(_) => ECDSA_SHA256,
        }
    }

    pub(crate) fn sign(
        &self,
        scheme: Scheme,
        message: &[u8],
    ) -> std::result::Result<Vec<u8>, Problem> {
        self.pair.sign(scheme, message)
    }
}

impl Pair {
    fn of(pkcs8: &[u8]) -> std::result::Result<Self, Problem> {
        if let Ok(pair) = RsaKeyPair::from_pkcs8(pkcs8) {
            return Ok(Self::Rsa(Box::new(pair)));
        }
        let pair = SigningKey::from_pkcs8_der(pkcs8).map_err(|error| {
            Problem::new(format!(
                "its key is neither RSA of 2048 to 4096 bits nor P-256 ({error})"
            ))
        })?;
        Ok(Self::P256(Box::new(pair)))
    }

    fn sign(&self, scheme: Scheme, message: &[u8]) -> std::result::Result<Vec<u8>, Problem> {
        let unsigned = || Problem::new("the key made no signature");
        match (self, scheme) {
            (Self::Rsa(pair), Scheme::Sha256 | Scheme::Sha256Fixed) => {
                let mut signature = vec![0; pair.public().modulus_len()];
                let random = SystemRandom::new();
                let signed = pair.sign(&RSA_PKCS1_SHA256, &random, message, &mut signature);
                signed.map_err(|_| unsigned())?;
                Ok(signature)
            }
            (Self::P256(pair), Scheme::Sha256 | Scheme::Sha256Fixed) => {
                let signature: Signature = pair.try_sign(message).map_err(|_| unsigned())?;
                Ok(match scheme {
                    Scheme::Sha256Fixed => signature.to_bytes().to_vec(),
                    _ => signature.to_der().as_bytes().to_vec(),
                })
            }
            _ => Err(Problem::new("no key signs that way")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bytes(digits: &str) -> Vec<u8> {
        hex::decode(digits).expect("digits")
    }

    /// RFC 6979, A.2.5: key, and signatures with SHA-256 of "sample" and "test".
    #[test]
    fn ecdsa_signs_as_rfc_6979_says() {
        let key = "C9AFA9D845BA75166B5C215767B1D6934E50C3DB36E89B127B8A622B120F6721";
        let key = SigningKey::from_slice(&bytes(key)).expect("a key");
        let pair = Pair::P256(Box::new(key));
        for (message, r, s) in [
            (
                "sample",
                "EFD48B2AACB6A8FD1140DD9CD45E81D69D2C877B56AAF991C34D0EA84EAF3716",
                "F7CB1C942D657C41D436C7A1B6E29F65F3E900DBB9AFF4064DC4AB2F843ACDA8",
            ),
            (
                "test",
                "F1ABB023518351CD71D881567B1EA663ED3EFCF6C5132B354F28D3B0B7D38367",
                "019F4113742A2B14BD25926B49C649155F267E60D3814B4C0CC84250E46F0083",
            ),
        ] {
            let signed = pair.sign(Scheme::Sha256Fixed, message.as_bytes());
            assert_eq!(
                signed.expect("signs"),
                bytes(&format!("{r}{s}")),
                "{message}"
            );
        }
    }
}
