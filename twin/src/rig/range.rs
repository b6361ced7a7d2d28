//! A value of a rig and its range, and what is said when it lies outside.

use super::error::RigError;

/// A value and where it may lie.
pub(super) struct Range {
    pub(super) parameter: String,
    pub(super) value: f64,
    pub(super) lowest: f64,
    pub(super) highest: f64,
}

impl Range {
    /// `lowest <= value <= highest`.
    pub(super) fn new(parameter: impl Into<String>, value: f64, lowest: f64, highest: f64) -> Self {
        Self {
            parameter: parameter.into(),
            value,
            lowest,
            highest,
        }
    }

    /// # Errors
    /// [`RigError::OutOfRange`] when the value lies outside, or is no number.
    pub(super) fn check(&self, file: &str) -> Result<(), RigError> {
        // NaN is in no range.
        if (self.lowest..=self.highest).contains(&self.value) {
            return Ok(());
        }
        Err(RigError::OutOfRange {
            file: file.to_owned(),
            parameter: self.parameter.clone(),
            value: self.value,
            range: format!("from {} to {}", self.lowest, self.highest),
        })
    }
}
