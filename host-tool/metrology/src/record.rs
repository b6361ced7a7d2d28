//! Time records: equally spaced samples of one or two signals.

use super::input::{Column, Source, Table};
use calib_files::Result;

/// A sampled record.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeRecord {
    /// Samples per second, Hz.
    pub sample_rate_hz: f64,
    /// Time of the first sample, s.
    pub start_s: f64,
    /// Acceleration, m/s2 or a multiple of it.
    pub input: Option<Vec<f64>>,
    /// Output of the transducer.
    pub output: Option<Vec<f64>>,
}

const TIME: &str = "time_s time t_s t";
const INPUT: &str = "input input_* acceleration acceleration_* a a_ms2";
const OUTPUT: &str = "output output_* charge charge_* voltage voltage_* x";
/// Largest deviation of a time step from the mean, of that mean: printed
/// times are rounded.
const JITTER: f64 = 0.02;

/// Reads a record with columns for time and input, output or both.
///
/// # Errors
/// A missing column, fewer than eight samples, times that are not equally
/// spaced: named with line and remedy.
pub fn read(source: Source) -> Result<TimeRecord> {
    let table = Table::parse(source)?;
    let time = values(&table, table.require("time", TIME)?)?;
    let input = optional(&table, INPUT)?;
    let output = optional(&table, OUTPUT)?;
    if input.is_none() && output.is_none() {
        table.require("the signal", "input output")?;
    }
    if time.len() < 8 {
        return Err(table.source.at_line(
            table.header_line,
            format!("{} samples are too few for a record", time.len()),
            "give the whole shock, with some samples before it",
        ));
    }
    let step = (time[time.len() - 1] - time[0]) / (time.len() - 1) as f64;
    for (index, pair) in time.windows(2).enumerate() {
        let own = pair[1] - pair[0];
        // A printed time is rounded; allow its last digit as well.
        if (own - step).abs() > JITTER * step.abs() + 1e-12 || step <= 0.0 {
            return Err(table.source.at_line(
                table.rows[index + 1].line,
                format!("time step {own:e} s, but {step:e} s on average"),
                "samples must be equally spaced and rising in time",
            ));
        }
    }
    Ok(TimeRecord {
        sample_rate_hz: 1.0 / step,
        start_s: time[0],
        input,
        output,
    })
}

fn optional(table: &Table, names: &str) -> Result<Option<Vec<f64>>> {
    match table.find(names)? {
        Some(column) => values(table, column).map(Some),
        None => Ok(None),
    }
}

fn values(table: &Table, column: &Column) -> Result<Vec<f64>> {
    table
        .rows
        .iter()
        .map(|row| table.number(row, column))
        .collect()
}

/// Removes the mean of the first hundredth of a record, before the shock.
pub fn without_offset(values: &[f64]) -> Vec<f64> {
    let count = (values.len() / 100).max(1);
    let offset = values[..count].iter().sum::<f64>() / count as f64;
    values.iter().map(|value| value - offset).collect()
}
