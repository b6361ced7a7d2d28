//! The laboratory's signature on what it gives out.

use super::dcc;
use super::model::Certificate;
use super::words::Language;
use calib_files::{Error, Result};
use calib_signing::{Kind, LaboratoryKey};
use jiff::Timestamp;
use std::sync::Arc;

/// The laboratory's key, and when it signs.
#[derive(Clone, Debug)]
pub struct Seal {
    /// Key with its certificates.
    pub key: Arc<LaboratoryKey>,
    /// Time of the signature, as a PDF states it.
    pub at: Timestamp,
}

/// The content, signed where there is a key.
///
/// # Errors
/// [`Error::Input`] when a page of the laboratory's own became a PDF of another form.
pub(super) fn sealed(kind: Kind, content: Vec<u8>, seal: Option<&Seal>) -> Result<Vec<u8>> {
    let Some(seal) = seal else {
        return Ok(content);
    };
    let signed = calib_signing::sign(kind, &content, &seal.key, seal.at);
    signed.map_err(|problem| {
        let hint = "sign without a [layout] template of your own; if that fails, report it";
        Error::input("certificate", problem.to_string(), hint)
    })
}

/// The DCC, made once: an elliptic curve signs the same thing differently each time, and the one within the
/// PDF is the one beside it. Without date or country there is none, and the certificate says what is missing.
///
/// # Errors
/// As [`sealed`].
pub(super) fn dcc(
    certificate: &Certificate,
    language: Language,
    seal: Option<&Seal>,
) -> Result<Option<Vec<u8>>> {
    let dcc = dcc::render(certificate, language).ok();
    dcc.map(|dcc| sealed(Kind::Dcc, dcc, seal)).transpose()
}
