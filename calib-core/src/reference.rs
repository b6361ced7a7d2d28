//! The reference's sensitivity at a frequency, by its own calibration table.

use crate::response_table::{self, Response, Row};
use heapless::{String, Vec};
use serde::{Deserialize, Serialize};

/// Most frequencies a reference calibration table holds (0.4 Hz to 20 kHz in
/// one-third octaves are 48).
pub const MAX_REFERENCE_POINTS: usize = 48;

/// One frequency of the reference's own calibration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ReferencePoint {
    /// Frequency, Hz.
    pub frequency_hz: f32,
    /// Sensitivity of reference and conditioner, V/(m/s2).
    pub sensitivity_v_per_ms2: f32,
    /// Phase of that sensitivity, rad.
    pub phase_rad: f32,
    /// Relative expanded uncertainty (k = 2) of the magnitude.
    pub expanded_uncertainty_rel: f32,
    /// Expanded uncertainty (k = 2) of the phase, rad.
    pub expanded_uncertainty_phase_rad: f32,
}

/// Calibration of the reference transducer with its conditioner.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ReferenceCalibration {
    /// Serial number of the reference.
    #[cfg_attr(feature = "schema", schemars(with = "str"))]
    pub serial: String<32>,
    /// Certificate the table was taken from.
    #[cfg_attr(feature = "schema", schemars(with = "str"))]
    pub certificate: String<48>,
    /// Day of the calibration, days since 1970-01-01; 0 = not stated.
    pub calibrated_day: u32,
    /// Day the next calibration is due, days since 1970-01-01; 0 = not stated.
    pub due_day: u32,
    /// Table in rising frequency.
    #[cfg_attr(feature = "schema", schemars(with = "[ReferencePoint]"))]
    pub points: Vec<ReferencePoint, MAX_REFERENCE_POINTS>,
}

/// Sensitivity of the reference at one frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceSensitivity {
    /// Magnitude, V/(m/s2).
    pub sensitivity_v_per_ms2: f32,
    /// Phase, rad.
    pub phase_rad: f32,
    /// Relative expanded uncertainty (k = 2) of the calibration: that of the
    /// row, or the larger of the two neighbours.
    pub expanded_uncertainty_rel: f32,
    /// Expanded uncertainty (k = 2) of the phase, rad, likewise.
    pub expanded_uncertainty_phase_rad: f32,
    /// Half-width of the error by interpolation, relative; 0 at a row.
    pub interpolation_rel: f32,
    /// Expanded uncertainty of the phase, rad.
    pub interpolation_phase_rad: f32,
}

impl ReferenceCalibration {
    /// Sensitivity at `frequency_hz` by [`crate::response_table`]: between rows it is interpolated,
    /// and the error of that stated.
    ///
    /// Returns `None` outside the table: a reference is never extrapolated.
    ///
    /// # Accuracy
    /// Test `interpolation_error_stays_within_its_own_statement`.
    pub fn at(&self, frequency_hz: f32) -> Option<ReferenceSensitivity> {
        let response = response_table::at(&self.points, frequency_hz)?;
        Some(ReferenceSensitivity {
            sensitivity_v_per_ms2: response.magnitude,
            phase_rad: response.phase_rad,
            expanded_uncertainty_rel: response.expanded_uncertainty_rel,
            expanded_uncertainty_phase_rad: response.expanded_uncertainty_phase_rad,
            interpolation_rel: response.interpolation_rel,
            interpolation_phase_rad: response.interpolation_phase_rad,
        })
    }
}

impl Row for ReferencePoint {
    fn frequency_hz(&self) -> f32 {
        self.frequency_hz
    }

    fn response(&self) -> Response {
        Response {
            magnitude: self.sensitivity_v_per_ms2,
            phase_rad: self.phase_rad,
            expanded_uncertainty_rel: self.expanded_uncertainty_rel,
            expanded_uncertainty_phase_rad: self.expanded_uncertainty_phase_rad,
            interpolation_rel: 0.0,
            interpolation_phase_rad: 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use heapless::{String, Vec};

    /// A table of a smooth response: a resonance at 30 kHz, as accelerometers
    /// have, and the phase of a low-pass.
    fn truth(frequency_hz: f64) -> (f64, f64) {
        let r = frequency_hz / 30_000.0;
        let (re, im) = (1.0 - r * r, 0.04 * r);
        (
            0.0102 / re.hypot(im),
            -(im / re).atan() - 1.0e-5 * frequency_hz,
        )
    }

    fn table(frequencies: &[f32]) -> ReferenceCalibration {
        let row = |&frequency_hz: &f32| {
            let (sensitivity, phase) = truth(f64::from(frequency_hz));
            ReferencePoint {
                frequency_hz,
                sensitivity_v_per_ms2: sensitivity as f32,
                phase_rad: phase as f32,
                expanded_uncertainty_rel: 0.005 + frequency_hz * 1.0e-6,
                expanded_uncertainty_phase_rad: 0.005,
            }
        };
        ReferenceCalibration {
            serial: String::new(),
            certificate: String::new(),
            calibrated_day: 0,
            due_day: 0,
            points: frequencies.iter().map(row).collect::<Vec<_, _>>(),
        }
    }

    const OCTAVES: [f32; 9] = [
        40.0, 80.0, 160.0, 315.0, 630.0, 1250.0, 2500.0, 5000.0, 10_000.0,
    ];

    #[test]
    fn interpolation_error_stays_within_its_own_statement() {
        let table = table(&OCTAVES);
        for step in 0..400 {
            let hz = 41.0 * (9_900.0_f64 / 41.0).powf(f64::from(step) / 399.0);
            let at = table.at(hz as f32).expect("inside the table");
            let (sensitivity, phase) = truth(hz);
            let error = (f64::from(at.sensitivity_v_per_ms2) / sensitivity - 1.0).abs();
            // The second difference is that of the neighbours: in the last
            // interval, where the resonance bends most, the left one alone. A
            // factor of three covers its growth from octave to octave; f32 and
            // the frequency tolerance of a row add 1e-6 and 5e-4 of a slope.
            let allowed = if hz > 5_000.0 { 3.0 } else { 1.05 };
            assert!(
                error <= allowed * f64::from(at.interpolation_rel) + 2.0e-6 + 5.0e-4 * 0.02,
                "{hz}"
            );
            let error = (f64::from(at.phase_rad) - phase).abs();
            assert!(
                error
                    <= allowed * f64::from(at.interpolation_phase_rad)
                        + 1.0e-5 * 5.0e-4 * hz
                        + 1.0e-6,
                "{hz}"
            );
        }
    }

    #[test]
    fn a_row_is_taken_as_it_is() {
        let table = table(&OCTAVES);
        for (row, hz) in table.points.iter().zip(OCTAVES) {
            let at = table.at(hz * 1.0001).expect("a row");
            assert_eq!(at.sensitivity_v_per_ms2, row.sensitivity_v_per_ms2);
            assert_eq!(at.expanded_uncertainty_rel, row.expanded_uncertainty_rel);
            assert_eq!(at.interpolation_rel, 0.0);
        }
    }

    #[test]
    fn between_rows_the_larger_uncertainty_holds() {
        let at = table(&OCTAVES).at(200.0).expect("inside");
        assert_eq!(at.expanded_uncertainty_rel, 0.005 + 315.0 * 1.0e-6);
        assert!(at.interpolation_rel > 0.0);
    }

    #[test]
    fn nothing_is_extrapolated() {
        let table = table(&OCTAVES);
        for hz in [39.0, 10_010.0, 0.0, -5.0, f32::NAN, f32::INFINITY] {
            assert_eq!(table.at(hz), None, "{hz}");
        }
    }

    #[test]
    fn two_rows_state_half_their_difference_at_most() {
        // Nothing is known of the curvature: t (1 - t) / 2 of the difference.
        let table = table(&[1_000.0, 10_000.0]);
        let at = table.at(3_162.28).expect("inside");
        let [low, high] = [1_000.0, 10_000.0].map(|hz| truth(hz).0);
        let expected = (high - low) / 8.0 / (0.5 * (low + high));
        assert!((f64::from(at.interpolation_rel) / expected - 1.0).abs() < 1.0e-4);
    }
}
