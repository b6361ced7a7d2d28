//! Tables of ISO 16063-21 as data, for the two examples of clause 3.1.

use serde::{Deserialize, Serialize};

/// Requirement class of ISO 16063-21, clause 3.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Example {
    /// Laboratory conditions.
    #[serde(alias = "Example1")]
    Example1,
    /// Field conditions.
    #[serde(alias = "Example2")]
    Example2,
}

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
    /// Limit below 10 Hz.
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

/// Table 1: attainable expanded uncertainties (k = 2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attainable {
    /// Accelerometers from 0.4 Hz to 1 kHz, relative.
    pub to_1_khz_rel: f32,
    /// Accelerometers from 1 kHz to 2 kHz, relative.
    pub to_2_khz_rel: f32,
    /// Accelerometers from 2 kHz to 10 kHz, relative.
    pub to_10_khz_rel: f32,
    /// Displacement and velocity transducers from 20 Hz to 1 kHz, relative.
    pub other_quantities_rel: f32,
    /// Phase at reference conditions, degrees.
    pub phase_reference_deg: f32,
    /// Phase elsewhere, degrees.
    pub phase_deg: f32,
}

impl Attainable {
    /// Values of an example.
    pub const fn of(example: Example) -> Self {
        match example {
            Example::Example1 => Self {
                to_1_khz_rel: 0.01,
                to_2_khz_rel: 0.02,
                to_10_khz_rel: 0.03,
                other_quantities_rel: 0.04,
                phase_reference_deg: 1.0,
                phase_deg: 2.5,
            },
            Example::Example2 => Self {
                to_1_khz_rel: 0.03,
                to_2_khz_rel: 0.05,
                to_10_khz_rel: 0.10,
                other_quantities_rel: 0.06,
                phase_reference_deg: 3.0,
                phase_deg: 5.0,
            },
        }
    }

    /// Attainable for an accelerometer at a frequency, relative; `None`
    /// outside 0.4 Hz to 10 kHz. A border belongs to the lower range.
    pub fn accelerometer_at(&self, frequency_hz: f32) -> Option<f32> {
        if !(0.4..=10_000.0).contains(&frequency_hz) {
            None
        } else if frequency_hz <= 1_000.0 {
            Some(self.to_1_khz_rel)
        } else if frequency_hz <= 2_000.0 {
            Some(self.to_2_khz_rel)
        } else {
            Some(self.to_10_khz_rel)
        }
    }
}

/// Frequency in Hz above which Table 2 allows more transverse acceleration.
pub const TRANSVERSE_STEP_HZ: f32 = 1_000.0;

/// Transverse, bending and rocking acceleration allowed by Table 2, relative
/// to the intended one; the same for both examples.
pub fn transverse_at(frequency_hz: f32) -> f32 {
    if frequency_hz > TRANSVERSE_STEP_HZ {
        0.30
    } else {
        0.10
    }
}

/// Clause 4.2: room temperature about 23 degrees Celsius, and humidity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Environment {
    /// Half-width about 23 degrees Celsius.
    pub temperature_half_width_c: f32,
    /// Highest relative humidity, 1.
    pub humidity: f32,
}

impl Environment {
    /// Values of an example.
    pub const fn of(example: Example) -> Self {
        match example {
            Example::Example1 => Self {
                temperature_half_width_c: 5.0,
                humidity: 0.75,
            },
            Example::Example2 => Self {
                temperature_half_width_c: 10.0,
                humidity: 0.90,
            },
        }
    }
}

/// Clause 4.3: uncertainty of the reference at its reference point (k = 2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceTransducer {
    /// Magnitude, relative.
    pub expanded_uncertainty_rel: f32,
    /// Phase, degrees.
    pub expanded_uncertainty_phase_deg: f32,
}

impl ReferenceTransducer {
    /// Values of an example.
    pub const fn of(example: Example) -> Self {
        match example {
            Example::Example1 => Self {
                expanded_uncertainty_rel: 0.005,
                expanded_uncertainty_phase_deg: 0.5,
            },
            Example::Example2 => Self {
                expanded_uncertainty_rel: 0.02,
                expanded_uncertainty_phase_deg: 2.0,
            },
        }
    }
}

/// Table 3: one voltmeter, readings one after another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingleVoltmeter {
    /// Largest deviation from linearity between the levels read, relative.
    pub linearity_rel: f32,
    /// Largest deviation between two consecutive readings of the reference.
    pub repeat_rel: f32,
}

impl SingleVoltmeter {
    /// Values of an example.
    pub const fn of(example: Example) -> Self {
        match example {
            Example::Example1 => Self {
                linearity_rel: 0.001,
                repeat_rel: 0.001,
            },
            Example::Example2 => Self {
                linearity_rel: 0.003,
                repeat_rel: 0.003,
            },
        }
    }
}

/// Tables 4, 5 and 6: instruments for ratio, distortion and phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instruments {
    /// Table 4: largest uncertainty of the voltage ratio, relative.
    pub ratio_rel: f32,
    /// Table 5: largest uncertainty of a distortion reading, relative to it.
    pub distortion_of_reading_rel: f32,
    /// Table 6: largest uncertainty of the phase, degrees.
    pub phase_deg: f32,
}

impl Instruments {
    /// Values of an example.
    pub const fn of(example: Example) -> Self {
        match example {
            Example::Example1 => Self {
                ratio_rel: 0.002,
                distortion_of_reading_rel: 0.10,
                phase_deg: 0.2,
            },
            Example::Example2 => Self {
                ratio_rel: 0.005,
                distortion_of_reading_rel: 0.10,
                phase_deg: 0.5,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn borders_of_the_tables_belong_where_the_tables_say() {
        let one = Attainable::of(Example::Example1);
        let cases = [
            (0.4, Some(0.01)),
            (1_000.0, Some(0.01)),
            (1_250.0, Some(0.02)),
            (2_000.0, Some(0.02)),
            (2_500.0, Some(0.03)),
            (10_000.0, Some(0.03)),
            (0.3, None),
            (12_500.0, None),
            (f32::NAN, None),
        ];
        for (hz, expected) in cases {
            assert_eq!(one.accelerometer_at(hz), expected, "{hz}");
        }
        assert_eq!(
            [transverse_at(1_000.0), transverse_at(1_250.0)],
            [0.10, 0.30]
        );
        let table2 = VibrationGeneration::of(Example::Example1);
        assert_eq!(
            [table2.distortion_at(20.0), table2.distortion_at(25.0)],
            [0.10, 0.05]
        );
        assert_eq!([table2.noise_at(8.0), table2.noise_at(10.0)], [20.0, 50.0]);
    }

    #[test]
    fn field_conditions_never_ask_more_than_the_laboratory() {
        let of = |example| {
            let (a, v) = (Attainable::of(example), VibrationGeneration::of(example));
            let (r, s) = (
                ReferenceTransducer::of(example),
                SingleVoltmeter::of(example),
            );
            let (i, e) = (Instruments::of(example), Environment::of(example));
            [
                a.to_1_khz_rel,
                a.to_2_khz_rel,
                a.to_10_khz_rel,
                a.other_quantities_rel,
                a.phase_reference_deg,
                a.phase_deg,
                v.frequency_rel,
                v.amplitude_stability_rel,
                v.distortion_rel,
                -v.noise_below_full_db,
                r.expanded_uncertainty_rel,
                r.expanded_uncertainty_phase_deg,
                s.repeat_rel,
                s.linearity_rel,
                i.ratio_rel,
                i.phase_deg,
                e.temperature_half_width_c,
                e.humidity,
            ]
        };
        for (laboratory, field) in of(Example::Example1).into_iter().zip(of(Example::Example2)) {
            assert!(laboratory < field, "{laboratory} {field}");
        }
    }
}
