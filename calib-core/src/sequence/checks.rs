//! The checks of a measured point against Table 2.

use crate::requirements::VibrationGeneration;
use crate::settings::Example;
use crate::verdict::{Reason, Verdict};

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
    /// Residual of the reference below the exciter's full output, dB.
    pub noise_below_full_db: f32,
    /// Signal to residual of the device under test in its worst block, dB.
    pub dut_signal_to_noise_db: f32,
    /// Largest relative change of the amplitude while measuring.
    pub amplitude_stability_rel: f32,
}

/// Judges a point: the first check that fails gives the reason.
///
/// # Source
/// ISO 16063-21:2003, Table 2.
pub fn judge(example: Example, measured: &Measured) -> Verdict {
    let table = VibrationGeneration::of(example);
    let frequency_hz = measured.frequency_hz;
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
        (
            measured.dut_distortion_rel
                <= DUT_DISTORTION_FACTOR * measured.distortion_rel + DUT_DISTORTION_REL,
            Reason::DutDistortion,
        ),
        (
            measured.noise_below_full_db >= table.noise_at(frequency_hz)
                && measured.dut_signal_to_noise_db >= MIN_DUT_SIGNAL_TO_NOISE_DB,
            Reason::SignalToNoise,
        ),
    ];
    let failed = passes.into_iter().find(|(pass, _)| !pass);
    failed.map_or(Verdict::Pass, |(_, reason)| Verdict::Refused(reason))
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
        noise_below_full_db: 60.0,
        dut_signal_to_noise_db: 50.0,
        amplitude_stability_rel: 0.0005,
    };

    fn reason(example: Example, measured: Measured) -> Option<Reason> {
        match judge(example, &measured) {
            Verdict::Pass => None,
            Verdict::Refused(reason) => Some(reason),
        }
    }

    #[test]
    fn each_row_of_table_2_refuses_its_own_excess() {
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
            noise_below_full_db: value,
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
            (Example1, noise(160.0, 49.0), Some(Reason::SignalToNoise)),
            (Example2, noise(160.0, 41.0), None),
            (Example1, noise(8.0, 21.0), None),
            (Example2, noise(8.0, 9.0), Some(Reason::SignalToNoise)),
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
