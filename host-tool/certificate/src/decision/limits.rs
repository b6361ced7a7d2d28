//! Limits of a quantity.

use serde::Deserialize;

/// Limits of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Lower limit.
    pub lower: f64,
    /// Upper limit.
    pub upper: f64,
}

impl Limits {
    pub(super) fn contain(self, value: f64) -> bool {
        (self.lower..=self.upper).contains(&value)
    }

    pub(super) fn narrowed(self, by: f64) -> Self {
        Self {
            lower: self.lower + by,
            upper: self.upper - by,
        }
    }
}

/// A tolerance over a range of frequencies.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Band {
    /// Lowest frequency, Hz.
    pub from_hz: f64,
    /// Highest frequency, Hz.
    pub to_hz: f64,
    /// Base of the tolerance.
    pub base: Base,
    /// Lower limit, %, such as -5.
    pub lower_percent: f64,
    /// Upper limit, %, such as 5.
    pub upper_percent: f64,
    /// True when only the reference point is judged by it.
    #[serde(default)]
    pub reference_point_only: bool,
}

/// Base of a tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Base {
    /// The nominal sensitivity.
    Nominal,
    /// The sensitivity measured at the reference point.
    Reference,
}
