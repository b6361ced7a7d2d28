//! A record against Tables 1 to 6 and the list of clause 7.
//!
//! # Source
//! ISO 16063-21:2003, Tables 1 to 6, clauses 4 and 7.

mod report;
mod requirements;

pub use report::report;
pub use requirements::{Outcome, Requirement, requirements};

use crate::certificate::particulars::Particulars;
use crate::certificate::{Certificate, Language};
use calib_core::settings::Example;
use calib_protocol::record::Record;
use serde::Serialize;

/// A record judged.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Check {
    /// Which requirements were applied: 1 (laboratory) or 2 (field).
    pub example: u8,
    /// Rows of Tables 1 to 6.
    pub requirements: Vec<Requirement>,
    /// What clause 7 asks to be reported and the record lacks.
    pub missing: Vec<Missing>,
    /// No requirement failed.
    pub pass: bool,
}

/// A statement that is missing.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Missing {
    /// What is missing.
    pub item: String,
    /// Clause that asks for it.
    pub clause: String,
}

/// Judges a record. `example` overrides what its settings say.
pub fn check(record: &Record, particulars: &Particulars, example: Option<Example>) -> Check {
    let example = example.unwrap_or(record.settings.example);
    let requirements = requirements(record, example);
    Check {
        example: match example {
            Example::Example1 => 1,
            Example::Example2 => 2,
        },
        pass: requirements
            .iter()
            .all(|requirement| requirement.outcome != Outcome::Fail),
        requirements,
        missing: missing(record, particulars),
    }
}

fn missing(record: &Record, particulars: &Particulars) -> Vec<Missing> {
    let certificate = Certificate::from_record(record, particulars);
    let mut missing = Vec::new();
    for section in &certificate.sections {
        for entry in &section.entries {
            if entry.value.is_none() && entry.clause.contains("16063-21") {
                let key = format!("{}.{}", section.key, entry.key);
                missing.push(Missing {
                    item: Language::En.word(&key).to_owned(),
                    clause: entry.clause.to_owned(),
                });
            }
        }
    }
    missing
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::testing;

    fn of<'a>(check: &'a Check, parameter: &str) -> &'a Requirement {
        let found = check
            .requirements
            .iter()
            .find(|requirement| requirement.parameter == parameter);
        found.expect("the row is there")
    }

    #[test]
    fn the_worst_point_decides_its_row() {
        let mut record = testing::record(&[80.0, 160.0, 1000.0]);
        let particulars = Particulars::default();
        let distortion = "total harmonic distortion";
        record.points[1].distortion_reference_rel = 0.10;
        let check = super::check(&record, &particulars, Some(Example::Example2));
        // Table 2, Example 2, above 20 Hz: 10 %, which 10 % fulfils.
        assert_eq!(of(&check, distortion).outcome, Outcome::Pass);
        assert_eq!(of(&check, distortion).limit.map(|l| l.round()), Some(10.0));
        record.points[1].distortion_reference_rel = 0.101;
        let check = super::check(&record, &particulars, Some(Example::Example2));
        assert_eq!(of(&check, distortion).outcome, Outcome::Fail);
        assert_eq!(of(&check, distortion).at_hz, Some(160.0));
        assert!(!check.pass);
        // A refused point has no result that could fail.
        record.points[1].verdict =
            calib_core::verdict::Verdict::Refused(calib_core::verdict::Reason::Distortion);
        let check = super::check(&record, &particulars, Some(Example::Example2));
        assert_eq!(of(&check, distortion).outcome, Outcome::Pass);
    }

    #[test]
    fn missing_statements_and_measurements_are_listed() {
        let record = testing::record(&[160.0]);
        let check = super::check(&record, &Particulars::default(), None);
        assert!(
            check
                .missing
                .iter()
                .any(|m| m.clause.contains("16063-21 7"))
        );
        let unmeasured = of(&check, "transverse, rocking motion");
        assert_eq!(unmeasured.outcome, Outcome::NotMeasured);
        let report = super::report(&check);
        assert!(report.contains("not measured"), "{report}");
        assert!(
            report.lines().all(|line| line.chars().count() <= 80),
            "{report}"
        );
    }
}
