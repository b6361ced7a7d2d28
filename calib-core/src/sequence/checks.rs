//! The checks of a measured point: Table 2, and what noise and hum do to the result.

use crate::point_state::{PointState, Reason};
use crate::requirements::{Attainable, VibrationGeneration};
use crate::settings::Example;
use core::f32::consts::SQRT_2;

/// Least signal over residual of the device under test, dB: below, its noise
/// is more than a third of its signal and cannot be called a disturbance.
const MIN_DUT_SIGNAL_TO_NOISE_DB: f32 = 10.0;

/// Distortion of the device under test beyond that of the motion: its response
/// may rise towards the harmonics by a half, and 3 % are a clear overload. A sine
/// clipped that much has lost 2 % of its fundamental.
const DUT_DISTORTION_FACTOR: f32 = 1.5;
const DUT_DISTORTION_REL: f32 = 0.03;

/// Measured values the checks judge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Nominal frequency, Hz.
    pub frequency_hz: f32,
    /// Frequency played, relative to nominal, less 1.
    pub frequency_deviation_rel: f32,
    /// Any channel clipped.
    pub clipped: bool,
    /// Total harmonic distortion of the acceleration, 1.
    pub distortion_rel: f32,
    /// Total harmonic distortion of the device under test, 1.
    pub dut_distortion_rel: f32,
    /// Standard deviation of the mean sensitivity over the blocks, relative.
    pub repeatability_rel: f32,
    /// Amplitude of what the mains may still do to the sensitivity, relative.
    pub hum_rel: f32,
    /// Signal to residual of the device under test in its worst block, dB.
    pub dut_signal_to_noise_db: f32,
    /// Largest relative change of the amplitude while measuring.
    pub amplitude_stability_rel: f32,
}

/// Judges a point: the first check that fails gives the reason.
///
/// Noise and hum are judged by what they do to the result: the correlation keeps most of them out of it, and
/// what is left is in the budget. Where that alone is more (`k = 2`) than Table 1 holds attainable, a point
/// is refused. The limit of Table 2 for noise below full output is stated by `calib check`, and by itself
/// refuses nothing.
///
/// # Source
/// ISO 16063-21:2003, Tables 1 and 2.
pub fn judge(example: Example, measured: &Measured) -> PointState {
    let table = VibrationGeneration::of(example);
    let frequency_hz = measured.frequency_hz;
    let table1 = Attainable::of(example);
    let attainable_rel = table1.accelerometer_at(frequency_hz);
    let attainable_rel = attainable_rel.unwrap_or(table1.to_10_khz_rel);
    // Written so that a value that is not a number fails.
    let passes = [
        (!measured.clipped, Reason::Clipped),
        (
            measured.frequency_deviation_rel.abs() <= table.frequency_rel,
            Reason::FrequencyDeviation,
        ),
        (
            measured.amplitude_stability_rel <= table.amplitude_stability_rel,
            Reason::AmplitudeUnstable,
        ),
        (
            measured.distortion_rel <= table.distortion_at(frequency_hz),
            Reason::Distortion,
        ),
        // Before the device's harmonics: in the noise of a loose contact there are some.
        (
            2.0 * measured.repeatability_rel <= attainable_rel
                && measured.dut_signal_to_noise_db >= MIN_DUT_SIGNAL_TO_NOISE_DB,
            Reason::SignalToNoise,
        ),
        (
            measured.dut_distortion_rel
                <= DUT_DISTORTION_FACTOR * measured.distortion_rel + DUT_DISTORTION_REL,
            Reason::DutDistortion,
        ),
        // Of a sine of unknown phase u is the amplitude over sqrt(2).
        (SQRT_2 * measured.hum_rel <= attainable_rel, Reason::Hum),
    ];
    let failed = passes.into_iter().find(|(pass, _)| !pass);
    failed.map_or(PointState::Valid, |(_, reason)| PointState::Refused(reason))
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: Measured = Measured {
        frequency_hz: 160.0,
        frequency_deviation_rel: 0.0,
        clipped: false,
        distortion_rel: 0.01,
        dut_distortion_rel: 0.01,
        repeatability_rel: 1.0e-4,
        hum_rel: 0.0,
        dut_signal_to_noise_db: 50.0,
        amplitude_stability_rel: 0.0005,
    };

    fn reason(example: Example, measured: Measured) -> Option<Reason> {
        match judge(example, &measured) {
            PointState::Valid => None,
            PointState::Refused(reason) => Some(reason),
        }
    }

    #[test]
    fn harmonics_in_noise_are_noise() {
        let loose_contact = Measured {
            dut_distortion_rel: 0.4,
            dut_signal_to_noise_db: 5.0,
            ..GOOD
        };
        let told = reason(Example::Example2, loose_contact);
        assert_eq!(told, Some(Reason::SignalToNoise));
    }

    #[test]
    fn each_requirement_refuses_its_own_excess() {
        use Example::{Example1, Example2};
        let stability = |value| Measured {
            amplitude_stability_rel: value,
            ..GOOD
        };
        let distortion = |frequency_hz, value| Measured {
            frequency_hz,
            distortion_rel: value,
            ..GOOD
        };
        let noise = |frequency_hz, value| Measured {
            frequency_hz,
            repeatability_rel: value,
            ..GOOD
        };
        let hum = |frequency_hz, value| Measured {
            frequency_hz,
            hum_rel: value,
            ..GOOD
        };
        // 1.5 times the 1 % of the motion and 3 % are 4.5 %.
        let saturated = |value| Measured {
            dut_distortion_rel: value,
            ..GOOD
        };
        let cases = [
            (Example1, GOOD, None),
            (Example1, stability(0.0011), Some(Reason::AmplitudeUnstable)),
            (Example2, stability(0.0011), None),
            (Example2, stability(0.0031), Some(Reason::AmplitudeUnstable)),
            (Example1, distortion(160.0, 0.06), Some(Reason::Distortion)),
            (Example2, distortion(160.0, 0.06), None),
            (Example1, distortion(16.0, 0.06), None),
            (Example2, distortion(16.0, 0.21), Some(Reason::Distortion)),
            // Table 1: 1 % and 3 % to 1 kHz, 3 % and 10 % at 10 kHz, all for k = 2.
            (Example1, noise(160.0, 0.0051), Some(Reason::SignalToNoise)),
            (Example1, noise(160.0, 0.0049), None),
            (Example2, noise(160.0, 0.0151), Some(Reason::SignalToNoise)),
            (Example2, noise(10_000.0, 0.0151), None),
            (Example1, hum(50.0, 0.0072), Some(Reason::Hum)),
            (Example2, hum(50.0, 0.0208), None),
            (Example2, hum(50.0, 0.0216), Some(Reason::Hum)),
            (Example2, saturated(0.044), None),
            (Example2, saturated(0.046), Some(Reason::DutDistortion)),
        ];
        for (example, measured, expected) in cases {
            assert_eq!(reason(example, measured), expected, "{measured:?}");
        }
    }

    #[test]
    fn what_is_not_a_number_never_passes() {
        let measured = Measured {
            distortion_rel: f32::NAN,
            ..GOOD
        };
        assert_eq!(
            reason(Example::Example2, measured),
            Some(Reason::Distortion)
        );
        let clipped = Measured {
            clipped: true,
            ..GOOD
        };
        assert_eq!(reason(Example::Example2, clipped), Some(Reason::Clipped));
    }
}
