//! Settings an instrument on a simulated rig needs about its reference.

use calib_core::settings::{ReferenceCalibration, ReferencePoint, Settings};
use calib_twin::oracle;
use calib_twin::rig::Rig;

/// Settings for a simulated rig: those of the instrument, with the calibration
/// of the rig's own reference.
///
/// With an `error_seed` that calibration is wrong, within what it states: one
/// error of the magnitude and one of the phase, the same at all frequencies, as
/// the error of the standard it was calibrated against would be. Without one it
/// is perfect.
pub fn settings_for(rig: &Rig, current: Settings, error_seed: Option<u64>) -> Settings {
    let truth = oracle::reference_calibration(rig, None);
    let drawn = oracle::reference_calibration(rig, error_seed);
    let (gain, phase_rad) = match (truth.first(), drawn.first()) {
        (Some(truth), Some(drawn)) => (
            drawn.sensitivity_v_per_ms2 / truth.sensitivity_v_per_ms2,
            drawn.phase_rad - truth.phase_rad,
        ),
        _ => (1.0, 0.0),
    };
    let point = |point: &oracle::CalibrationPoint| ReferencePoint {
        frequency_hz: point.frequency_hz as f32,
        sensitivity_v_per_ms2: (gain * point.sensitivity_v_per_ms2) as f32,
        phase_rad: (point.phase_rad + phase_rad) as f32,
        expanded_uncertainty_rel: point.expanded_uncertainty_rel as f32,
        expanded_uncertainty_phase_rad: point.expanded_uncertainty_phase_rad as f32,
    };
    Settings {
        reference: ReferenceCalibration {
            serial: "simulated".try_into().unwrap_or_default(),
            certificate: "simulated reference".try_into().unwrap_or_default(),
            calibrated_day: 0,
            due_day: 0,
            points: truth.iter().map(point).collect(),
        },
        ..current
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_of_the_reference_is_within_its_statement_and_the_same_everywhere() {
        let rig = Rig::standard();
        let board = Settings::field_calibrator();
        let perfect = settings_for(&rig, board.clone(), None);
        assert_eq!(perfect.validate(), Ok(()));
        for seed in 0..50 {
            let drawn = settings_for(&rig, board.clone(), Some(seed));
            assert_eq!(drawn.validate(), Ok(()));
            let pairs = || drawn.reference.points.iter().zip(&perfect.reference.points);
            let gains: Vec<f32> = pairs()
                .map(|(drawn, truth)| drawn.sensitivity_v_per_ms2 / truth.sensitivity_v_per_ms2)
                .collect();
            // Five standard uncertainties: exceeded once in two million draws.
            let bound = 2.5 * perfect.reference.points[0].expanded_uncertainty_rel;
            assert!((gains[0] - 1.0).abs() < bound, "seed {seed}");
            assert!(gains[0] != 1.0, "seed {seed}");
            // Two roundings of f32 each.
            assert!(gains.iter().all(|gain| (gain - gains[0]).abs() < 3e-7));
            let (drawn, truth) = pairs().next().expect("a table");
            let bound = 2.5 * truth.expanded_uncertainty_phase_rad;
            assert!(
                (drawn.phase_rad - truth.phase_rad).abs() < bound,
                "seed {seed}"
            );
        }
    }
}
