//! Digital calibration certificate, PTB's DCC 3.3.0.
//!
//! The order of elements is that of the schema and is written by hand: it is
//! strict, and a reader can compare this file with `dcc.xsd` line by line.
//! Units are D-SI. Lists hold the points that have a result; points that were
//! refused are named in words.
//!
//! # Source
//! DCC schema 3.3.0 (PTB, gitlab.com/ptb/dcc), D-SI 2.2.1.

mod administrative;
mod results;
mod xml;

use super::model::Certificate;
use super::words::Language;
use crate::{Error, Result};
use xml::Xml;

/// What keeps the DCC from being accepted by PTB's business rules, and the way
/// out; `None` when nothing does.
pub(super) fn missing(certificate: &Certificate) -> Option<&'static str> {
    let country = administrative::country(&certificate.particulars.laboratory);
    country.is_none().then_some(
        "the DCC names no country of the laboratory, and strict readers refuse it: \
         state country = \"DE\" or yours under [laboratory] in a file given with --particulars",
    )
}

/// The certificate as DCC XML.
///
/// # Errors
/// [`Error::Input`] when the day of calibration is neither in the record nor
/// stated: a DCC cannot be without.
pub(super) fn render(certificate: &Certificate, language: Language) -> Result<Vec<u8>> {
    let day = certificate.day.ok_or_else(|| {
        Error::input(
            format!("record of certificate {}", certificate.number),
            "has no date, and a digital calibration certificate must have one",
            "state `date` under [calibration] in a file given with --particulars",
        )
    })?;
    let mut xml = Xml::new();
    let root = [
        ("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"),
        ("xmlns:dcc", "https://ptb.de/dcc"),
        ("xmlns:si", "https://ptb.de/si"),
        (
            "xsi:schemaLocation",
            "https://ptb.de/dcc https://ptb.de/dcc/v3.3.0/dcc.xsd",
        ),
        ("schemaVersion", "3.3.0"),
    ];
    xml.with("dcc:digitalCalibrationCertificate", &root, |xml| {
        administrative::write(xml, certificate, day, language);
        results::write(xml, certificate, language);
    });
    Ok(xml.finish())
}
