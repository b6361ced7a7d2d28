//! Results in words and lines.

use calib_certificate::SensitivityUnit;
use calib_core::point::PointResult;
use calib_core::verdict::Verdict;
use calib_output::number::decimal;

/// One line about a measured point, its sensitivity in this unit.
pub(crate) fn point_line(point: &PointResult, unit: SensitivityUnit) -> String {
    let frequency_hz = point.spec.frequency_hz;
    match point.verdict {
        Verdict::Pass => format!(
            "{frequency_hz:>7} Hz  {:>9.4} {}  {:+8.3} deg  U = {:.2} %{}{}",
            unit.of_v_per_ms2(decimal(point.sensitivity_v_per_ms2)),
            unit.name(),
            f64::from(point.phase_rad).to_degrees(),
            100.0 * point.expanded_uncertainty_rel,
            coherence(point),
            if point.inverted { "  inverted" } else { "" },
        ),
        Verdict::Refused(reason) => {
            format!(
                "{frequency_hz:>7} Hz  refused: {reason}{}",
                coherence(point)
            )
        }
    }
}

fn coherence(point: &PointResult) -> String {
    match point.coherence {
        Some(coherence) => format!("  coherence {coherence:.4}"),
        None => String::new(),
    }
}
