//! Compares a result with the truth of the rig.

use calib_core::point::PointResult;
use calib_twin::oracle;
use calib_twin::rig::Rig;

/// How far a result is from the truth.
#[derive(Clone, Copy, Debug)]
pub struct Deviation {
    /// Magnitude of the sensitivity, relative.
    pub magnitude_rel: f64,
    /// Phase, rad, in (-pi, pi].
    pub phase_rad: f64,
}

/// Deviation of `result` from the true sensitivity of the rig's device under
/// test, at the frequency that was really played.
pub fn deviation(result: &PointResult, rig: &Rig, sample_rate_hz: f32) -> Deviation {
    let frequency_hz = f64::from(result.tone.cycles) * f64::from(sample_rate_hz)
        / f64::from(result.tone.period_samples);
    from_truth(result, oracle::dut_sensitivity(rig, frequency_hz))
}

/// Judges by a truth given as a complex sensitivity, V/(m/s2).
pub fn from_truth(result: &PointResult, truth: calib_twin::Complex<f64>) -> Deviation {
    let phase_rad = f64::from(result.phase_rad) - truth.arg();
    Deviation {
        magnitude_rel: f64::from(result.sensitivity_v_per_ms2) / truth.norm() - 1.0,
        phase_rad: phase_rad.sin().atan2(phase_rad.cos()),
    }
}
