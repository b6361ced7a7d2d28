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

/// A file as it is given out, and without its signature.
#[derive(Clone, Debug)]
pub(super) struct Sealed {
    pub(super) content: Vec<u8>,
    /// None where it has no signature.
    pub(super) unsigned: Option<Vec<u8>>,
    /// Content the signature covers: a PDF may have a signed DCC in it.
    pub(super) page: Option<Vec<u8>>,
}

impl Sealed {
    /// Content without a signature.
    pub(super) fn plain(content: Vec<u8>) -> Self {
        Self {
            content,
            unsigned: None,
            page: None,
        }
    }

    fn unsigned(&self) -> &[u8] {
        self.unsigned.as_ref().unwrap_or(&self.content)
    }
}

/// The content, signed.
pub(super) fn signed(kind: Kind, content: &[u8], seal: &Seal) -> Result<Vec<u8>> {
    let signed = calib_signing::sign(kind, content, &seal.key, seal.at);
    signed.map_err(|problem| {
        let hint = "sign without a [layout] template of your own; if that fails, report it";
        Error::input("certificate", problem.to_string(), hint)
    })
}

/// The DCC, made once: the one within the PDF is the one beside it. Without date or country there is none, and the certificate says what is missing.
///
/// # Errors
/// As [`pdf`].
pub(super) fn dcc(
    certificate: &Certificate,
    language: Language,
    seal: Option<&Seal>,
) -> Result<Option<Sealed>> {
    let sealed = |dcc: Vec<u8>| match seal {
        None => Ok(Sealed::plain(dcc)),
        Some(seal) => Ok(Sealed {
            content: signed(Kind::Dcc, &dcc, seal)?,
            unsigned: Some(dcc.clone()),
            page: Some(dcc),
        }),
    };
    let dcc = dcc::render(certificate, language).ok();
    dcc.map(sealed).transpose()
}

/// The PDF that `render` makes with a DCC inside. One that is signed is rendered twice: as it is without any
/// signature, it is the same however often it is signed.
///
/// # Errors
/// [`Error::Input`] when a page of the laboratory's own became a PDF of another form; those of `render`.
pub(super) fn pdf(
    dcc: Option<&Sealed>,
    seal: Option<&Seal>,
    render: impl Fn(Option<&[u8]>) -> Result<Vec<u8>>,
) -> Result<Sealed> {
    let page = render(dcc.map(|dcc| &dcc.content[..]))?;
    let Some(seal) = seal else {
        return Ok(Sealed::plain(page));
    };
    Ok(Sealed {
        content: signed(Kind::Pdf, &page, seal)?,
        unsigned: Some(render(dcc.map(Sealed::unsigned))?),
        page: Some(page),
    })
}
