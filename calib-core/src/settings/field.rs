//! Settings of a field calibrator as it leaves the workshop.

use super::{
    Distribution, Example, Influence, InputScale, Limits, Method, PointInfluences,
    ReferenceCalibration, ReferencePoint, Settings,
};
use crate::channel_ratio::ChannelRatio;
use crate::converter::Converters;
use crate::preferred::PREFERRED_HZ;
use heapless::{String, Vec};

/// Sensitivity of the built-in reference with its conditioner, V/(m/s2).
const REFERENCE_V_PER_MS2: f32 = 0.0102;

/// Step at mid-scale the sheet allows the input converters: differential nonlinearity of +3 codes of 16
/// bits (DS12110 Rev 10, table 186, typical).
const CONVERTER_STEP_CODES: f32 = 3.0;
/// Distance from the line it allows them: integral nonlinearity, in the same table.
const CONVERTER_NONLINEARITY_CODES: f32 = 10.0;
/// Codes the dither of the front end reaches to either side: 8700 by its parts, an eighth less because it takes
/// the ends more often than the middle, and 5 % less by the tolerance of its capacitors
/// (`the_dither_reaches_as_far_as_the_budget_says`).
const DITHER_CODES: f32 = 7200.0;

/// Influences that differ from point to point; the reasons are in docs/metrology/measurement.md.
const POINT_INFLUENCES: PointInfluences = PointInfluences {
    // Half a percent of bending between two transducers on a light table.
    relative_motion_at_10_khz_rel: 0.005,
    // sqrt(2^2 + 5^2) %: a reference, and what makers state for industrial sensors.
    transverse_sensitivity_rel: 0.053_851_6,
    // A resonance of 38 kHz that shifts by 5 %.
    mounting_at_10_khz_rel: 0.0075,
    // Filters of parts of 1 %, whose delay is 28 us.
    channel_delay_s: 3.0e-7,
    // Transverse motion: what Table 2 allows, until the exciter's own is known.
    ..PointInfluences::NONE
};

const RECTANGULAR: Distribution = Distribution::Rectangular;

/// Row of Table A.1, value in percent, value in degrees, distribution.
type Line = (u8, f32, f32, Distribution);

/// Influences after Table D.1, adapted: both channels are sampled at the same
/// time (no change of level between two readings, row 3), and correlation
/// rejects harmonics, hum and noise except what the repeatability shows.
const INFLUENCES: [Line; 14] = [
    // Gain of the conditioner of the device under test.
    (2, 0.25, 0.10, RECTANGULAR),
    // Ratio of the two converters.
    (3, 0.10, 0.05, RECTANGULAR),
    // Slope of the response at the third harmonic (Table D.1, note 2).
    (4, 0.0024, 0.0, RECTANGULAR),
    (7, 0.05, 0.03, RECTANGULAR),
    (8, 0.05, 0.03, RECTANGULAR),
    (9, 0.05, 0.03, RECTANGULAR),
    // 0.05 % a year for three years.
    (10, 0.15, 0.05, RECTANGULAR),
    // 23 degrees Celsius +- 3, 0.1 % and 0.02 % per degree.
    (11, 0.36, 0.10, RECTANGULAR),
    // 0.01 % of frequency on a response falling 2 % per decade.
    (12, 0.0001, 0.0, RECTANGULAR),
    (13, 0.03, 0.02, RECTANGULAR),
    (14, 0.03, 0.02, RECTANGULAR),
    (15, 0.0, 0.0, RECTANGULAR),
    (16, 0.03, 0.02, RECTANGULAR),
    (17, 0.03, 0.02, RECTANGULAR),
];

impl Settings {
    /// A calibrator for the field with the converters of [`Converters::FIELD`]:
    /// Example 2, built-in reference, and an exciter of 200 m/s2, 1 m/s and 5 mm
    /// peak that takes the whole drive.
    ///
    /// The reference table is flat; its expanded uncertainty is 0.5 % and
    /// 0.3 degrees up to 1 kHz, rising to 1.5 % and 1 degree at 10 kHz. A real
    /// instrument gets the table of its own certificate.
    pub fn field_calibrator() -> Self {
        Self::field_calibrator_with(&Converters::FIELD)
    }

    /// [`Self::field_calibrator`] on another board.
    pub fn field_calibrator_with(converters: &Converters) -> Self {
        let code_v = converters.volt_per_sample();
        let input = InputScale {
            volt_per_code: code_v,
        };
        let drive_full_scale_peak_v = converters.drive_full_scale_peak_v;
        Self {
            method: Method::Calibrator,
            example: Example::Example2,
            reference: reference(),
            reference_input: input,
            dut_input: input,
            drive_full_scale_peak_v,
            limits: Limits {
                drive_peak_v: drive_full_scale_peak_v,
                acceleration_peak_ms2: 200.0,
                velocity_peak_ms: 1.0,
                displacement_peak_m: 0.005,
            },
            blocks: 10,
            influences: INFLUENCES.iter().map(influence).collect(),
            point_influences: PointInfluences {
                converter_step_v: CONVERTER_STEP_CODES * code_v,
                converter_nonlinearity_v: CONVERTER_NONLINEARITY_CODES * code_v,
                dither_peak_v: DITHER_CODES * code_v,
                ..POINT_INFLUENCES
            },
            channel_ratio: ChannelRatio::UNKNOWN,
            lease_s: 0,
        }
    }
}

fn influence(&(row, percent, degrees, distribution): &Line) -> Influence {
    Influence {
        row,
        value_rel: percent / 100.0,
        value_phase_rad: degrees.to_radians(),
        distribution,
    }
}

fn reference() -> ReferenceCalibration {
    ReferenceCalibration {
        serial: String::new(),
        certificate: String::new(),
        calibrated_day: 0,
        due_day: 0,
        points: PREFERRED_HZ
            .into_iter()
            .map(reference_point)
            .collect::<Vec<_, _>>(),
    }
}

/// Uncertainty is constant up to 1 kHz and grows with the logarithm above.
fn reference_point(frequency_hz: f32) -> ReferencePoint {
    let decades = libm::log10f(frequency_hz / 1000.0).max(0.0);
    ReferencePoint {
        frequency_hz,
        sensitivity_v_per_ms2: REFERENCE_V_PER_MS2,
        phase_rad: 0.0,
        expanded_uncertainty_rel: 0.005 + 0.010 * decades,
        expanded_uncertainty_phase_rad: (0.3 + 0.7 * decades).to_radians(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_board_has_its_own_scales() {
        let converters = Converters {
            input_full_scale_peak_v: 2.5,
            drive_full_scale_peak_v: 4.0,
            ..Converters::FIELD
        };
        let settings = Settings::field_calibrator_with(&converters);
        assert_eq!(settings.validate(), Ok(()));
        // By hand: 5 V / 65 536.
        assert_eq!(settings.reference_input.volt_per_code, 7.629_394_5e-5);
        assert_eq!(settings.dut_input, settings.reference_input);
        assert_eq!(settings.drive_full_scale_peak_v, 4.0);
        assert_eq!(settings.limits.drive_peak_v, 4.0);
    }

    #[test]
    fn the_field_calibrator_is_valid_and_has_every_preferred_frequency() {
        let settings = Settings::field_calibrator();
        assert_eq!(settings.validate(), Ok(()));
        for frequency_hz in PREFERRED_HZ {
            let reference = settings.reference.at(frequency_hz).expect("in the table");
            assert_eq!(reference.sensitivity_v_per_ms2, REFERENCE_V_PER_MS2);
            assert_eq!(reference.interpolation_rel, 0.0);
        }
        let at = |hz| settings.reference.at(hz).expect("in the table");
        assert_eq!(at(1000.0).expanded_uncertainty_rel, 0.005);
        assert!((at(10_000.0).expanded_uncertainty_rel - 0.015).abs() < 1.0e-8);
    }
}
