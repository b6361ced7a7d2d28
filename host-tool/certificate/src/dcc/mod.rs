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
mod needs;
mod results;
mod xml;

use super::model::Certificate;
use super::words::Language;
use calib_files::Result;
use xml::Xml;

pub(super) use needs::needs;

/// The certificate as DCC XML.
///
/// # Errors
/// [`calib_files::Error::Input`] when the day of calibration is neither in the record nor
/// stated, or the laboratory states no country: a DCC cannot be without.
pub(super) fn render(certificate: &Certificate, language: Language) -> Result<Vec<u8>> {
    let needs = needs(certificate)?;
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
        administrative::write(xml, certificate, needs, language);
        results::write(xml, certificate, language);
    });
    Ok(xml.finish())
}
