//! Check standards that speak against a certificate (ISO/IEC 17025, 7.7.1 and 7.10).

use super::model::{Certificate, Remark, Severity, Value};
use super::particulars::ReferenceCheck;
use calib_files::{Error, Result};
use jiff::civil::Date;

/// A check standard that was out of control or not measured in time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FailedCheck {
    /// Its serial number.
    pub serial: String,
    /// Problem that speaks against the instrument.
    pub problem: CheckProblem,
}

/// Problem that a check standard shows, with the day of the result meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CheckProblem {
    /// This result does not belong to those before it, or does not agree with its certificate.
    OutOfControl(Date),
    /// Its last result before the calibration is too old.
    Overdue(Date),
    /// It was not measured with this instrument before the calibration.
    Never,
}

impl ReferenceCheck {
    /// Remark about it: for information, unless it speaks against the reference.
    pub(super) fn remark(&self) -> Remark {
        let percent = |value: f64| Value::Number(100.0 * value, 2, "%");
        let (severity, key) = match (self.significant, self.since_baseline) {
            (false, true) => (Severity::Note, "reference_checked"),
            (false, false) => (Severity::Note, "reference_agrees"),
            (true, true) => (Severity::Error, "reference_changed"),
            (true, false) => (Severity::Error, "reference_differs"),
        };
        let method = match self.by_gravity {
            true => "check.gravity",
            false => "check.reciprocity",
        };
        Remark {
            severity,
            key,
            values: vec![
                Value::Day(self.day),
                percent(self.change_rel),
                percent(self.expanded_rel),
                Value::Phrase(method.to_owned(), Vec::new()),
            ],
        }
    }
}

/// States the check of the reference, every check that failed, and who overrode them.
///
/// # Errors
/// [`Error::Input`] when one failed and nobody said in writing why the certificate is issued.
pub(super) fn attach(certificate: &mut Certificate, failed: &[FailedCheck]) -> Result<()> {
    let check = certificate.particulars.reference_check;
    certificate
        .remarks
        .extend(check.map(|check| check.remark()));
    let standards = failed.first().map(|first| {
        let problem = format!("check standard {} {}", first.serial, first.problem.words());
        (problem, "`calib run` and `calib assure` it")
    });
    let reference = check.filter(|check| check.significant).map(|check| {
        let problem = format!(
            "the reference is not what it was, by the check of {}",
            check.day
        );
        (
            problem,
            "`calib selfcheck` it once more, and have it calibrated",
        )
    });
    let Some((problem, remedy)) = standards.or(reference) else {
        return Ok(());
    };
    let stated = &certificate.particulars.calibration.check_override;
    let Some(why) = stated.clone().filter(|why| !why.trim().is_empty()) else {
        return Err(Error::input(
            format!("certificate {}", certificate.number),
            problem,
            format!(
                "{remedy}; or state in writing why a certificate may be issued, as `check_override` under \
                 [calibration], which the certificate prints"
            ),
        ));
    };
    certificate.remarks.extend(failed.iter().map(remark));
    certificate.remarks.push(Remark {
        severity: Severity::Warning,
        key: "check_override",
        values: vec![Value::Text(why)],
    });
    Ok(())
}

impl CheckProblem {
    fn words(self) -> String {
        match self {
            Self::OutOfControl(day) => format!("is out of control by its result of {day}"),
            Self::Overdue(day) => format!("was overdue: last measured on {day}"),
            Self::Never => "was not measured with this instrument before".to_owned(),
        }
    }
}

fn remark(failed: &FailedCheck) -> Remark {
    let serial = Value::Text(failed.serial.clone());
    let (key, values) = match failed.problem {
        CheckProblem::OutOfControl(day) => ("check_out_of_control", vec![serial, Value::Day(day)]),
        CheckProblem::Overdue(day) => ("check_overdue", vec![serial, Value::Day(day)]),
        CheckProblem::Never => ("check_never", vec![serial]),
    };
    Remark {
        severity: Severity::Error,
        key,
        values,
    }
}
