//! Columns of a `points.csv`, and the values in one of its rows.

use crate::error::GapError;
use std::collections::HashMap;

/// Name of the table.
pub(super) const FILE: &str = "points.csv";

/// Where each column stands.
pub(super) struct Layout {
    /// Name, range and place of each known column.
    pub(super) columns: Vec<(String, Range, usize)>,
    /// Place of the label of the run.
    pub(super) run: Option<usize>,
}

impl Layout {
    pub(super) fn new(header: &csv::StringRecord) -> Result<Self, GapError> {
        let known = columns();
        let (mut columns, mut run) = (Vec::<(String, Range, usize)>::new(), None);
        for (at, name) in header.iter().enumerate() {
            let name = name.trim_start_matches('\u{feff}');
            if columns.iter().any(|c| c.0 == name) || (name == "run" && run.is_some()) {
                return Err(table(format!("column {name} appears twice")));
            }
            if name == "run" {
                run = Some(at);
            } else if let Some((_, range)) = known.iter().find(|(n, _)| n == name) {
                columns.push((name.to_owned(), *range, at));
            } else {
                return Err(table(unknown(name, &known)));
            }
        }
        if !columns.iter().any(|c| c.0 == "frequency_hz") {
            return Err(table(
                "column frequency_hz is missing; it is the one every table needs".into(),
            ));
        }
        Ok(Self { columns, run })
    }

    /// Names of the columns that held values.
    pub(super) fn names(&self, used: &[bool]) -> Vec<String> {
        let used = self.columns.iter().zip(used).filter(|(_, used)| **used);
        let names = used.map(|((name, ..), _)| name.clone());
        names.chain(self.run.map(|_| "run".to_owned())).collect()
    }

    /// Values of a row by column; marks the columns that have one as used.
    pub(super) fn parse<'a>(
        &'a self,
        row: &csv::StringRecord,
        used: &mut [bool],
    ) -> Result<HashMap<&'a str, f64>, GapError> {
        let line = row.position().map_or(0, |p| p.line() as usize);
        let mut values = HashMap::with_capacity(self.columns.len());
        for ((name, range, at), used) in self.columns.iter().zip(used) {
            let text = row.get(*at).unwrap_or("");
            if text.is_empty() {
                continue;
            }
            let cell = |problem: String| GapError::Cell {
                file: FILE,
                line,
                column: name.clone(),
                problem,
            };
            let value: f64 = text.parse().map_err(|_| {
                cell(format!(
                    "\"{text}\" is not a number; the decimal mark is a point"
                ))
            })?;
            if !value.is_finite() {
                return Err(cell(format!(
                    "\"{text}\" is not finite; leave the cell empty if nothing was measured"
                )));
            }
            if let Some(problem) = range.problem(value) {
                return Err(cell(format!(
                    "{text} {problem}; leave the cell empty if nothing was measured"
                )));
            }
            values.insert(name.as_str(), value);
            *used = true;
        }
        Ok(values)
    }
}

/// An unknown column, and the known one it may be meant for; else all there are.
fn unknown(name: &str, known: &[(String, Range)]) -> String {
    let names = || known.iter().map(|(known, _)| known.as_str());
    let nearest = names().min_by_key(|known| distance(known, name));
    // Of a misspelt one most characters are there.
    let hint =
        match nearest.filter(|nearest| 4 * distance(nearest, name) <= nearest.len() + name.len()) {
            Some(nearest) => format!("the nearest known one is {nearest}"),
            None => format!("known are run, {}", names().collect::<Vec<_>>().join(", ")),
        };
    format!("unknown column \"{name}\"; {hint}")
}

/// Number of characters that differ, for the hint after a misspelt column.
fn distance(a: &str, b: &str) -> usize {
    let common =
        a.chars().filter(|c| b.contains(*c)).count() + b.chars().filter(|c| a.contains(*c)).count();
    (a.len() + b.len()).saturating_sub(common)
}

/// A problem of the table as a whole.
pub(super) fn table(problem: String) -> GapError {
    GapError::Table {
        file: FILE,
        problem,
    }
}

/// Values a column can have: wide enough for every instrument, narrow enough to find a wrong unit or decimal mark.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range {
    lowest: f64,
    highest: f64,
    positive: bool,
}

impl Range {
    /// From `lowest` to `highest`, both allowed.
    const fn between(lowest: f64, highest: f64) -> Self {
        Self {
            lowest,
            highest,
            positive: false,
        }
    }

    /// Above zero; as small and as large as an amplitude can be that some instrument measures.
    const fn amplitude() -> Self {
        Self {
            lowest: 1e-15,
            highest: 1e9,
            positive: true,
        }
    }

    /// Problem of a value, and the expected one; `None` if it is sound.
    pub(super) fn problem(self, value: f64) -> Option<String> {
        if self.positive && value <= 0.0 || self.lowest == 0.0 && value < 0.0 {
            return Some("must be positive".into());
        }
        let range = self.lowest..=self.highest;
        (!range.contains(&value)).then(|| {
            format!(
                "is out of the range of this column, {:e} to {:e}; check its unit",
                self.lowest, self.highest
            )
        })
    }
}

/// All columns with numbers, and what each may hold.
pub(super) fn columns() -> Vec<(String, Range)> {
    let amplitude = Range::amplitude();
    let angle = Range::between(-1e6, 1e6);
    let voltage = Range::between(-1e6, 1e6);
    let fixed = [
        ("frequency_hz", amplitude),
        ("time_s", Range::between(-1e10, 1e10)),
        ("temperature_c", Range::between(-273.15, 1e4)),
        ("rotation_deg", angle),
        ("tilt_deg", angle),
        ("payload_kg", Range::between(0.0, 1e6)),
        ("acceleration_ms2", amplitude),
        ("coil_v", amplitude),
        ("coil_a", amplitude),
        ("coil_a_deg", angle),
        ("ref_v", amplitude),
        ("ref_deg", angle),
        ("dut_v", amplitude),
        ("dut_deg", angle),
        ("ratio", amplitude),
        ("ref_dc_v", voltage),
        ("dut_dc_v", voltage),
        ("ref_noise_v", amplitude),
        ("dut_noise_v", amplitude),
        ("u_ratio", amplitude),
        ("u_phase_deg", amplitude),
        ("u_drive", amplitude),
        ("u_current", amplitude),
        ("u_harmonic", amplitude),
        ("u_dc_v", amplitude),
    ];
    let mut all: Vec<_> = fixed
        .into_iter()
        .map(|(name, range)| (name.to_owned(), range))
        .collect();
    for channel in ["ref", "dut"] {
        for order in 2..=5 {
            all.push((format!("{channel}_h{order}"), Range::between(0.0, 1e3)));
            all.push((format!("{channel}_h{order}_deg"), angle));
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(column: &str, value: f64) -> Option<String> {
        let all = columns();
        let (_, range) = all.iter().find(|(name, _)| name == column).expect("column");
        range.problem(value)
    }

    #[test]
    fn a_value_no_instrument_has_is_named_and_all_others_pass() {
        for (column, value) in [
            ("temperature_c", -400.0),
            ("u_ratio", 1e-300),
            ("ref_dc_v", -1e300),
            ("payload_kg", -0.1),
            ("coil_v", 0.0),
        ] {
            assert!(problem(column, value).is_some(), "{column} {value}");
        }
        for (column, value) in [
            ("temperature_c", -196.0),
            ("ref_h3", 0.0),
            ("dut_deg", -720.0),
        ] {
            assert_eq!(problem(column, value), None, "{column}");
        }
    }
}
