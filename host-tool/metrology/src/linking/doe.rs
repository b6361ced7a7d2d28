//! Published degrees of equivalence: who is consistent with the reference?

use crate::input::{Column, Source, Table};
use calib_files::Result;
use schemars::JsonSchema;
use serde::Serialize;

/// One published degree of equivalence.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Degree {
    /// Laboratory.
    pub laboratory: String,
    /// Frequency, Hz; `None` when not stated.
    pub frequency_hz: Option<f64>,
    /// Degree of equivalence.
    pub d: f64,
    /// Its expanded uncertainty.
    #[serde(rename = "expanded_uncertainty")]
    pub u_expanded: f64,
}

/// A table of degrees of equivalence.
#[derive(Clone, Debug, PartialEq)]
pub struct DoeTable {
    /// Rows in the order of the file.
    pub degrees: Vec<Degree>,
    /// Columns that were not read.
    pub remarks: Vec<String>,
}

/// Outcome for a table.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Judgement {
    /// Rows judged.
    pub rows: usize,
    /// `|d|` above its expanded uncertainty.
    pub inconsistent: Vec<Degree>,
    /// `|d|` equal to its expanded uncertainty: consistent.
    pub on_limit: Vec<Degree>,
    /// The rule in words.
    pub rule: &'static str,
}

const RULE: &str = "inconsistent where |d| > U(d); a value exactly on its limit, |d| = U(d) \
(|E_n| = 1), is consistent and listed apart";

const FREQUENCY: &str = "frequency_hz frequency f_hz f";
const LABORATORY: &str = "laboratory lab nmi institute participant";
const DEGREE: &str = "degree_of_equivalence degree_of_equivalence_percent doe d di d_i d_percent";
const UNCERTAINTY: &str = "expanded_uncertainty expanded_uncertainty_percent u_expanded \
                           u_expanded_percent expanded_u u_k_2 2u 2ui 2u_i u_d";

/// Reads a table: laboratory, frequency, degree of equivalence and its
/// expanded uncertainty.
///
/// # Errors
/// A missing column, a value that cannot be, a laboratory twice at a frequency.
pub fn read_table(source: Source) -> Result<DoeTable> {
    let table = Table::parse(source)?;
    let laboratory = table.require("the laboratory", LABORATORY)?.clone();
    let frequency = table.find(FREQUENCY)?.cloned();
    let degree = table.require("the degree of equivalence", DEGREE)?.clone();
    let uncertainty = table
        .require("its expanded uncertainty", UNCERTAINTY)?
        .clone();
    let mut degrees: Vec<Degree> = Vec::new();
    for row in &table.rows {
        let entry = Degree {
            laboratory: table.text(row, &laboratory)?.to_owned(),
            frequency_hz: match &frequency {
                Some(column) => Some(table.number(row, column)?),
                None => None,
            },
            d: table.number(row, &degree)?,
            u_expanded: table.number(row, &uncertainty)?,
        };
        let problem = fault(&entry, &degrees);
        if let Some((problem, hint)) = problem {
            return Err(table.source.at_line(row.line, problem, hint));
        }
        degrees.push(entry);
    }
    let used: Vec<&Column> = [&laboratory, &degree, &uncertainty]
        .into_iter()
        .chain(&frequency)
        .collect();
    let remarks = table
        .unread(&used)
        .into_iter()
        .map(|name| format!("column '{name}' is not read"))
        .collect();
    Ok(DoeTable { degrees, remarks })
}

fn fault(entry: &Degree, earlier: &[Degree]) -> Option<(String, &'static str)> {
    if entry.frequency_hz.is_some_and(|f| f <= 0.0) {
        return Some((
            "the frequency is not greater than zero".into(),
            "write the frequency in hertz",
        ));
    }
    if entry.u_expanded <= 0.0 {
        return Some((
            format!(
                "expanded uncertainty {} is not greater than zero",
                entry.u_expanded
            ),
            "write the expanded uncertainty of the degree of equivalence",
        ));
    }
    let twin = earlier.iter().any(|other| {
        other.laboratory == entry.laboratory && other.frequency_hz == entry.frequency_hz
    });
    twin.then(|| {
        (
            format!("{} is there twice at this frequency", entry.laboratory),
            "keep one row for each laboratory and frequency",
        )
    })
}

/// Compares each degree of equivalence with its expanded uncertainty, as
/// written: published values are compared as they were published.
pub fn judge(degrees: &[Degree]) -> Judgement {
    let pick = |keep: fn(&Degree) -> bool| degrees.iter().filter(|d| keep(d)).cloned().collect();
    Judgement {
        rows: degrees.len(),
        inconsistent: pick(|degree| degree.d.abs() > degree.u_expanded),
        on_limit: pick(|degree| degree.d.abs() == degree.u_expanded),
        rule: RULE,
    }
}
