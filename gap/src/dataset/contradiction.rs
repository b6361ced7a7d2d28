//! Contradictions between a rig and its table: one of the two is about another measurement.

use super::{Measured, Point, Rig};
use crate::error::GapError;
use crate::thresholds;

/// Checks what rig and table say about the same quantity.
///
/// # Errors
/// [`GapError::Table`] names both sides.
pub(super) fn check(rig: &Rig, measured: &Measured) -> Result<(), GapError> {
    let Measured::Points { points, .. } = measured else {
        return Ok(());
    };
    sampled_fast_enough(rig, points)?;
    within_full_scale(rig, points)?;
    level_is_reference(rig, points)
}

/// No sampled system sees a component at or above half its sample rate.
fn sampled_fast_enough(rig: &Rig, points: &[Point]) -> Result<(), GapError> {
    let Some(rate_hz) = rig.digitiser.sample_rate_hz else {
        return Ok(());
    };
    let highest_hz = points.iter().map(|p| p.frequency_hz).fold(0.0, f64::max);
    if highest_hz < 0.5 * rate_hz {
        return Ok(());
    }
    Err(contradicts(format!(
        "holds a point at {highest_hz} Hz, which digitiser.sample_rate_hz = {rate_hz} in rig.toml cannot see"
    )))
}

/// No mean and no noise is beyond the full scale; a fundamental may be, where a table was calculated.
fn within_full_scale(rig: &Rig, points: &[Point]) -> Result<(), GapError> {
    let Some(full_scale_v) = rig.digitiser.full_scale_v else {
        return Ok(());
    };
    for point in points {
        let voltages = [
            ("ref_dc_v", point.ref_dc_v.map(f64::abs)),
            ("dut_dc_v", point.dut_dc_v.map(f64::abs)),
            ("ref_noise_v", point.ref_noise_v),
            ("dut_noise_v", point.dut_noise_v),
        ];
        if let Some((column, _)) = voltages
            .iter()
            .find(|(_, v)| v.is_some_and(|v| v > full_scale_v))
        {
            return Err(contradicts(format!(
                "column {column} at {} Hz is beyond digitiser.full_scale_v = {full_scale_v} V peak in rig.toml",
                point.frequency_hz
            )));
        }
    }
    Ok(())
}

/// The level is the reference output over the nominal sensitivity of the reference.
fn level_is_reference(rig: &Rig, points: &[Point]) -> Result<(), GapError> {
    let Some(sensitivity) = rig.reference.and_then(|r| r.sensitivity_v_per_ms2) else {
        return Ok(());
    };
    let mut quotients: Vec<f64> = points
        .iter()
        .filter_map(|p| Some(p.ref_v? / (sensitivity.value * p.acceleration_ms2?)))
        .collect();
    quotients.sort_by(f64::total_cmp);
    let Some(&median) = quotients.get(quotients.len() / 2) else {
        return Ok(());
    };
    if (thresholds::LEVEL_AGREES.recip()..=thresholds::LEVEL_AGREES).contains(&median) {
        return Ok(());
    }
    Err(contradicts(format!(
        "ref_v is {median:.4} times acceleration_ms2 x reference.sensitivity_v_per_ms2 = {} of rig.toml (median of the rows)",
        sensitivity.value
    )))
}

fn contradicts(problem: String) -> GapError {
    GapError::Table {
        file: "points.csv",
        problem: format!("{problem}; correct one of them"),
    }
}
