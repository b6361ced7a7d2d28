//! Results in words and lines.

use calib_certificate::SensitivityUnit;
use calib_core::point::PointResult;
use calib_core::point_state::PointState;
use calib_host::in_unit::StatedPoint;

/// One line about a measured point, its sensitivity in this unit.
pub(crate) fn point_line(
    point: &PointResult,
    stated: &StatedPoint,
    unit: SensitivityUnit,
) -> String {
    let frequency_hz = point.spec.frequency_hz;
    match (point.state, stated.in_unit) {
        (PointState::Valid, Some(own)) => format!(
            "{frequency_hz:>7} Hz  {:>9} {}  {:+8.3} deg  U = {:.2} %{}{}",
            sensitivity(own.sensitivity),
            unit.name(),
            // No "-0.000".
            if own.phase_deg.abs() < 0.000_5 {
                0.0
            } else {
                own.phase_deg
            },
            100.0 * point.expanded_uncertainty_rel,
            coherence(point),
            if own.inverted { "  inverted" } else { "" },
        ),
        (PointState::Valid, None) => format!("{frequency_hz:>7} Hz  no tone"),
        (PointState::Refused(reason), _) => {
            format!(
                "{frequency_hz:>7} Hz  refused: {reason}{}",
                coherence(point)
            )
        }
    }
}

/// A sensitivity with four decimals, more where it is small: five figures that count at least.
pub(crate) fn sensitivity(value: f64) -> String {
    let zeros = (-value.abs().log10().floor()).clamp(0.0, 6.0);
    format!("{value:.*}", 4 + zeros as usize)
}

fn coherence(point: &PointResult) -> String {
    match point.coherence {
        Some(coherence) => format!("  coherence {coherence:.4}"),
        None => String::new(),
    }
}
