//! Influence quantities that differ from point to point: the one list.
//!
//! A quantity equal at every point is an [`Influence`](super::Influence). Here each quantity has a
//! coefficient, which is a setting, and a formula that makes of it the half-width at a point.

use super::Distribution;
use crate::point::PointResult;
use crate::reference::ReferenceSensitivity;
use crate::requirements::{TRANSVERSE_STEP_HZ, transverse_at};
use core::f32::consts::{FRAC_2_PI, SQRT_2, TAU};
use serde::{Deserialize, Serialize};

/// Names each coefficient once, with the largest value it may have.
macro_rules! coefficients {
    ($($(#[$meaning:meta])+ $name:ident: $most:expr;)+) => {
        /// Coefficients of the influence quantities that differ from point to point. 0 leaves one out of the
        /// budget.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
        #[serde(default, deny_unknown_fields)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        pub struct PointInfluences {
            $($(#[$meaning])+ pub $name: f32,)+
        }

        /// Name and largest value of each coefficient, in the order of [`PointInfluences::coefficients_mut`].
        const COEFFICIENTS: [(&str, f32); [$($most,)+].len()] = [$((stringify!($name), $most),)+];

        impl PointInfluences {
            /// No such influence.
            pub const NONE: Self = Self { $($name: 0.0,)+ };

            /// The coefficients in the order they are stored: a new one goes to the end.
            pub fn coefficients_mut(&mut self) -> [&mut f32; COEFFICIENTS.len()] {
                [$(&mut self.$name,)+]
            }
        }
    };
}

coefficients! {
    /// Relative motion of reference and device at 10 kHz, relative to the motion. The mounting between
    /// them is a spring: below its resonance the motion grows with the square of the frequency.
    relative_motion_at_10_khz_rel: f32::MAX;
    /// Largest step of the input converters' characteristic beside the line, V at the connector: where the
    /// largest bit turns, which is where signals swing. Counts where the front end adds no dither.
    converter_step_v: f32::MAX;
    /// Transverse sensitivity of both transducers together, relative: times the transverse motion of the exciter, or
    /// what Table 2 allows, 10 % to 1 kHz and 30 % above.
    transverse_sensitivity_rel: f32::MAX;
    /// Change of the sensitivity at 10 kHz by another torque, grease or cable, relative: the mounted resonance
    /// shifts, and below it the sensitivity follows with the square of the frequency.
    mounting_at_10_khz_rel: f32::MAX;
    /// Difference of the delays of both channels, s: filters of parts that are not alike.
    channel_delay_s: f32::MAX;
    /// Largest distance of the input converters' characteristic from the line, whatever its shape, V at the
    /// connector. Counts where the front end adds dither.
    converter_nonlinearity_v: f32::MAX;
    /// How far the dither of the front end reaches to either side at least, V at the connector; 0 for a front
    /// end without.
    dither_peak_v: f32::MAX;
    /// Largest transverse motion of the exciter to 1 kHz, relative to the intended one, as its maker or a measurement
    /// states it; 0: what Table 2 allows.
    transverse_motion_to_1_khz_rel: 1.0;
    /// Largest transverse motion of the exciter above 1 kHz, a rocking mode included, likewise.
    transverse_motion_above_1_khz_rel: 1.0;
}

/// Quantities of [`PointInfluences`]; what the converters do counts for each channel.
const AT_POINT: usize = 6;

/// Two values equally likely, as far apart as they can be: the half-width is the standard deviation.
const TWO_VALUES: Distribution = Distribution::Special { divisor: 1.0 };

/// Three quantities of unknown direction and size (Table D.1, note 3): sqrt(18).
const TRANSVERSE: Distribution = Distribution::Special {
    divisor: 4.242_640_7,
};

/// Contribution of a quantity at a point: a component of both budgets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtPoint {
    /// Row of Table A.1; that of Table A.2 follows from it.
    pub row: u8,
    /// Name in words.
    pub label: &'static str,
    /// Distribution of both.
    pub distribution: Distribution,
    /// Half-width of the magnitude, relative.
    pub half_width_rel: f32,
    /// Half-width of the phase, rad.
    pub half_width_phase_rad: f32,
}

impl PointInfluences {
    /// Contributions of the quantities at a point whose acceleration `reference` has told.
    pub fn at(&self, point: &PointResult, reference: &ReferenceSensitivity) -> [AtPoint; AT_POINT] {
        let [of_reference, of_dut] = self.converters(point, reference);
        [
            self.motion(point),
            of_reference,
            of_dut,
            self.transverse(point),
            self.mounting(point),
            self.delay(point),
        ]
    }

    fn motion(&self, point: &PointResult) -> AtPoint {
        let motion_rel = self.relative_motion_at_10_khz_rel * square_at_10_khz(point);
        AtPoint {
            row: 9,
            label: "relative motion, with the square of the frequency",
            distribution: Distribution::Rectangular,
            half_width_rel: motion_rel,
            // Of unknown phase, so that it may turn the sensitivity by as much.
            half_width_phase_rad: motion_rel,
        }
    }

    fn converters(&self, point: &PointResult, reference: &ReferenceSensitivity) -> [AtPoint; 2] {
        let peak_ms2 = SQRT_2 * point.acceleration_rms_ms2;
        let dithered = self.dither_peak_v > 0.0;
        let of = |sensitivity: f32, labels: [&'static str; 2]| {
            let peak_v = sensitivity.abs() * peak_ms2;
            let half_width_rel = match dithered {
                true => self.slope_rel(peak_v),
                false => FRAC_2_PI * self.converter_step_v / peak_v,
            };
            AtPoint {
                row: 3,
                label: labels[usize::from(dithered)],
                distribution: match dithered {
                    true => Distribution::Rectangular,
                    false => TWO_VALUES,
                },
                // Nothing where nothing was measured.
                half_width_rel: if half_width_rel.is_finite() && peak_v > 0.0 {
                    half_width_rel
                } else {
                    0.0
                },
                half_width_phase_rad: 0.0,
            }
        };
        [
            of(
                reference.sensitivity_v_per_ms2,
                [
                    "step in the middle of the converter's range, reference",
                    "linearity of the converter over its dither, reference",
                ],
            ),
            of(
                point.sensitivity_v_per_ms2,
                [
                    "step in the middle of the converter's range, device",
                    "linearity of the converter over its dither, device",
                ],
            ),
        ]
    }

    /// Largest change of the gain of a sine of `peak_v` by a characteristic within `I` of the line.
    ///
    /// # Equation
    /// Dither that takes every voltage within `A` of the signal equally often makes of any characteristic
    /// `e(x)` its mean over these, whose slope is `(e(x + A) - e(x - A)) / 2 A`: at most `I / A`, at any level
    /// and for any shape. A sine much larger than the dither meets `e` as it is, and a square wave of `I` has a
    /// fundamental of `4 I / pi`.
    fn slope_rel(&self, peak_v: f32) -> f32 {
        let of_dither = self.converter_nonlinearity_v / self.dither_peak_v;
        of_dither.min(2.0 * FRAC_2_PI * self.converter_nonlinearity_v / peak_v)
    }

    fn transverse(&self, point: &PointResult) -> AtPoint {
        let frequency_hz = point.spec.frequency_hz;
        let own_rel = if frequency_hz > TRANSVERSE_STEP_HZ {
            self.transverse_motion_above_1_khz_rel
        } else {
            self.transverse_motion_to_1_khz_rel
        };
        let (motion_rel, label) = if own_rel > 0.0 {
            (own_rel, "transverse motion of the exciter")
        } else {
            let allowed_rel = transverse_at(frequency_hz);
            (allowed_rel, "transverse motion as Table 2 allows it")
        };
        let half_width_rel = self.transverse_sensitivity_rel * motion_rel;
        AtPoint {
            row: 6,
            label,
            distribution: TRANSVERSE,
            half_width_rel,
            // Of unknown phase.
            half_width_phase_rad: half_width_rel,
        }
    }

    /// # Equation
    /// Below a resonance at `fm`, `S = S0 / (1 - (f/fm)^2)`: a shift by a part `s` of `fm` changes it by
    /// `2 s (f/fm)^2`, to first order, and the phase by as little as damping is.
    fn mounting(&self, point: &PointResult) -> AtPoint {
        AtPoint {
            row: 8,
            label: "mounted resonance by torque and grease",
            distribution: Distribution::Rectangular,
            half_width_rel: self.mounting_at_10_khz_rel * square_at_10_khz(point),
            half_width_phase_rad: 0.0,
        }
    }

    fn delay(&self, point: &PointResult) -> AtPoint {
        AtPoint {
            row: 3,
            label: "delay between the channels",
            distribution: Distribution::Rectangular,
            half_width_rel: 0.0,
            half_width_phase_rad: TAU * point.spec.frequency_hz * self.channel_delay_s,
        }
    }

    /// The first coefficient that is not finite, negative, or more transverse motion than there is along the axis.
    pub(super) fn impossible(mut self) -> Option<&'static str> {
        let coefficients = self.coefficients_mut();
        let mut named = coefficients.into_iter().zip(COEFFICIENTS);
        let wrong = named.find(|(value, (_, most))| !(0.0..=*most).contains(*value));
        wrong.map(|(_, (name, _))| name)
    }
}

/// Square of the frequency over that at 10 kHz.
fn square_at_10_khz(point: &PointResult) -> f32 {
    let ratio = point.spec.frequency_hz / 10_000.0;
    ratio * ratio
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::PointSpec;
    use crate::point_state::Reason;

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
            let [motion, ..] = influences.at(&point, &reference());
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

    fn point(frequency_hz: f32, acceleration_rms_ms2: f32) -> PointResult {
        let spec = PointSpec {
            frequency_hz,
            acceleration_rms_ms2,
        };
        PointResult {
            acceleration_rms_ms2,
            sensitivity_v_per_ms2: -0.01,
            ..PointResult::refused(spec, None, Reason::Stopped)
        }
    }

    /// 3 codes of 152.6 uV beside 0.1414 V: 0.637 * 0.458 mV / 0.1414 V; ten times as much at a tenth of the
    /// level. Two values have their half-width as standard deviation.
    #[test]
    fn a_step_of_the_converters_counts_more_at_low_levels() {
        let influences = PointInfluences {
            converter_step_v: 3.0 * 152.6e-6,
            ..PointInfluences::NONE
        };
        for (level_ms2, expected) in [(10.0, 0.002_06), (1.0, 0.020_6)] {
            let steps = influences.at(&point(160.0, level_ms2), &reference());
            for step in &steps[1..3] {
                assert!((step.half_width_rel / expected - 1.0).abs() < 1.0e-3);
                assert_eq!((step.row, step.half_width_phase_rad), (3, 0.0));
                assert_eq!(step.distribution.divisor(), 1.0);
            }
        }
        let mut silent = point(160.0, 10.0);
        silent.acceleration_rms_ms2 = 0.0;
        assert_eq!(influences.at(&silent, &reference())[1].half_width_rel, 0.0);
    }

    /// 10 codes of 152.6 uV over a dither of 7400: 0.1351 % at 10 and at 1 m/s2. A sine of 5 V leaves
    /// 4 / pi * 1.526 mV / 5 V.
    #[test]
    fn with_dither_the_converters_count_the_same_at_any_level() {
        let code_v = 152.6e-6;
        let influences = PointInfluences {
            converter_step_v: 3.0 * code_v,
            converter_nonlinearity_v: 10.0 * code_v,
            dither_peak_v: 7400.0 * code_v,
            ..PointInfluences::NONE
        };
        for (level_ms2, expected) in [(10.0, 1.351e-3), (1.0, 1.351e-3), (353.55, 3.886e-4)] {
            for at in &influences.at(&point(160.0, level_ms2), &reference())[1..3] {
                assert!((at.half_width_rel / expected - 1.0).abs() < 1.0e-3);
                assert_eq!((at.row, at.half_width_phase_rad), (3, 0.0));
                assert_eq!(at.distribution, Distribution::Rectangular);
            }
        }
        let mut silent = point(160.0, 10.0);
        silent.acceleration_rms_ms2 = 0.0;
        assert_eq!(influences.at(&silent, &reference())[1].half_width_rel, 0.0);
    }

    /// 5.39 % of 10 % and 30 %; 0.75 % and a hundredth of it; 2 pi 10 kHz 0.3 us = 18.85 mrad.
    #[test]
    fn transverse_motion_mounting_and_delay_grow_with_the_frequency() {
        let influences = PointInfluences {
            transverse_sensitivity_rel: 0.0539,
            mounting_at_10_khz_rel: 0.0075,
            channel_delay_s: 3.0e-7,
            ..PointInfluences::NONE
        };
        for (frequency_hz, transverse_rel, mounting_rel, delay_rad) in [
            (1000.0, 0.005_39, 7.5e-5, 1.885e-3),
            (10_000.0, 0.016_17, 7.5e-3, 18.85e-3),
        ] {
            let at = influences.at(&point(frequency_hz, 10.0), &reference());
            let [_, _, _, transverse, mounting, delay] = at;
            for (value, expected) in [
                (transverse.half_width_rel, transverse_rel),
                (transverse.half_width_phase_rad, transverse_rel),
                (mounting.half_width_rel, mounting_rel),
                (delay.half_width_phase_rad, delay_rad),
            ] {
                assert!(
                    (value / expected - 1.0).abs() < 1.0e-3,
                    "{value} {expected}"
                );
            }
            assert_eq!((transverse.row, mounting.row, delay.row), (6, 8, 3));
        }
    }

    /// 5.39 % of the 10 % and 30 % that Table 2 allows, or of the exciter's own 4 % and 12 %.
    #[test]
    fn the_exciters_own_transverse_motion_stands_in_for_table_2() {
        let table_2 = PointInfluences {
            transverse_sensitivity_rel: 0.0539,
            ..PointInfluences::NONE
        };
        let own = PointInfluences {
            transverse_motion_to_1_khz_rel: 0.04,
            transverse_motion_above_1_khz_rel: 0.12,
            ..table_2
        };
        for (frequency_hz, expected) in [
            (160.0, [0.005_39, 0.002_156]),
            (1_000.0, [0.005_39, 0.002_156]),
            (1_250.0, [0.016_17, 0.006_468]),
        ] {
            let of = |influences: &PointInfluences| {
                influences.at(&point(frequency_hz, 10.0), &reference())[3]
            };
            let both = [of(&table_2), of(&own)];
            for (found, expected) in both.iter().zip(expected) {
                assert!((found.half_width_rel / expected - 1.0).abs() < 1.0e-5);
                assert_eq!(found.half_width_phase_rad, found.half_width_rel);
                assert_eq!(found.row, 6);
            }
            assert_ne!(both[0].label, both[1].label);
        }
    }

    #[test]
    fn the_first_impossible_coefficient_is_named() {
        for (index, (name, most)) in COEFFICIENTS.into_iter().enumerate() {
            let beyond = (most < f32::MAX).then_some(10.0);
            for value in [-0.1, f32::NAN, f32::INFINITY].into_iter().chain(beyond) {
                let mut influences = PointInfluences::NONE;
                *influences.coefficients_mut()[index] = value;
                assert_eq!(influences.impossible(), Some(name), "{value}");
            }
        }
        assert_eq!(PointInfluences::NONE.impossible(), None);
    }
}
