//! Results in words and lines.

use calib_core::point::PointResult;
use calib_core::verdict::Verdict;

/// One line about a measured point.
pub(crate) fn point_line(point: &PointResult) -> String {
    let frequency_hz = point.spec.frequency_hz;
    match point.verdict {
        Verdict::Pass => format!(
            "{frequency_hz:>7} Hz  {:.5e} V/(m/s2)  {:+8.3} deg  U = {:.2} %{}{}",
            point.sensitivity_v_per_ms2,
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
