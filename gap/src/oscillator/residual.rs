//! Measured against simulated output, sample by sample.

use super::model::VALUES;
use super::run::{REACH, Run};
use super::simulate::simulate;
use crate::dataset::Record;

/// Samples at the start that only settle the state.
pub(crate) const SETTLING: usize = 50;
/// Samples at the end beyond which the interpolation of the input would have to look.
const ENDING: usize = REACH;
/// Longest part of a record that is fitted.
const MOST_SAMPLES: usize = 20_000;

/// The part of a record that is fitted.
pub(crate) fn fitted_part(record: &Record) -> Record {
    let count = record.input.len().min(MOST_SAMPLES);
    Record {
        interval_s: record.interval_s,
        input: record.input[..count].to_vec(),
        output: record.output[..count].to_vec(),
    }
}

/// Measured minus simulated output after the settling samples; `None` where the simulation diverges.
pub(super) fn residual(values: &[f64; VALUES], record: &Run) -> Option<Vec<f64>> {
    let simulated = simulate(values, record)?;
    let both = compared(&record.output).iter().zip(compared(&simulated));
    Some(both.map(|(m, s)| m - s).collect())
}

/// The samples that are compared: the first settle the state, and at the last the input
/// that follows is not known.
pub(super) fn compared(values: &[f64]) -> &[f64] {
    let end = values.len().saturating_sub(ENDING).max(SETTLING);
    values
        .get(SETTLING..end.min(values.len()))
        .unwrap_or_default()
}

/// Root mean square.
pub(crate) fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|r| r * r).sum::<f64>() / values.len() as f64).sqrt()
}

/// Root mean square of the output.
pub(super) fn scale_of(record: &Run) -> f64 {
    rms(&record.output).max(f64::MIN_POSITIVE)
}
