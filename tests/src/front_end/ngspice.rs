//! Runs a deck of `hardware/` by the real ngspice and reads what it wrote.

use super::folder;
use crate::rigged::Fault;
use calib_twin::Complex;
use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::process::{Command, Output};
use tempfile::TempDir;

/// Output of a deck.
#[derive(Debug)]
pub struct Run {
    written: TempDir,
    printed: BTreeMap<String, f64>,
}

/// One row of a file that `wrdata` wrote.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// The vectors, in the deck's order.
    pub values: Vec<Complex<f64>>,
}

/// Runs `deck`; nothing when there is no ngspice, which is `CALIB_NGSPICE` or that of the path.
///
/// # Errors
/// ngspice ends with a failure, or names an error: its own words.
pub fn run(deck: &str) -> Result<Option<Run>, Fault> {
    let written = tempfile::tempdir()?;
    let program = std::env::var_os("CALIB_NGSPICE").unwrap_or_else(|| "ngspice".into());
    let mut command = Command::new(program);
    command
        .arg("-b")
        .arg(folder().join(deck))
        .current_dir(&written);
    let output = match command.output() {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        output => output?,
    };
    let printed = read_output(&output).map_err(|error| format!("ngspice, {deck}: {error}"))?;
    Ok(Some(Run { written, printed }))
}

fn read_output(output: &Output) -> Result<BTreeMap<String, f64>, String> {
    let errors = String::from_utf8_lossy(&output.stderr);
    let complaint = errors.lines().find(|line| line.contains("Error"));
    if !output.status.success() || complaint.is_some() {
        return Err(format!(
            "{}: {}",
            output.status,
            complaint.unwrap_or(&errors)
        ));
    }
    let text = String::from_utf8_lossy(&output.stdout);
    let numbers = text.lines().filter_map(|line| {
        let (name, value) = line.split_once(" = ")?;
        Some((name.trim().to_owned(), value.trim().parse().ok()?))
    });
    Ok(numbers.collect())
}

impl Run {
    /// A number the deck printed.
    ///
    /// # Errors
    /// It did not.
    pub fn printed(&self, name: &str) -> Result<f64, Fault> {
        let value = self.printed.get(name).copied();
        value.ok_or_else(|| format!("ngspice did not print {name}").into())
    }

    /// The rows of a file the deck wrote.
    ///
    /// # Errors
    /// No such file, or something in it that is no number.
    pub fn rows(&self, file: &str) -> Result<Vec<Row>, Fault> {
        let text = std::fs::read_to_string(self.written.path().join(file))
            .map_err(|error| format!("{file}: {error}"))?;
        text.lines().map(row).collect()
    }
}

fn row(line: &str) -> Result<Row, Fault> {
    let numbers: Vec<f64> = line
        .split_whitespace()
        .map(str::parse)
        .collect::<Result<_, _>>()
        .map_err(|error| format!("`{line}`: {error}"))?;
    let (frequency_hz, parts) = numbers.split_first().ok_or("an empty row")?;
    let values = parts
        .as_chunks::<2>()
        .0
        .iter()
        .map(|pair| Complex::new(pair[0], pair[1]));
    Ok(Row {
        frequency_hz: *frequency_hz,
        values: values.collect(),
    })
}
