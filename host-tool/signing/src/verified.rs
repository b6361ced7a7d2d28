//! Proof by a signed file of any kind; and signing one.

use crate::{Certificate, LaboratoryKey, Problem, cms, pdf, xml};
use jiff::Timestamp;
use sha2::{Digest, Sha256};

/// Kind of a file, by its first bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Certificate for people.
    Pdf,
    /// Certificate for machines.
    Dcc,
}

impl Kind {
    /// Kind of this file; none when it is neither.
    pub fn of(file: &[u8]) -> Option<Self> {
        let mark = "\u{feff}".as_bytes();
        let text = file.strip_prefix(mark).unwrap_or(file).trim_ascii_start();
        match text {
            _ if file.starts_with(b"%PDF-") => Some(Self::Pdf),
            [b'<', ..] => Some(Self::Dcc),
            _ => None,
        }
    }

    /// Whether a file of this kind carries a signature, of whatever worth.
    pub fn is_signed(self, file: &[u8]) -> bool {
        match self {
            Self::Pdf => pdf::is_signed(file),
            Self::Dcc => text(file).is_ok_and(xml::is_signed),
        }
    }
}

/// A signature that holds: every byte it is over is as it was signed by the key of this certificate.
#[derive(Clone, Debug)]
pub struct Signature {
    /// Certificate of the key.
    pub by: Certificate,
    /// Others the file carries, of issuers as a rule.
    pub others: Vec<Certificate>,
    /// When it was made, as its maker says; a DCC does not say.
    pub at: Option<Timestamp>,
}

impl Signature {
    /// Whether the certificate is one of `known`, or leads to one; it was in force when it says it signed, or,
    /// where it does not say, is `now`.
    pub fn is_of(&self, known: &[Certificate], now: Timestamp) -> bool {
        let at = self.at.unwrap_or(now);
        self.by.may_sign() && self.by.leads_to(known, &self.others, at)
    }

    /// Whether the certificate was in force when it says it signed; where it does not say, whether it is `now`.
    pub fn is_in_force(&self, now: Timestamp) -> bool {
        self.by.is_in_force(self.at.unwrap_or(now))
    }
}

fn text(file: &[u8]) -> Result<&str, Problem> {
    std::str::from_utf8(file).map_err(|_| Problem::new("is no text in UTF-8"))
}

/// Signs a file of this kind, and checks what was made.
///
/// # Errors
/// [`Problem`] when it is signed already, or has a form this tool does not write.
pub fn sign(
    kind: Kind,
    file: &[u8],
    key: &LaboratoryKey,
    at: Timestamp,
) -> Result<Vec<u8>, Problem> {
    let signed = match kind {
        Kind::Pdf => pdf::sign(file, key, at)?,
        Kind::Dcc => xml::sign(text(file)?, key)?.into_bytes(),
    };
    verify(kind, &signed)?;
    Ok(signed)
}

/// Checks the signature of a file by the certificate it carries; whose that is, is [`Signature::is_of`].
///
/// # Errors
/// [`Problem`] when there is none, when it does not hold, or when it is not over everything.
pub fn verify(kind: Kind, file: &[u8]) -> Result<Signature, Problem> {
    match kind {
        Kind::Pdf => {
            let pdf::Held { by, others, at } = pdf::verify(file)?;
            Ok(Signature { by, others, at })
        }
        Kind::Dcc => {
            let (by, others) = xml::verify(text(file)?)?;
            Ok(Signature {
                by,
                others,
                at: None,
            })
        }
    }
}

/// Signs a text that is kept beside it, such as the head of a journal; DER of CMS.
///
/// # Errors
/// [`Problem`] when the key makes no signature.
pub fn sign_text(key: &LaboratoryKey, text: &str) -> Result<Vec<u8>, Problem> {
    cms::sign(key, Sha256::digest(text).into())
}

/// Checks what [`sign_text`] made, by the certificate it carries.
///
/// # Errors
/// [`Problem`] when it does not hold for this text.
pub fn verify_text(signature: &[u8], text: &str) -> Result<Signature, Problem> {
    let (by, others) = cms::verify_own(signature, Sha256::digest(text).into())?;
    let at = None;
    Ok(Signature { by, others, at })
}
