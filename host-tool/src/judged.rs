//! What a certificate states and is judged by: the files of the laboratory and the job,
//! completed by what the logbook knows of the sensor. Every verb and the page ask here.

use crate::Result;
use calib_certificate::{Certificate, Known, Language, Particulars, Verdict};
use calib_logbook::Logbook;
use calib_protocol::record::{Record, RunLabels};
use std::path::PathBuf;

/// Statements for the certificate of a run with these labels.
///
/// # Errors
/// [`crate::Error::Files`] when a file states nonsense, or the tolerance needs a nominal
/// sensitivity that nobody stated.
pub fn particulars(
    files: &[PathBuf],
    labels: &RunLabels,
    logbook: Option<&Logbook>,
) -> Result<Particulars> {
    let mut particulars = Particulars::read(files)?;
    let known = match logbook {
        Some(logbook) => logbook.known(&labels.dut_serial, labels.unix_time_s)?,
        None => Known::default(),
    };
    particulars.for_device(&known)?;
    Ok(particulars)
}

/// The verdict on a record, if a tolerance was stated.
pub fn verdict(record: &Record, particulars: &Particulars) -> Option<Verdict> {
    let language = particulars.language.unwrap_or(Language::En);
    Certificate::from_record(record, particulars).verdict(language)
}
