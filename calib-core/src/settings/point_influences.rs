//! Influence quantities that differ from point to point: the one list.
//!
//! A quantity equal at every point is an [`Influence`](super::Influence). Here each quantity has a
//! coefficient, which is a setting, and a formula that makes of it the half-width at a point.

use crate::point::PointResult;
use crate::reference::ReferenceSensitivity;
use core::f32::consts::{FRAC_2_PI, SQRT_2};
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
    /// Largest step of the input converters' characteristic beside the line, V at the connector: where the
    /// largest bit turns, which is where signals swing.
    pub converter_step_v: f32,
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
        converter_step_v: 0.0,
    };

    /// The coefficients in the order they are stored: a new one goes to the end.
    pub fn coefficients_mut(&mut self) -> [&mut f32; 2] {
        [
            &mut self.relative_motion_at_10_khz_rel,
            &mut self.converter_step_v,
        ]
    }

    /// Contributions of the quantities at a point whose acceleration `reference` has told.
    pub fn at(&self, point: &PointResult, reference: &ReferenceSensitivity) -> [AtPoint; 2] {
        [self.motion(point), self.converter_step(point, reference)]
    }

    fn motion(&self, point: &PointResult) -> AtPoint {
        let ratio = point.spec.frequency_hz / 10_000.0;
        let motion_rel = self.relative_motion_at_10_khz_rel * ratio * ratio;
        AtPoint {
            row: 9,
            label: "relative motion, with the square of the frequency",
            half_width_rel: motion_rel,
            // Of unknown phase, so that it may turn the sensitivity by as much.
            half_width_phase_rad: motion_rel,
        }
    }

    /// # Equation
    /// A step `d` in the middle of a sine is a square of `d/2` beside it, whose fundamental is `2 d / pi`
    /// and in phase. Either channel may have it, in either direction: `2 d / pi (1/X1 + 1/X2)` with the
    /// amplitudes at the inputs.
    fn converter_step(&self, point: &PointResult, reference: &ReferenceSensitivity) -> AtPoint {
        let peak_ms2 = SQRT_2 * point.acceleration_rms_ms2;
        let channels = [reference.sensitivity_v_per_ms2, point.sensitivity_v_per_ms2];
        let inverse_per_v: f32 = channels.iter().map(|s| 1.0 / (s.abs() * peak_ms2)).sum();
        let half_width_rel = FRAC_2_PI * self.converter_step_v * inverse_per_v;
        AtPoint {
            row: 3,
            label: "step in the middle of the converters' range",
            // Nothing where nothing was measured.
            half_width_rel: if half_width_rel.is_finite() {
                half_width_rel
            } else {
                0.0
            },
            half_width_phase_rad: 0.0,
        }
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
            ..PointInfluences::NONE
        };
        for (frequency_hz, expected) in [(10_000.0, 0.02), (1000.0, 2.0e-4), (100.0, 2.0e-6)] {
            let spec = PointSpec {
                frequency_hz,
                acceleration_rms_ms2: 10.0,
            };
            let point = PointResult::refused(spec, None, Reason::Stopped);
            let [motion, _] = influences.at(&point, &reference());
            // Four roundings of f32.
            assert!((motion.half_width_rel / expected - 1.0).abs() < 4.0 * f32::EPSILON);
            assert_eq!(motion.half_width_phase_rad, motion.half_width_rel);
            let none = PointInfluences::NONE.at(&point, &reference());
            assert!(none.iter().all(|none| none.half_width_rel == 0.0));
        }
    }

    fn reference() -> ReferenceSensitivity {
        ReferenceSensitivity {
            sensitivity_v_per_ms2: 0.01,
            phase_rad: 0.0,
            expanded_uncertainty_rel: 0.005,
            expanded_uncertainty_phase_rad: 0.01,
            interpolation_rel: 0.0,
            interpolation_phase_rad: 0.0,
        }
    }

    /// 3 codes of 152.6 uV beside 0.1414 V in either channel: 0.637 * 0.458 mV / 0.1414 V, twice; ten times
    /// as much at a tenth of the level.
    #[test]
    fn a_step_of_the_converters_counts_more_at_low_levels() {
        let influences = PointInfluences {
            converter_step_v: 3.0 * 152.6e-6,
            ..PointInfluences::NONE
        };
        for (level_ms2, expected) in [(10.0, 0.004_12), (1.0, 0.041_2)] {
            let spec = PointSpec {
                frequency_hz: 160.0,
                acceleration_rms_ms2: level_ms2,
            };
            let mut point = PointResult::refused(spec, None, Reason::Stopped);
            assert_eq!(influences.at(&point, &reference())[1].half_width_rel, 0.0);
            point.acceleration_rms_ms2 = level_ms2;
            point.sensitivity_v_per_ms2 = -0.01;
            let [_, step] = influences.at(&point, &reference());
            assert!((step.half_width_rel / expected - 1.0).abs() < 1.0e-3);
            assert_eq!((step.row, step.half_width_phase_rad), (3, 0.0));
        }
    }

    #[test]
    fn a_coefficient_below_zero_or_not_finite_is_not_valid() {
        for (coefficient, valid) in [(0.0, true), (0.1, true), (-0.1, false), (f32::NAN, false)] {
            let influences = PointInfluences {
                relative_motion_at_10_khz_rel: coefficient,
                ..PointInfluences::NONE
            };
            assert_eq!(influences.is_valid(), valid, "{coefficient}");
        }
    }
}
