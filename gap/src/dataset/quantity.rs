//! A value with its standard uncertainty.

use serde::Deserialize;

/// A value and its standard uncertainty in the unit of the entry (0 = exact).
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Quantity {
    /// Best estimate.
    pub(crate) value: f64,
    /// Standard uncertainty.
    pub(crate) u: f64,
}

impl Quantity {
    /// Relative standard uncertainty.
    pub(crate) fn relative_u(self) -> f64 {
        self.u / self.value
    }
}
