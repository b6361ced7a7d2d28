//! Transfer functions of the nominal circuit: magnitude, phase, group delay.

use super::ngspice::{Row, Run};
use crate::rigged::Fault;
use calib_twin::Complex;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Highest frequency that is kept, Hz.
const HIGHEST_HZ: f64 = 200e3;

/// First line of `hardware/response.csv`.
pub const HEADER: &str = "frequency_hz,\
    input_magnitude,input_phase_deg,input_group_delay_us,\
    drive_magnitude,drive_phase_deg,drive_group_delay_us,\
    iepe_magnitude,iepe_phase_deg,iepe_group_delay_us";

/// One path at one frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// Volts out per volt in.
    pub magnitude: f64,
    /// Phase, degrees, without jumps.
    pub phase_deg: f64,
    /// Group delay between the neighbouring frequencies, us.
    pub group_delay_us: f64,
}

impl Value {
    /// The transfer function.
    pub fn complex(&self) -> Complex<f64> {
        Complex::from_polar(self.magnitude, self.phase_deg.to_radians())
    }
}

/// All paths at one frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Connector to converter.
    pub input: Value,
    /// Drive converter to power amplifier.
    pub drive: Value,
    /// IEPE transducer to input connector.
    pub iepe: Value,
}

/// Response by `response.cir`, to 200 kHz.
///
/// # Errors
/// The file is not there or not as expected.
pub fn of(run: &Run) -> Result<Vec<Line>, Fault> {
    let rows = run.rows("response.txt")?;
    // One row beyond, for the group delay of the last.
    let kept = rows
        .iter()
        .filter(|row| row.frequency_hz < HIGHEST_HZ)
        .count();
    let paths = [0, 1, 2].map(|path| values(&rows, path));
    let line = |index: usize| -> Option<Line> {
        let [input, drive, iepe] = [0, 1, 2].map(|path| paths[path].get(index).copied());
        Some(Line {
            frequency_hz: rows[index].frequency_hz,
            input: input?,
            drive: drive?,
            iepe: iepe?,
        })
    };
    let lines: Option<Vec<_>> = (0..kept).map(line).collect();
    lines.ok_or_else(|| "response.txt lacks a vector".into())
}

/// One vector of `rows`; empty when a row lacks it.
fn values(rows: &[Row], path: usize) -> Vec<Value> {
    let Some(transfer) = rows
        .iter()
        .map(|row| row.values.get(path).copied())
        .collect::<Option<Vec<_>>>()
    else {
        return Vec::new();
    };
    let mut phase_rad = 0.0;
    let phases: Vec<f64> = transfer
        .iter()
        .map(|value| {
            phase_rad += (value * Complex::from_polar(1.0, -phase_rad)).arg();
            phase_rad
        })
        .collect();
    let delay_us = |index: usize| {
        let (before, after) = (index.saturating_sub(1), (index + 1).min(rows.len() - 1));
        let span_hz = rows[after].frequency_hz - rows[before].frequency_hz;
        (phases[before] - phases[after]) / (TAU * span_hz) * 1e6
    };
    let value = |(index, value): (usize, &Complex<f64>)| Value {
        magnitude: value.norm(),
        phase_deg: phases[index].to_degrees(),
        group_delay_us: delay_us(index),
    };
    transfer.iter().enumerate().map(value).collect()
}

/// As `hardware/response.csv` has it.
pub fn to_csv(lines: &[Line]) -> String {
    let mut text = format!("{HEADER}\n");
    for line in lines {
        let _ = write!(text, "{:.6e}", line.frequency_hz);
        for value in [line.input, line.drive, line.iepe] {
            let _ = write!(
                text,
                ",{:.6e},{:.4},{:.3}",
                value.magnitude, value.phase_deg, value.group_delay_us
            );
        }
        text.push('\n');
    }
    text
}

/// Reads `hardware/response.csv`.
///
/// # Errors
/// Other columns, or no number: the line.
pub fn from_csv(text: &str) -> Result<Vec<Line>, Fault> {
    let mut lines = text.lines();
    if lines.next() != Some(HEADER) {
        return Err("response.csv has other columns".into());
    }
    lines.map(csv_line).collect()
}

fn csv_line(line: &str) -> Result<Line, Fault> {
    let numbers: Vec<f64> = line
        .split(',')
        .map(str::parse)
        .collect::<Result<_, _>>()
        .map_err(|error| format!("response.csv, `{line}`: {error}"))?;
    let [frequency_hz, rest @ ..] = numbers.as_slice() else {
        return Err("response.csv has an empty line".into());
    };
    let value = |at: usize| -> Result<Value, Fault> {
        match rest.get(3 * at..3 * at + 3) {
            Some(&[magnitude, phase_deg, group_delay_us]) => Ok(Value {
                magnitude,
                phase_deg,
                group_delay_us,
            }),
            _ => Err(format!("response.csv, `{line}`: columns are missing").into()),
        }
    };
    Ok(Line {
        frequency_hz: *frequency_hz,
        input: value(0)?,
        drive: value(1)?,
        iepe: value(2)?,
    })
}

/// Where `found` is not `committed`: the first frequency, or a count; nothing when they agree.
///
/// The tolerance covers the digits of the file and another ngspice's rounding, and is a
/// hundredth of what the circuit may be off the twin.
pub fn difference(committed: &[Line], found: &[Line]) -> Option<String> {
    if committed.len() != found.len() {
        return Some(format!("{} lines, not {}", found.len(), committed.len()));
    }
    let differs = |(a, b): (&Line, &Line)| {
        let near = (a.frequency_hz / b.frequency_hz - 1.0).abs() < 1e-4;
        let pairs = [(a.input, b.input), (a.drive, b.drive), (a.iepe, b.iepe)];
        let same = |(a, b): (Value, Value)| (a.complex() / b.complex() - 1.0).norm() < 5e-6;
        (!near || !pairs.into_iter().all(same)).then(|| format!("at {} Hz", a.frequency_hz))
    };
    committed.iter().zip(found).find_map(differs)
}
