//! Statements that no certificate may make: refused before a file is written.

use super::interval::{InForce, in_force};
use super::model::Certificate;
use super::particulars::Amendment;
use super::stored::run_day;
use super::substitution::{self, Standard};
use calib_files::{Error, Result};
use calib_protocol::record::Record;

/// Looks at days and at the reference's calibration.
///
/// # Errors
/// [`Error::Input`] when it would be issued before the calibration, states another day of
/// calibration than the record, replaces itself or another without a reason, or rests on a reference that was overdue and nobody said in
/// writing why it was used.
pub(super) fn check(certificate: &Certificate, record: &Record) -> Result<()> {
    let stated = &certificate.particulars.calibration;
    let refuse = |problem: String, hint: &str| {
        let place = format!("certificate {}", certificate.number);
        Err(Error::input(place, problem, hint))
    };
    if let Some((problem, hint)) = stated.replaces.as_ref().and_then(|a| wrong(a, certificate)) {
        return refuse(problem.to_owned(), hint);
    }
    let run = run_day(record);
    if let (Some(run), Some(date)) = (run, stated.date)
        && run != date
    {
        return refuse(
            format!("states {date} as day of calibration, the record says {run}"),
            "leave `date` out of [calibration]",
        );
    }
    if let (Some(calibrated), Some(issued)) = (certificate.day, stated.issued)
        && issued < calibrated
    {
        return refuse(
            format!("would be issued on {issued}, before the calibration on {calibrated}"),
            "correct `issued` under [calibration]",
        );
    }
    let standing = in_force(record, &certificate.particulars, certificate.day);
    if let (InForce::Overdue { due }, Some(run)) = (standing, certificate.day)
        && stated.overdue_reference.is_none()
    {
        return refuse(
            format!("rests on a reference whose calibration was due on {due}, before {run}"),
            "calibrate the reference; or check it by `calib selfcheck`, where [reference_interval] allows that; or \
             state in writing why it may be used, as `overdue_reference` under [calibration], which the certificate \
             prints",
        );
    }
    Ok(())
}

/// Looks at the term of the standard of a substitution, as [`check`] at the reference's.
///
/// # Errors
/// As there.
pub(super) fn overdue_standard(certificate: &Certificate, standard: &Standard) -> Result<()> {
    let stated = &certificate.particulars.calibration.overdue_reference;
    match substitution::overdue(certificate, standard).filter(|_| stated.is_none()) {
        None => Ok(()),
        Some(due) => Err(Error::input(
            format!("certificate {}", certificate.number),
            format!("rests on a standard whose calibration was due on {due}"),
            "calibrate the standard, or state in writing why it may be used, as `overdue_reference` under [calibration], \
             which the certificate prints",
        )),
    }
}

/// Problem of an amendment, and the way out.
fn wrong(amended: &Amendment, certificate: &Certificate) -> Option<(&'static str, &'static str)> {
    if amended.certificate.trim() == certificate.number.trim() {
        return Some((
            "would replace itself",
            "give the new one a `number` of its own under [calibration]",
        ));
    }
    let stated = [&amended.certificate, &amended.reason];
    stated
        .iter()
        .any(|words| words.trim().is_empty())
        .then_some((
            "replaces another, and its number or the reason is not stated",
            "state both: replaces = { certificate = \"...\", reason = \"...\" }",
        ))
}
