//! The laboratory's key: what it signs with, and the certificates that say whose it is.

use crate::certificate::{ECDSA_SHA256, RSA_SHA256, Scheme};
use crate::pkcs12::{self, Closed, Content};
use crate::{Certificate, Problem};
use calib_files::{Error, Result};
use der::oid::ObjectIdentifier;
use jiff::Timestamp;
use ring::rand::SystemRandom;
use ring::signature::{
    ECDSA_P256_SHA256_ASN1_SIGNING, ECDSA_P256_SHA256_FIXED_SIGNING, EcdsaKeyPair,
    RSA_PKCS1_SHA256, RsaKeyPair,
};
use std::fmt;
use std::path::Path;

/// What is signed to learn that key and certificate belong together.
const TRIAL: &[u8] = b"calib: key and certificate are of one another";

/// A private key with its certificate and those of its issuers.
pub struct LaboratoryKey {
    pair: Pair,
    /// That of the key first.
    certificates: Vec<Certificate>,
}

enum Pair {
    Rsa(Box<RsaKeyPair>),
    P256 {
        /// Signatures as ASN.1.
        asn1: Box<EcdsaKeyPair>,
        /// Signatures of fixed length.
        fixed: Box<EcdsaKeyPair>,
    },
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
            Pair::P256 { .. } => ECDSA_SHA256,
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
        let random = SystemRandom::new();
        let pair = |algorithm| {
            EcdsaKeyPair::from_pkcs8(algorithm, pkcs8, &random).map_err(|error| {
                Problem::new(format!(
                    "its key is neither RSA of 2048 to 4096 bits nor P-256 ({error})"
                ))
            })
        };
        Ok(Self::P256 {
            asn1: Box::new(pair(&ECDSA_P256_SHA256_ASN1_SIGNING)?),
            fixed: Box::new(pair(&ECDSA_P256_SHA256_FIXED_SIGNING)?),
        })
    }

    fn sign(&self, scheme: Scheme, message: &[u8]) -> std::result::Result<Vec<u8>, Problem> {
        let random = SystemRandom::new();
        let failed = |_| Problem::new("the key made no signature");
        match (self, scheme) {
            (Self::Rsa(pair), Scheme::Sha256 | Scheme::Sha256Fixed) => {
                let mut signature = vec![0; pair.public().modulus_len()];
                let signed = pair.sign(&RSA_PKCS1_SHA256, &random, message, &mut signature);
                signed.map_err(failed)?;
                Ok(signature)
            }
            (Self::P256 { asn1: pair, .. }, Scheme::Sha256)
            | (Self::P256 { fixed: pair, .. }, Scheme::Sha256Fixed) => {
                let signature = pair.sign(&random, message).map_err(failed)?;
                Ok(signature.as_ref().to_vec())
            }
            _ => Err(Problem::new("no key signs that way")),
        }
    }
}
