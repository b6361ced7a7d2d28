//! Signatures of a laboratory that programs of others verify: PAdES in a PDF, an XML signature in a DCC.
//!
//! | file | idea |
//! |---|---|
//! | `key` | the laboratory's key with its certificates |
//! | `pkcs12` | the file it is kept in |
//! | `certificate` | an X.509 certificate, what it signs and who issued it |
//! | `cms` | the signature container of PAdES |
//! | `pdf` | a PDF with a signature appended, and the check of one |
//! | `dictionary` | the few words of PDF that takes |
//! | `xml` | an XML signature within a document, and the check of one |
//! | `canonical` | a document as bytes that do not depend on how it is written |
//! | `verified` | what a signed file proves, whatever it is |
//!
//! The cryptography is `ring`'s, but for ECDSA without chance, which is RustCrypto's as the readers and writers of containers
//! and certificates are.
#![forbid(unsafe_code)]

mod canonical;
mod certificate;
mod cms;
mod dictionary;
mod key;
mod pdf;
mod pkcs12;
#[cfg(test)]
mod tests;
mod verified;
mod xml;

pub use certificate::Certificate;
pub use key::LaboratoryKey;
pub use verified::{Kind, Signature, sign, sign_text, verify, verify_text};

/// Why a signature does not hold or cannot be read, in words.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct Problem(pub String);

impl Problem {
    pub(crate) fn new(words: impl Into<String>) -> Self {
        Self(words.into())
    }
}
