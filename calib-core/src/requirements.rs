//! Tables of ISO 16063-21 as data, for the two examples of clause 3.1.

use crate::settings::Example;

/// Table 2: what the vibration generation equipment must fulfil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VibrationGeneration {
    /// Largest relative uncertainty of the frequency.
    pub frequency_rel: f32,
    /// Largest relative change of the frequency over the measurement.
    pub frequency_stability_rel: f32,
    /// Largest relative change of the acceleration amplitude.
    pub amplitude_stability_rel: f32,
    /// Largest total harmonic distortion above 20 Hz, 1.
    pub distortion_above_20_hz_rel: f32,
    /// Largest total harmonic distortion at any frequency, 1.
    pub distortion_rel: f32,
    /// Hum and noise below full output from 10 Hz on, dB, at least.
    pub noise_below_full_db: f32,
    /// The same below 10 Hz.
    pub noise_below_full_under_10_hz_db: f32,
}

impl VibrationGeneration {
    /// Requirements of an example.
    pub const fn of(example: Example) -> Self {
        match example {
            Example::Example1 => Self {
                frequency_rel: 0.001,
                frequency_stability_rel: 0.001,
                amplitude_stability_rel: 0.001,
                distortion_above_20_hz_rel: 0.05,
                distortion_rel: 0.10,
                noise_below_full_db: 50.0,
                noise_below_full_under_10_hz_db: 20.0,
            },
            Example::Example2 => Self {
                frequency_rel: 0.002,
                frequency_stability_rel: 0.002,
                amplitude_stability_rel: 0.003,
                distortion_above_20_hz_rel: 0.10,
                distortion_rel: 0.20,
                noise_below_full_db: 40.0,
                noise_below_full_under_10_hz_db: 10.0,
            },
        }
    }

    /// Distortion allowed at a frequency, 1.
    pub fn distortion_at(&self, frequency_hz: f32) -> f32 {
        if frequency_hz > 20.0 {
            self.distortion_above_20_hz_rel
        } else {
            self.distortion_rel
        }
    }

    /// Hum and noise below full output demanded at a frequency, dB.
    pub fn noise_at(&self, frequency_hz: f32) -> f32 {
        if frequency_hz >= 10.0 {
            self.noise_below_full_db
        } else {
            self.noise_below_full_under_10_hz_db
        }
    }
}
