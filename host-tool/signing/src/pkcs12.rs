//! PKCS#12: a private key and certificates in one file, under a password (RFC 7292).
//!
//! Read is what `openssl pkcs12 -export` and Windows write today: PBES2 with AES, a sum with SHA-2. Files of
//! before, with 3DES and SHA-1, are refused with the way to renew them.

use crate::{Certificate, Problem};
use ::cms::content_info::ContentInfo;
use ::cms::encrypted_data::EncryptedData;
use ::pkcs12::AuthenticatedSafe;
use ::pkcs12::CertBag;
use ::pkcs12::kdf::{Pkcs12KeyType, derive_key_utf8};
use ::pkcs12::pfx::Pfx;
use ::pkcs12::safe_bag::SafeContents;
use ::pkcs12::{
    PKCS_12_CERT_BAG_OID, PKCS_12_KEY_BAG_OID, PKCS_12_PKCS8_KEY_BAG_OID, PKCS_12_X509_CERT_OID,
};
use der::asn1::{ContextSpecific, OctetString};
use der::oid::ObjectIdentifier;
use der::{Any, Decode, DecodeOwned, Encode, Sequence};
use hmac::{Hmac, KeyInit, Mac};
use pkcs5::EncryptionScheme;
use sha2::{Sha256, Sha384, Sha512};

const DATA: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.7.1");
const ENCRYPTED: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.7.6");
const SHA256: ObjectIdentifier = ObjectIdentifier::new_unwrap("2.16.840.1.101.3.4.2.1");
const SHA384: ObjectIdentifier = ObjectIdentifier::new_unwrap("2.16.840.1.101.3.4.2.2");
const SHA512: ObjectIdentifier = ObjectIdentifier::new_unwrap("2.16.840.1.101.3.4.2.3");
/// Rounds of the sum's key; more than any program writes, and still seconds.
const MOST_ROUNDS: i32 = 10_000_000;

/// Why the file cannot be opened.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Closed {
    /// The password is another one, or the file was altered.
    Password,
    /// It is protected in a way that is not read.
    Old,
    /// It is no such file.
    Malformed(String),
}

impl From<der::Error> for Closed {
    fn from(error: der::Error) -> Self {
        Self::Malformed(error.to_string())
    }
}

impl From<Problem> for Closed {
    fn from(problem: Problem) -> Self {
        Self::Malformed(problem.0)
    }
}

/// Content of such a file.
#[derive(Default)]
pub(crate) struct Content {
    /// Private keys, PKCS#8.
    pub(crate) keys: Vec<Vec<u8>>,
    pub(crate) certificates: Vec<Certificate>,
}

/// A private key under the password.
#[derive(Sequence)]
struct Shrouded {
    scheme: Any,
    key: OctetString,
}

/// Opens the file with its password.
pub(crate) fn open(file: &[u8], password: &str) -> Result<Content, Closed> {
    let pfx = Pfx::from_der(file)?;
    let safe = pfx.auth_safe.content.decode_as::<OctetString>()?;
    check_sum(&pfx, safe.as_bytes(), password)?;
    let mut content = Content::default();
    for part in AuthenticatedSafe::from_der(safe.as_bytes())? {
        let bags = opened(&part, password)?;
        for bag in SafeContents::from_der(&bags)? {
            content.take(bag.bag_id, &bag.bag_value, password)?;
        }
    }
    Ok(content)
}

impl Content {
    fn take(&mut self, kind: ObjectIdentifier, value: &[u8], password: &str) -> Result<(), Closed> {
        match kind {
            PKCS_12_KEY_BAG_OID => self.keys.push(inner::<Any>(value)?.to_der()?),
            PKCS_12_PKCS8_KEY_BAG_OID => {
                let shrouded = inner::<Shrouded>(value)?;
                let key = decrypted(&shrouded.scheme, shrouded.key.as_bytes(), password)?;
                self.keys.push(key);
            }
            PKCS_12_CERT_BAG_OID => {
                let bag = inner::<CertBag>(value)?;
                if bag.cert_id == PKCS_12_X509_CERT_OID {
                    let der = bag.cert_value.as_bytes().to_vec();
                    self.certificates.push(Certificate::from_der(der)?);
                }
            }
            _ => (),
        }
        Ok(())
    }
}

/// Content of the explicit tag of a bag.
fn inner<T>(value: &[u8]) -> Result<T, der::Error>
where
    T: DecodeOwned<Error = der::Error> + der::Tagged,
{
    Ok(ContextSpecific::<T>::from_der(value)?.value)
}

/// The bags of a part, decrypted where they have to be.
fn opened(part: &ContentInfo, password: &str) -> Result<Vec<u8>, Closed> {
    match part.content_type {
        DATA => Ok(part
            .content
            .decode_as::<OctetString>()?
            .into_bytes()
            .into_vec()),
        ENCRYPTED => {
            let data = part.content.decode_as::<EncryptedData>()?;
            let content = data.enc_content_info;
            let missing = || Closed::Malformed("a part of it is empty".into());
            let hidden = content.encrypted_content.ok_or_else(missing)?;
            let scheme = Any::encode_from(&content.content_enc_alg)?;
            decrypted(&scheme, hidden.as_bytes(), password)
        }
        _ => Err(Closed::Old),
    }
}

fn decrypted(scheme: &Any, hidden: &[u8], password: &str) -> Result<Vec<u8>, Closed> {
    let scheme = EncryptionScheme::from_der(&scheme.to_der()?).map_err(|_| Closed::Old)?;
    if scheme.pbes2().is_none() {
        return Err(Closed::Old);
    }
    let key = scheme.decrypt(password, hidden);
    key.map_err(|_| Closed::Password)
}

/// The sum under the password, over all there is (RFC 7292, appendix B): without it a wrong password could
/// open to something.
fn check_sum(pfx: &Pfx, safe: &[u8], password: &str) -> Result<(), Closed> {
    let sum = pfx.mac_data.as_ref().ok_or(Closed::Old)?;
    if !(1..=MOST_ROUNDS).contains(&sum.iterations) {
        return Err(Closed::Malformed("its sum has no number of rounds".into()));
    }
    let salt = sum.mac_salt.as_bytes();
    let (kind, rounds) = (Pkcs12KeyType::Mac, sum.iterations);
    let stated = sum.mac.digest.as_bytes();
    let wrong = |_| Closed::Password;
    macro_rules! check {
        ($digest:ty, $length:expr) => {{
            let key = derive_key_utf8::<$digest>(password, salt, kind, rounds, $length)?;
            let hmac = Hmac::<$digest>::new_from_slice(&key);
            let mut hmac = hmac.map_err(|error| Closed::Malformed(error.to_string()))?;
            hmac.update(safe);
            hmac.verify_slice(stated).map_err(wrong)
        }};
    }
    match sum.mac.algorithm.oid {
        SHA256 => check!(Sha256, 32),
        SHA384 => check!(Sha384, 48),
        SHA512 => check!(Sha512, 64),
        _ => Err(Closed::Old),
    }
}
