//! X.509 certificates: whose a key is, for how long, and who says so.

use crate::Problem;
use calib_files::{Error, Result};
use der::oid::ObjectIdentifier;
use der::{Decode, Encode, Reader, SliceReader};
use jiff::Timestamp;
use ring::signature::{self, UnparsedPublicKey, VerificationAlgorithm};
use sha2::{Digest, Sha256};
use std::path::Path;
use x509_cert::ext::pkix::{BasicConstraints, KeyUsage, KeyUsages};

pub(crate) const RSA: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.1.1");
pub(crate) const EC: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.10045.2.1");
pub(crate) const P256: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.10045.3.1.7");
pub(crate) const RSA_SHA256: ObjectIdentifier =
    ObjectIdentifier::new_unwrap("1.2.840.113549.1.1.11");
const RSA_SHA384: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.1.12");
const RSA_SHA512: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.1.13");
const P384: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.3.132.0.34");
pub(crate) const ECDSA_SHA256: ObjectIdentifier =
    ObjectIdentifier::new_unwrap("1.2.840.10045.4.3.2");
const ECDSA_SHA384: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.10045.4.3.3");
/// Certificates between a signature and one that is known: more is no laboratory's.
const LONGEST_CHAIN: usize = 5;

/// A certificate, byte for byte as it was given.
#[derive(Clone, Debug)]
pub struct Certificate {
    der: Vec<u8>,
    parsed: x509_cert::Certificate,
}

impl PartialEq for Certificate {
    fn eq(&self, other: &Self) -> bool {
        self.der == other.der
    }
}

impl Certificate {
    /// The certificates of a file, PEM (one or more) or DER.
    ///
    /// # Errors
    /// [`Error::File`] when it cannot be read, [`Error::Input`] when it holds no certificate.
    pub fn read(path: &Path) -> Result<Vec<Self>> {
        let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
        let parsed = if bytes.starts_with(b"-----") {
            x509_cert::Certificate::load_pem_chain(&bytes)
                .and_then(|chain| chain.iter().map(Encode::to_der).collect())
        } else {
            Ok(vec![bytes])
        };
        let all: std::result::Result<Vec<_>, _> = match parsed {
            Ok(all) => all.into_iter().map(Self::from_der).collect(),
            Err(error) => Err(Problem::new(error.to_string())),
        };
        all.ok().filter(|all| !all.is_empty()).ok_or_else(|| {
            let hint = "name the public certificate of a laboratory or its authority, PEM or DER";
            Error::input(path.display().to_string(), "holds no certificate", hint)
        })
    }

    pub(crate) fn from_der(der: Vec<u8>) -> std::result::Result<Self, Problem> {
        let parsed = x509_cert::Certificate::from_der(&der)
            .map_err(|error| Problem::new(format!("a certificate in it is none: {error}")))?;
        Ok(Self { der, parsed })
    }

    /// Its bytes, DER.
    pub fn der(&self) -> &[u8] {
        &self.der
    }

    pub(crate) fn parsed(&self) -> &x509_cert::Certificate {
        &self.parsed
    }

    /// Whose key it is, as RFC 4514 writes names; controls are question marks.
    pub fn subject(&self) -> String {
        one_line(&self.parsed.tbs_certificate().subject().to_string())
    }

    /// Who says so; the subject itself where nobody else does.
    pub fn issuer(&self) -> String {
        one_line(&self.parsed.tbs_certificate().issuer().to_string())
    }

    /// SHA-256 of its bytes, as other programs show it.
    pub fn fingerprint(&self) -> [u8; 32] {
        Sha256::digest(&self.der).into()
    }

    /// First and last moment it is in force.
    pub fn period(&self) -> (Timestamp, Timestamp) {
        let validity = self.parsed.tbs_certificate().validity();
        let at = |time: x509_cert::time::Time| {
            let seconds = i64::try_from(time.to_unix_duration().as_secs()).unwrap_or(i64::MAX);
            Timestamp::from_second(seconds).unwrap_or(Timestamp::MAX)
        };
        (at(validity.not_before), at(validity.not_after))
    }

    /// Whether it is in force at this moment.
    pub fn is_in_force(&self, at: Timestamp) -> bool {
        let (from, to) = self.period();
        from <= at && at <= to
    }

    /// Whether its key may sign documents: nothing is said of that, or it is allowed.
    pub(crate) fn may_sign(&self) -> bool {
        self.usage().is_none_or(|usage| {
            usage.digital_signature() || usage.0.contains(KeyUsages::NonRepudiation)
        })
    }

    pub(crate) fn is_rsa(&self) -> bool {
        let spki = self.parsed.tbs_certificate().subject_public_key_info();
        spki.algorithm.oid == RSA
    }

    fn usage(&self) -> Option<KeyUsage> {
        let found = self.parsed.tbs_certificate().get_extension::<KeyUsage>();
        found.ok().flatten().map(|(_, usage)| usage)
    }

    fn is_authority(&self) -> bool {
        let tbs = self.parsed.tbs_certificate();
        let constraints = tbs.get_extension::<BasicConstraints>().ok().flatten();
        constraints.is_some_and(|(_, constraints)| constraints.ca)
            && self.usage().is_none_or(|usage| usage.key_cert_sign())
    }

    /// Whether this key made the signature.
    pub(crate) fn signed(&self, scheme: Scheme, message: &[u8], signature: &[u8]) -> bool {
        let spki = self.parsed.tbs_certificate().subject_public_key_info();
        let curve = spki.algorithm.parameters.as_ref();
        let curve = curve.and_then(|any| any.decode_as::<ObjectIdentifier>().ok());
        let Some(algorithm) = scheme.with(spki.algorithm.oid, curve) else {
            return false;
        };
        let Some(key) = spki.subject_public_key.as_bytes() else {
            return false;
        };
        UnparsedPublicKey::new(algorithm, key)
            .verify(message, signature)
            .is_ok()
    }

    /// Whether `other` carries this authority's signature.
    fn issued(&self, other: &Self) -> bool {
        let named =
            self.parsed.tbs_certificate().subject() == other.parsed.tbs_certificate().issuer();
        let scheme = Scheme::of_certificate(other.parsed.signature_algorithm().oid);
        let signature = other.parsed.signature().as_bytes();
        match (scheme, other.stated(), signature) {
            (Some(scheme), Some(stated), Some(signature)) if named && self.is_authority() => {
                self.signed(scheme, stated, signature)
            }
            _ => false,
        }
    }

    /// The bytes its issuer signed, as they were given.
    fn stated(&self) -> Option<&[u8]> {
        let mut reader = SliceReader::new(&self.der).ok()?;
        der::Header::decode(&mut reader).ok()?;
        reader.tlv_bytes().ok()
    }

    /// Whether one of `known` is this certificate, or issued it, by way of `others` where it takes some. Issuers
    /// are in force at this moment.
    pub(crate) fn leads_to(&self, known: &[Self], others: &[Self], at: Timestamp) -> bool {
        self.leads(known, others, at, LONGEST_CHAIN)
    }

    fn leads(&self, known: &[Self], others: &[Self], at: Timestamp, left: usize) -> bool {
        if known.contains(self) {
            return true;
        }
        let mut issuers = known.iter().chain(others);
        left > 0
            && issuers.any(|issuer| {
                issuer.is_in_force(at)
                    && issuer.issued(self)
                    && issuer.leads(known, others, at, left - 1)
            })
    }
}

/// How a signature is made, whatever the key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scheme {
    /// SHA-256; the signature of an elliptic curve as ASN.1.
    Sha256,
    /// SHA-256; the signature of an elliptic curve as two numbers of fixed length (XML).
    Sha256Fixed,
    Sha384,
    Sha512,
}

impl Scheme {
    fn of_certificate(algorithm: ObjectIdentifier) -> Option<Self> {
        match algorithm {
            RSA_SHA256 | ECDSA_SHA256 => Some(Self::Sha256),
            RSA_SHA384 | ECDSA_SHA384 => Some(Self::Sha384),
            RSA_SHA512 => Some(Self::Sha512),
            _ => None,
        }
    }

    fn with(
        self,
        key: ObjectIdentifier,
        curve: Option<ObjectIdentifier>,
    ) -> Option<&'static dyn VerificationAlgorithm> {
        match (key, curve, self) {
            (RSA, _, Self::Sha256 | Self::Sha256Fixed) => {
                Some(&signature::RSA_PKCS1_2048_8192_SHA256)
            }
            (RSA, _, Self::Sha384) => Some(&signature::RSA_PKCS1_2048_8192_SHA384),
            (RSA, _, Self::Sha512) => Some(&signature::RSA_PKCS1_2048_8192_SHA512),
            (EC, Some(P256), Self::Sha256) => Some(&signature::ECDSA_P256_SHA256_ASN1),
            (EC, Some(P256), Self::Sha256Fixed) => Some(&signature::ECDSA_P256_SHA256_FIXED),
            (EC, Some(P256), Self::Sha384) => Some(&signature::ECDSA_P256_SHA384_ASN1),
            (EC, Some(P384), Self::Sha256) => Some(&signature::ECDSA_P384_SHA256_ASN1),
            (EC, Some(P384), Self::Sha384) => Some(&signature::ECDSA_P384_SHA384_ASN1),
            _ => None,
        }
    }
}

/// Names are the issuer's words: they turn no line round and begin none.
fn one_line(words: &str) -> String {
    let turns = |c: char| matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let shown = |c: char| if c.is_control() || turns(c) { '?' } else { c };
    words.chars().map(shown).collect()
}
