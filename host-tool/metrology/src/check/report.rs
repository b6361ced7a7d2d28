//! A judged record as text.

use super::{Basis, Check, Outcome, PointCheck, Requirement};
use crate::text::{significant, table, wrap};

/// The table of requirements, that of the points, and what is missing.
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
    if stated(check) {
        text.push_str("* stated in the settings or labels of the record, not measured\n\n");
    }
    let points: Vec<Vec<String>> = check.points.iter().map(point).collect();
    text.push_str(&table(
        &[
            "f/Hz", "m/s2", "U/%", "U/deg", "freq/%", "stab/%", "THD/%", "noise/dB", "outcome",
        ],
        &points,
    ));
    text.push('\n');
    text.push_str(match check.missing.is_empty() {
        true => "Clause 7: everything asked for is stated.\n",
        false => "Clause 7 also asks for, and the record does not state:\n",
    });
    for missing in &check.missing {
        text.push_str(&wrap(&format!("{} ({})", missing.item, missing.clause), 2));
    }
    text
}

fn stated(check: &Check) -> bool {
    let mut rows = check.requirements.iter();
    rows.any(|row| row.basis == Some(Basis::Stated))
}

fn row(requirement: &Requirement) -> Vec<String> {
    let number = |value: Option<f64>| value.map_or("-".into(), |value| significant(value, 2));
    let mark = match requirement.basis {
        Some(Basis::Stated) => "*",
        _ => "",
    };
    vec![
        requirement.parameter.into(),
        requirement.table.into(),
        format!("{} {}", number(requirement.limit), requirement.unit),
        format!("{}{mark}", number(requirement.worst)),
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

/// A point with the value of each row; `!` marks one that is not fulfilled.
fn point(point: &PointCheck) -> Vec<String> {
    let mut cells = vec![
        significant(f64::from(point.set.frequency_hz), 4),
        significant(f64::from(point.set.set_acceleration_rms_ms2), 3),
    ];
    const COLUMNS: [&str; 6] = [
        "U of the magnitude",
        "U of the phase",
        "frequency uncertainty",
        "amplitude stability",
        "total harmonic distortion",
        "hum and noise below full",
    ];
    for column in COLUMNS {
        let held = point.held.iter().find(|row| row.parameter == column);
        cells.push(match held {
            None => "-".into(),
            Some(row) => {
                let mark = if row.passed { "" } else { "!" };
                format!("{}{mark}", significant(row.value, 2))
            }
        });
    }
    cells.push(match (point.passed, point.held.is_empty()) {
        (true, _) => "pass".into(),
        (false, true) => "refused".into(),
        (false, false) => "FAIL".into(),
    });
    cells
}
