//! Influence quantities that differ from point to point: the one list.
//!
//! A quantity equal at every point is an [`Influence`](super::Influence). Here each quantity has a
//! coefficient, which is a setting, and a formula that makes of it the half-width at a point.

use crate::point::PointResult;
use serde::{Deserialize, Serialize};

/// Coefficients of the influence quantities that differ from point to point. 0 leaves one out of the
/// budget.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PointInfluences {
    /// Relative motion of reference and device at 10 kHz, relative to the motion. The mounting between
    /// them is a spring: below its resonance the motion grows with the square of the frequency.
    pub relative_motion_at_10_khz_rel: f32,
}

/// Contribution of a quantity at a point: a component of rectangular distribution in both budgets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtPoint {
    /// Row of Table A.1; that of Table A.2 follows from it.
    pub row: u8,
    /// Name in words.
    pub label: &'static str,
    /// Half-width of the magnitude, relative.
    pub half_width_rel: f32,
    /// Half-width of the phase, rad.
    pub half_width_phase_rad: f32,
}

impl PointInfluences {
    /// No such influence.
    pub const NONE: Self = Self {
        relative_motion_at_10_khz_rel: 0.0,
    };

    /// The coefficients in the order they are stored: a new one goes to the end.
    pub fn coefficients_mut(&mut self) -> [&mut f32; 1] {
        [&mut self.relative_motion_at_10_khz_rel]
    }

    /// Contributions of the quantities at a point.
    pub fn at(&self, point: &PointResult) -> [AtPoint; 1] {
        let ratio = point.spec.frequency_hz / 10_000.0;
        let motion_rel = self.relative_motion_at_10_khz_rel * ratio * ratio;
        [AtPoint {
            row: 9,
            label: "relative motion, with the square of the frequency",
            half_width_rel: motion_rel,
            // Of unknown phase, so that it may turn the sensitivity by as much.
            half_width_phase_rad: motion_rel,
        }]
    }

    /// Whether every coefficient is finite and not negative.
    pub(super) fn is_valid(mut self) -> bool {
        let coefficients = self.coefficients_mut();
        coefficients
            .iter()
            .all(|value| value.is_finite() && **value >= 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::PointSpec;
    use crate::verdict::Reason;

    #[test]
    fn relative_motion_grows_with_the_square_of_the_frequency() {
        let influences = PointInfluences {
            relative_motion_at_10_khz_rel: 0.02,
        };
        for (frequency_hz, expected) in [(10_000.0, 0.02), (1000.0, 2.0e-4), (100.0, 2.0e-6)] {
            let spec = PointSpec {
                frequency_hz,
                acceleration_rms_ms2: 10.0,
            };
            let point = PointResult::refused(spec, None, Reason::Stopped);
            let [motion] = influences.at(&point);
            // Four roundings of f32.
            assert!((motion.half_width_rel / expected - 1.0).abs() < 4.0 * f32::EPSILON);
            assert_eq!(motion.half_width_phase_rad, motion.half_width_rel);
            let [none] = PointInfluences::NONE.at(&point);
            assert_eq!(none.half_width_rel, 0.0);
        }
    }

    #[test]
    fn a_coefficient_below_zero_or_not_finite_is_not_valid() {
        for (coefficient, valid) in [(0.0, true), (0.1, true), (-0.1, false), (f32::NAN, false)] {
            let influences = PointInfluences {
                relative_motion_at_10_khz_rel: coefficient,
            };
            assert_eq!(influences.is_valid(), valid, "{coefficient}");
        }
    }
}
