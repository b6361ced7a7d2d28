//! A judged record as text.

use super::{Check, Outcome, Requirement};
use crate::metrology::text::{significant, table, wrap};

/// The table of requirements and the list of what is missing.
pub fn report(check: &Check) -> String {
    let rows: Vec<Vec<String>> = check.requirements.iter().map(row).collect();
    let mut text = format!(
        "ISO 16063-21, requirements of Example {}\n\n{}\n",
        check.example,
        table(
            &["parameter", "table", "limit", "worst", "at", "outcome"],
            &rows
        )
    );
    text.push_str(match check.missing.is_empty() {
        true => "Clause 7: everything asked for is stated.\n",
        false => "Clause 7 also asks for, and the record does not state:\n",
    });
    for missing in &check.missing {
        text.push_str(&wrap(&format!("{} ({})", missing.item, missing.clause), 2));
    }
    text
}

fn row(requirement: &Requirement) -> Vec<String> {
    let number = |value: Option<f64>| match value {
        Some(value) => format!("{} {}", significant(value, 2), requirement.unit),
        None => "-".into(),
    };
    vec![
        requirement.parameter.into(),
        requirement.table.into(),
        number(requirement.limit),
        number(requirement.worst),
        match requirement.at_hz {
            Some(f) => format!("{} Hz", significant(f, 4)),
            None => "-".into(),
        },
        match requirement.outcome {
            Outcome::Pass => "pass".into(),
            Outcome::Fail => "FAIL".into(),
            Outcome::NotMeasured => "not measured".into(),
        },
    ]
}
