//! `record.csv`: input and output of an oscillator, uniformly sampled.

use crate::error::GapError;
use std::io::Read;

/// Longest record that is read; more samples than this never change a diagnosis.
pub(crate) const MOST_SAMPLES: usize = 2_000_000;

/// Sampling intervals that some instrument has, in s.
const STEPS_S: std::ops::RangeInclusive<f64> = 1e-12..=1e6;

/// A uniformly sampled record.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Record {
    /// Sampling interval, in s.
    pub(crate) interval_s: f64,
    /// Samples of the file before the first one here.
    pub(crate) before: usize,
    /// Input, in the unit of the file; zeros where it is the same in all rows.
    pub(crate) input: Vec<f64>,
    /// Output, in the unit of the file.
    pub(crate) output: Vec<f64>,
}

const FILE: &str = "record.csv";
const COLUMNS: [&str; 3] = ["time_s", "input", "output"];

/// Reads a record.
///
/// # Errors
/// Missing or unknown columns, values that are no numbers, time steps that differ by more than 1 %.
pub(super) fn read(input: impl Read) -> Result<Record, GapError> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(input);
    let header = reader.headers().map_err(|e| table(e.to_string()))?;
    let index = places(header)?;
    let mut columns: [Vec<f64>; 3] = Default::default();
    let mut row = csv::StringRecord::new();
    while reader
        .read_record(&mut row)
        .map_err(|e| table(e.to_string()))?
    {
        let line = columns[0].len() + 2;
        if columns[0].len() == MOST_SAMPLES {
            return Err(table(format!(
                "more than {MOST_SAMPLES} samples; cut the record"
            )));
        }
        for ((column, &at), name) in columns.iter_mut().zip(&index).zip(COLUMNS) {
            column.push(value(row.get(at).unwrap_or(""), line, name)?);
        }
    }
    let [time, input, output] = columns;
    let interval_s = interval(&time)?;
    varies("output", &output)?;
    let input = without_rest(input);
    Ok(Record {
        interval_s,
        before: 0,
        input,
        output,
    })
}

/// Where each of [`COLUMNS`] stands.
fn places(header: &csv::StringRecord) -> Result<[usize; 3], GapError> {
    if let Some(unknown) = header.iter().find(|name| !COLUMNS.contains(name)) {
        return Err(table(format!(
            "unknown column \"{unknown}\"; a record has {}",
            COLUMNS.join(", ")
        )));
    }
    let mut index = [0; 3];
    for (slot, name) in index.iter_mut().zip(COLUMNS) {
        *slot = header.iter().position(|h| h == name).ok_or_else(|| {
            let decay = match name {
                "input" => "; of a free decay it has the same value in all rows",
                _ => "",
            };
            table(format!("column {name} is missing{decay}"))
        })?;
    }
    Ok(index)
}

fn value(text: &str, line: usize, column: &str) -> Result<f64, GapError> {
    let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
    value.ok_or_else(|| GapError::Cell {
        file: FILE,
        line,
        column: column.into(),
        problem: format!("\"{text}\" is not a finite number"),
    })
}

/// Time between two samples, in s.
fn interval(time_s: &[f64]) -> Result<f64, GapError> {
    if time_s.len() < 100 {
        return Err(table(format!(
            "{} samples; a fit needs at least 100",
            time_s.len()
        )));
    }
    let interval = (time_s[time_s.len() - 1] - time_s[0]) / (time_s.len() - 1) as f64;
    let uneven = time_s
        .windows(2)
        .position(|w| (w[1] - w[0] - interval).abs() > 0.01 * interval.abs());
    if !(interval <= 0.0 || uneven.is_some()) && !STEPS_S.contains(&interval) {
        return Err(table(format!(
            "column time_s: a step of {interval:e} s is out of the range {:e} s to {:e} s",
            STEPS_S.start(),
            STEPS_S.end()
        )));
    }
    if interval <= 0.0 || uneven.is_some() {
        let at = uneven.unwrap_or(0);
        let step = time_s[at + 1] - time_s[at];
        return Err(GapError::Cell {
            file: FILE,
            line: at + 3,
            column: "time_s".into(),
            problem: format!(
                "not uniformly sampled: a step of {step:e} s, {interval:e} s in the mean; interpolate the record \
                 to even steps, or cut it here"
            ),
        });
    }
    Ok(interval)
}

/// An input that stays where it is only moves the rest, and so does the zero of the output.
fn without_rest(input: Vec<f64>) -> Vec<f64> {
    match input.windows(2).all(|w| w[0] == w[1]) {
        true => vec![0.0; input.len()],
        false => input,
    }
}

/// A constant says nothing about an oscillator, and cannot be scaled.
fn varies(column: &str, values: &[f64]) -> Result<(), GapError> {
    if values.windows(2).all(|w| w[0] == w[1]) {
        return Err(table(format!(
            "column {column} is the same in all rows; a fit needs a record of motion"
        )));
    }
    Ok(())
}

fn table(problem: String) -> GapError {
    GapError::Table {
        file: FILE,
        problem,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A record of 200 samples of 1 ms of which one tick is missing.
    fn record(header: &str) -> String {
        let sample = |n: usize| {
            let skipped = usize::from(n > 120);
            format!("{:.3},0,{}", 1e-3 * (n + skipped) as f64, n % 7)
        };
        let lines = (0..200).map(sample);
        std::iter::once(header.to_owned())
            .chain(lines)
            .collect::<Vec<_>>()
            .join("\n")
    }

    #[test]
    fn what_is_refused_is_told_the_way_out() {
        let refused = |text: &str| read(text.as_bytes()).expect_err("no record").to_string();
        let skipped = refused(&record("time_s,input,output"));
        assert!(skipped.starts_with("record.csv, line 123"), "{skipped}");
        assert!(skipped.contains("interpolate"), "{skipped}");
        let decay = refused("time_s,output\n0,1\n");
        assert!(decay.contains("free decay"), "{decay}");
    }
}
