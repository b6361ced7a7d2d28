//! Phase results as text.

use super::PhaseResult;
use crate::text::{significant, table, wrap};

/// A table with both uncertainties, each under its name.
pub fn report(results: &[PhaseResult], remarks: &[String]) -> String {
    let rows: Vec<Vec<String>> = results
        .iter()
        .map(|result| {
            vec![
                significant(result.frequency_hz, 5),
                result.readings.to_string(),
                format!("{:.3}", result.phase_deg),
                significant(result.x_random_deg, 2),
                significant(result.x_systematic_deg, 2),
                significant(result.x95_deg, 2),
                format!("{:.2}", result.gum_coverage_factor),
                significant(result.gum_expanded_uncertainty_deg, 2),
            ]
        })
        .collect();
    let header = ["f/Hz", "n", "phase", "X_r", "X_s", "X_95", "k", "U(GUM)"];
    let mut text = format!(
        "Phase by comparison, degrees, 95 %\nX: ISO 5347-9 Annex A; k, U: GUM\n\n{}",
        table(&header, &rows)
    );
    for remark in remarks {
        text.push_str(&wrap(&format!("Remark: {remark}."), 2));
    }
    text
}
