//! A certificate beside the calibration in force: how far each frequency moved, and whether that is more than both
//! uncertainties allow.

use crate::control_chart::e_n;
use calib_core::settings::{ReferenceCalibration, ReferencePoint};
use calib_output::number::decimal;
use schemars::JsonSchema;
use serde::Serialize;

/// One frequency of the new table beside what is in force there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Compared {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// New sensitivity, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Its relative expanded uncertainty, k = 2.
    pub expanded_uncertainty_rel: f64,
    /// New phase, degrees.
    pub phase_deg: f64,
    /// Its expanded uncertainty, degrees, k = 2.
    pub expanded_uncertainty_phase_deg: f64,
    /// Relative change from what is in force, interpolated as the instrument does; none outside of its table.
    pub change_rel: Option<f64>,
    /// Change of the phase, degrees.
    pub change_phase_deg: Option<f64>,
    /// The change over the root of the sum of squares of both expanded uncertainties, with that of the
    /// interpolation; beyond 1 they disagree. Only of one transducer.
    pub e_n: Option<f64>,
}

/// Every frequency of `new`. The two calibrations count as independent: what they share makes E_n too small.
pub fn compare(new: &ReferenceCalibration, in_force: &ReferenceCalibration) -> Vec<Compared> {
    let is_same = new
        .serial
        .trim()
        .eq_ignore_ascii_case(in_force.serial.trim());
    let row = |point: &ReferencePoint| {
        let old = in_force.at(point.frequency_hz);
        let u_rel = f64::from(point.expanded_uncertainty_rel);
        let change_rel = old.map(|old| {
            f64::from(point.sensitivity_v_per_ms2) / f64::from(old.sensitivity_v_per_ms2) - 1.0
        });
        let disagreement = old.zip(change_rel).map(|(old, change)| {
            // A half-width of a rectangular distribution, expanded with k = 2.
            let interpolation = 2.0 * f64::from(old.interpolation_rel) / 3.0_f64.sqrt();
            let u_old = f64::from(old.expanded_uncertainty_rel).hypot(interpolation);
            e_n(1.0 + change, (1.0 + change) * u_rel, 1.0, u_old)
        });
        let turned = |phase_deg: f64| phase_deg - 360.0 * (phase_deg / 360.0).round();
        Compared {
            frequency_hz: decimal(point.frequency_hz),
            sensitivity_v_per_ms2: decimal(point.sensitivity_v_per_ms2),
            expanded_uncertainty_rel: u_rel,
            phase_deg: f64::from(point.phase_rad).to_degrees(),
            expanded_uncertainty_phase_deg: f64::from(point.expanded_uncertainty_phase_rad)
                .to_degrees(),
            change_rel,
            change_phase_deg: old.map(|old| {
                turned((f64::from(point.phase_rad) - f64::from(old.phase_rad)).to_degrees())
            }),
            e_n: disagreement.filter(|_| is_same),
        }
    };
    new.points.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn calibration(rows: &[(f32, f32, f32)]) -> ReferenceCalibration {
        let row =
            |&(frequency_hz, sensitivity_v_per_ms2, phase_rad): &(f32, f32, f32)| ReferencePoint {
                frequency_hz,
                sensitivity_v_per_ms2,
                phase_rad,
                expanded_uncertainty_rel: 0.003,
                expanded_uncertainty_phase_rad: 0.01,
            };
        ReferenceCalibration {
            serial: heapless::String::try_from("R 1").expect("short"),
            certificate: heapless::String::new(),
            calibrated_day: 0,
            due_day: 0,
            points: rows.iter().map(row).collect(),
        }
    }

    #[test]
    fn a_change_is_held_against_both_uncertainties() {
        let old = calibration(&[(80.0, 0.01, 3.1), (160.0, 0.01, 0.0), (320.0, 0.01, 0.0)]);
        let mut new = calibration(&[
            (40.0, 0.01, 0.0),
            (80.0, 0.01, -3.1),
            (160.0, 0.010_06, 0.0),
        ]);
        let lines = compare(&new, &old);
        assert_eq!(
            (lines[0].change_rel, lines[0].e_n),
            (None, None),
            "nothing in force there"
        );
        // From 3.1 to -3.1 rad: 2 pi - 6.2 = 0.0832 rad on, not 6.2 back.
        let turned = lines[1].change_phase_deg.expect("in force");
        assert!(
            (turned - (2.0 * std::f64::consts::PI - 6.2).to_degrees()).abs() < 1e-4,
            "{turned}"
        );
        // 0.6 % over sqrt(2) times 0.3 %, the new one of 1.006: 1.41.
        let e_n = lines[2].e_n.expect("the same transducer");
        let expected = 0.006 / (0.003_f64.powi(2) * (1.0 + 1.006_f64.powi(2))).sqrt();
        assert!((e_n - expected).abs() < 2e-4, "{e_n} {expected}");
        new.serial = heapless::String::try_from("R 2").expect("short");
        assert_eq!(compare(&new, &old)[2].e_n, None, "another transducer");
    }
}
