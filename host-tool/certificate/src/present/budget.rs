//! The budget at the reference point in words.

use crate::model::Budget;
use crate::rounding::round_uncertainty;
use crate::words::Language;
use serde::Serialize;

/// The budget in words.
#[derive(Clone, Debug, Serialize)]
pub struct PresentedBudget {
    /// Headings.
    pub columns: Vec<String>,
    /// Rows of strings.
    pub rows: Vec<Vec<String>>,
    /// Combined standard uncertainty, %.
    pub combined: String,
    /// Effective degrees of freedom.
    pub degrees: String,
    /// "Expanded uncertainty, k = 2".
    pub expanded_label: String,
    /// Expanded uncertainty, %.
    pub expanded: String,
}

/// The budget in the shape of Annex D, table D.1.
pub(super) fn budget(budget: &Budget, language: Language) -> PresentedBudget {
    let keys = [
        "quantity",
        "description",
        "value",
        "distribution",
        "divisor",
        "coefficient",
        "contribution",
        "degrees",
    ];
    let label = |key: &str| language.word(&format!("budget.{key}")).to_owned();
    let rows = budget.rows.iter().map(|row| {
        let (distribution, parameter) = row.distribution;
        let parameter = parameter
            .map(|value| language.shortest(value))
            .unwrap_or_default();
        vec![
            row.row.to_string(),
            language.word(&format!("row.{}", row.row)).to_owned(),
            significant(row.value_percent, language),
            language.phrase(&format!("distribution.{distribution}"), &[&parameter]),
            language.number(row.divisor, 3),
            language.shortest(row.sensitivity_coefficient),
            significant(row.contribution_percent, language),
            degrees(row.degrees_of_freedom, language),
        ]
    });
    PresentedBudget {
        columns: keys.iter().map(|key| label(key)).collect(),
        rows: rows.collect(),
        combined: significant(budget.combined_percent, language),
        degrees: degrees(budget.effective_degrees_of_freedom, language),
        expanded_label: language.phrase(
            "budget.expanded",
            &[&language.number(budget.coverage_factor, 2)],
        ),
        expanded: significant(budget.expanded_percent, language),
    }
}

/// Two significant digits, as the table of Annex D has them.
fn significant(value: f64, language: Language) -> String {
    match round_uncertainty(value, 2) {
        Some((rounded, digit)) => language.number(rounded, usize::try_from(digit).unwrap_or(0)),
        None => language.number(value, 2),
    }
}

/// Degrees of freedom: whole numbers, truncated as GUM G.4.1 does.
pub(super) fn degrees(value: f64, language: Language) -> String {
    if value.is_infinite() || value >= 1.0e4 {
        "\u{221e}".to_owned()
    } else {
        language.number(value.floor(), 0)
    }
}
