//! Which part of a record is fitted, and which one is held out.

use super::residual::fitted_part;
use crate::dataset::{Dataset, Measured, Record};
use crate::error::GapError;

/// Share of a record, in quarters, that may be fitted where there is no other one.
const FITTED_QUARTERS: usize = 3;

/// The part to fit, and what takes no part: another record, or the last quarter of this one.
///
/// # Errors
/// `validate` holds points.
pub(super) fn parts(record: &Record, validate: Option<&Dataset>) -> Result<[Record; 2], GapError> {
    match validate.map(|v| &v.measured) {
        Some(Measured::Record(other)) => Ok([fitted_part(record), other.clone()]),
        Some(Measured::Points { .. }) => Err(GapError::Usage(
            "--validate needs a record of an oscillator too".into(),
        )),
        None => {
            let (at, end) = (record.input.len() * FITTED_QUARTERS / 4, record.input.len());
            Ok([fitted_part(&cut(record, 0, at)), cut(record, at, end)])
        }
    }
}

fn cut(record: &Record, from: usize, to: usize) -> Record {
    Record {
        interval_s: record.interval_s,
        input: record.input[from..to].to_vec(),
        output: record.output[from..to].to_vec(),
    }
}
