//! Frequencies that fit the sample clock exactly.
//!
//! Converter and generator share one timer, so a tone is a rational number of
//! cycles per sample: `cycles` whole cycles in `period_samples` samples. A
//! block of whole periods then holds a whole number of cycles and the
//! correlation has no leakage by construction; the price is a frequency that
//! differs from nominal by at most 0.01 %, which is reported and budgeted.

use serde::{Deserialize, Serialize};

/// Longest period a tone may have, in samples. It bounds the folded block.
pub const MAX_PERIOD_SAMPLES: u16 = 12_000;

/// Largest deviation from the nominal frequency, relative.
pub const MAX_DEVIATION_REL: f32 = 1.0e-4;

/// A sine of `cycles` whole cycles in `period_samples` samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tone {
    /// Whole cycles in one period of the sampled signal, at least 1.
    pub cycles: u16,
    /// Samples in that period, more than `2 * cycles`.
    pub period_samples: u16,
}

impl Tone {
    /// The shortest tone within 0.01 % of `nominal_hz`.
    ///
    /// Returns `None` when the frequency is not finite and positive, is above
    /// 0.45 of the sample rate, or has no period of at most
    /// [`MAX_PERIOD_SAMPLES`] samples (below about 4.2 Hz at 50 kS/s).
    ///
    /// # Accuracy
    /// Test `every_preferred_frequency_is_within_a_hundredth_of_a_percent`.
    pub fn nearest(nominal_hz: f32, sample_rate_hz: f32) -> Option<Self> {
        let usable = nominal_hz.is_finite() && nominal_hz > 0.0;
        if !usable || nominal_hz > 0.45 * sample_rate_hz {
            return None;
        }
        // f64 here: the search compares deviations near f32's own resolution.
        let (nominal, rate) = (f64::from(nominal_hz), f64::from(sample_rate_hz));
        for cycles in 1..=u16::MAX {
            let period = libm::round(f64::from(cycles) * rate / nominal);
            if period > f64::from(MAX_PERIOD_SAMPLES) {
                return None;
            }
            let deviation = libm::fabs(f64::from(cycles) * rate / period / nominal - 1.0);
            if deviation <= f64::from(MAX_DEVIATION_REL) {
                return Some(Self {
                    cycles,
                    period_samples: period as u16,
                });
            }
        }
        None
    }

    /// Frequency at `sample_rate_hz`, in hertz.
    pub fn frequency_hz(self, sample_rate_hz: f32) -> f32 {
        f32::from(self.cycles) * sample_rate_hz / f32::from(self.period_samples)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::preferred::PREFERRED_HZ;

    #[test]
    fn every_preferred_frequency_is_within_a_hundredth_of_a_percent() {
        for nominal_hz in PREFERRED_HZ {
            let tone = Tone::nearest(nominal_hz, 50_000.0).expect("tone exists");
            let exact = f64::from(tone.cycles) * 50_000.0 / f64::from(tone.period_samples);
            assert!(
                (exact / f64::from(nominal_hz) - 1.0).abs() <= 1.0e-4,
                "{nominal_hz}"
            );
            assert!(tone.period_samples > 2 * tone.cycles);
        }
    }

    #[test]
    fn frequencies_outside_the_sampled_band_are_refused() {
        for nominal_hz in [0.0, -5.0, f32::NAN, f32::INFINITY, 4.0, 22_600.0] {
            assert_eq!(Tone::nearest(nominal_hz, 50_000.0), None, "{nominal_hz}");
        }
    }
}
