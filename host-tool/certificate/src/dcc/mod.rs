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
use calib_files::{Error, Result};
use jiff::civil::Date;
use xml::Xml;

/// The certificate as DCC XML.
///
/// # Errors
/// [`Error::Input`] when the day of calibration is neither in the record nor
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

/// What a DCC cannot be without, beside the results.
#[derive(Clone, Copy)]
pub(super) struct Needs<'a> {
    /// Day of calibration.
    day: Date,
    /// Country of the laboratory.
    country: &'a str,
}

/// Looks for it.
///
/// # Errors
/// [`Error::Input`] that names what is missing, and where it is stated.
pub(super) fn needs(certificate: &Certificate) -> Result<Needs<'_>> {
    let missing = |what: &str, hint: &str| {
        let place = format!("certificate {}", certificate.number);
        let problem = format!("has no {what}, and a digital calibration certificate must have one");
        Error::input(place, problem, hint)
    };
    let day = certificate.day.ok_or_else(|| {
        let hint = "state `date` under [calibration] in a file given with --particulars";
        missing("date", hint)
    })?;
    let country = certificate.particulars.laboratory.country.as_deref();
    let country = country.ok_or_else(|| {
        let hint = "state `country`, two letters, under [laboratory] in the file of the \
                    laboratory, or in one given with --particulars";
        missing("country of the laboratory", hint)
    })?;
    Ok(Needs { day, country })
}
