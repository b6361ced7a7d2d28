//! Parts a DCC needs.

use crate::model::Certificate;
use calib_files::{Error, Result};
use jiff::civil::Date;

/// Parts a DCC needs beside the results.
#[derive(Clone, Copy)]
pub(crate) struct Needs<'a> {
    /// First and last day the calibration can be of.
    pub(super) days: (Date, Date),
    /// Country of the laboratory.
    pub(super) country: &'a str,
}

/// Looks for what a DCC cannot be without.
///
/// # Errors
/// [`Error::Input`] that names what is missing, and where it is stated.
pub(crate) fn needs(certificate: &Certificate) -> Result<Needs<'_>> {
    let missing = |what: &str, hint: &str| {
        let place = format!("certificate {}", certificate.number);
        let problem = format!("has no {what}, and a digital calibration certificate must have one");
        Error::input(place, problem, hint)
    };
    let day = certificate.day.map(|day| (day, day));
    let days = day.or(certificate.between).ok_or_else(|| {
        let hint = "state `date` under [calibration] in a file given with --particulars";
        missing("date", hint)
    })?;
    let country = certificate.particulars.laboratory.country.as_deref();
    let country = country.ok_or_else(|| {
        let hint = "state `country`, two letters, under [laboratory] in the file of the \
                    laboratory, or in one given with --particulars";
        missing("country of the laboratory", hint)
    })?;
    Ok(Needs { days, country })
}
