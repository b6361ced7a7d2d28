//! Limits of a quantity.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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

    /// True when the value lies outside; never of limits that are no numbers.
    pub(super) fn excludes(self, value: f64) -> bool {
        value < self.lower || value > self.upper
    }

    pub(super) fn narrowed(self, by: f64) -> Self {
        Self {
            lower: self.lower + by,
            upper: self.upper - by,
        }
    }

    /// True when some value lies inside; limits around a base nobody knows hold none.
    pub(super) fn hold_something(self) -> bool {
        self.lower <= self.upper
    }

    pub(super) fn middle(self) -> f64 {
        f64::midpoint(self.lower, self.upper)
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

impl Band {
    pub(super) fn is_ordered(&self) -> bool {
        self.from_hz > 0.0
            && self.from_hz <= self.to_hz
            && self.lower_percent < self.upper_percent
            && self.lower_percent > -100.0
            && self.upper_percent.is_finite()
    }

    /// True when the limits are the same number on both sides.
    pub(crate) fn is_symmetric(&self) -> bool {
        self.lower_percent == -self.upper_percent
    }

    /// True when no range of frequencies was stated.
    pub(crate) fn is_everywhere(&self) -> bool {
        self.from_hz == f64::MIN_POSITIVE
    }

    /// A nominal 10 Hz is played within 0.01 % of it.
    pub(super) fn applies(&self, frequency_hz: f64, at_reference_point: bool) -> bool {
        let inside = (self.from_hz * 0.999..=self.to_hz * 1.001).contains(&frequency_hz);
        inside && (at_reference_point || !self.reference_point_only)
    }

    pub(super) fn around(&self, base: f64) -> Limits {
        Limits {
            lower: base * (1.0 + self.lower_percent / 100.0),
            upper: base * (1.0 + self.upper_percent / 100.0),
        }
    }
}

/// Base of a tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Base {
    /// The nominal sensitivity.
    Nominal,
    /// The sensitivity measured at the reference point.
    Reference,
    /// The sensitivity of the last calibration at the same frequency.
    Last,
}
