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
