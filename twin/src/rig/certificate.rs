//! Certificate of the reference's own calibration.

use serde::{Deserialize, Serialize};

use super::range::Range;

/// Uncertainty the certificate of the reference states (k = 2, normal).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    /// Relative expanded uncertainty of the magnitude, k = 2.
    pub expanded_uncertainty_rel: f64,
    /// Expanded uncertainty of the phase, rad, k = 2.
    pub expanded_uncertainty_phase_rad: f64,
}

impl Certificate {
    pub(super) fn ranges(&self) -> Vec<Range> {
        let range = |name: &str, value| Range::new(format!("certificate.{name}"), value, 0.0, 0.5);
        vec![
            range("expanded_uncertainty_rel", self.expanded_uncertainty_rel),
            range(
                "expanded_uncertainty_phase_rad",
                self.expanded_uncertainty_phase_rad,
            ),
        ]
    }
}
