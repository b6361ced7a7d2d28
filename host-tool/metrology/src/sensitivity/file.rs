//! Readings from a table; its columns say which method it is.

use super::reading::{Reading, Values};
use crate::input::{Column, Row, Source, Table};
use calib_core::consecutive::Consecutive;
use calib_files::Result;
use num_complex::Complex32;
use std::path::Path;

/// Points of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Readings {
    /// Points in the order of the file.
    pub points: Vec<Reading>,
    /// Phases were measured.
    pub with_phase: bool,
    /// Remarks for the reader.
    pub remarks: Vec<String>,
}

/// Reads a table of readings.
///
/// # Errors
/// [`calib_files::Error::File`], and [`calib_files::Error::Input`] with file, line and
/// remedy.
pub fn load(path: &Path) -> Result<Readings> {
    parse(Source::read(path)?)
}

/// [`load`] from a text.
///
/// # Errors
/// As [`load`], without those of the file system.
pub fn parse(source: Source) -> Result<Readings> {
    let table = Table::parse(source)?;
    let columns = Columns::of(&table)?;
    let mut points: Vec<(Reading, usize)> = Vec::new();
    for row in &table.rows {
        let reading = columns.reading(&table, row)?;
        let twin = points
            .iter()
            .find(|(other, _)| other.frequency_hz == reading.frequency_hz);
        if let Some((_, line)) = twin {
            return Err(table.source.at_line(
                row.line,
                format!(
                    "{} Hz is there twice, first in line {line}",
                    reading.frequency_hz
                ),
                "average repeated readings, or remove one of them",
            ));
        }
        points.push((reading, row.line));
    }
    let remarks = table
        .unread(&columns.all())
        .into_iter()
        .map(|name| format!("column '{name}' is not read"))
        .collect();
    Ok(Readings {
        points: points.into_iter().map(|(reading, _)| reading).collect(),
        with_phase: columns.dut.phase.is_some(),
        remarks,
    })
}

/// Magnitude with the phase beside it, if there is one.
#[derive(Clone, Copy)]
struct Polar<'a> {
    magnitude: &'a Column,
    phase: Option<&'a Column>,
}

impl<'a> Polar<'a> {
    fn find(table: &'a Table, magnitude: &str, phase: &str) -> Result<Option<Self>> {
        let phase = table.find(&[phase])?;
        Ok(table
            .find(&[magnitude])?
            .map(|magnitude| Self { magnitude, phase }))
    }

    fn require(table: &'a Table, magnitude: &str, phase: &str) -> Result<Self> {
        Ok(Self {
            magnitude: table.require(magnitude, &[magnitude])?,
            phase: table.find(&[phase])?,
        })
    }

    fn value(&self, table: &Table, row: &Row) -> Result<Complex32> {
        let magnitude = positive(table, row, self.magnitude)?;
        let degrees = match self.phase {
            Some(column) => table.number(row, column)?,
            None => 0.0,
        };
        Ok(Complex32::from_polar(
            magnitude,
            degrees.to_radians() as f32,
        ))
    }
}

fn positive(table: &Table, row: &Row, column: &Column) -> Result<f32> {
    let value = table.number(row, column)? as f32;
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    Err(table.source.at_line(
        row.line,
        format!("{} = {value} is not above zero", column.written),
        "amplitudes, sensitivities and frequencies are positive; a sign is a phase of 180",
    ))
}

/// The columns of each method.
struct Columns<'a> {
    frequency: &'a Column,
    dut: Polar<'a>,
    method: Method<'a>,
}

enum Method<'a> {
    Comparison {
        reference: Polar<'a>,
        output: Polar<'a>,
    },
    Consecutive {
        reference: Polar<'a>,
        before: Polar<'a>,
        after: Polar<'a>,
    },
    Calibrator {
        amplitude: &'a Column,
    },
}

impl<'a> Columns<'a> {
    fn of(table: &'a Table) -> Result<Self> {
        let frequency = table.require("the frequency", &["frequency_hz", "f", "f_hz"])?;
        let dut = Polar::require(table, "dut_v", "dut_deg")?;
        let before = Polar::find(table, "reference_before_v", "reference_before_deg")?;
        let output = Polar::find(table, "reference_v", "reference_deg")?;
        let reference =
            || Polar::require(table, "reference_sensitivity", "reference_sensitivity_deg");
        let method = match (before, output) {
            (Some(before), _) => Method::Consecutive {
                reference: reference()?,
                before,
                after: Polar::require(table, "reference_after_v", "reference_after_deg")?,
            },
            (None, Some(output)) => Method::Comparison {
                reference: reference()?,
                output,
            },
            (None, None) => Method::Calibrator {
                amplitude: table.require(
                    "the reference (reference_v, reference_before_v) or the amplitude",
                    &["amplitude"],
                )?,
            },
        };
        Ok(Self {
            frequency,
            dut,
            method,
        })
    }

    fn all(&self) -> Vec<&Column> {
        let polars = match &self.method {
            Method::Comparison { reference, output } => vec![reference, output],
            Method::Consecutive {
                reference,
                before,
                after,
            } => vec![reference, before, after],
            Method::Calibrator { .. } => Vec::new(),
        };
        let mut all = vec![self.frequency];
        if let Method::Calibrator { amplitude } = self.method {
            all.push(amplitude);
        }
        for polar in polars.into_iter().chain([&self.dut]) {
            all.push(polar.magnitude);
            all.extend(polar.phase);
        }
        all
    }

    fn reading(&self, table: &Table, row: &Row) -> Result<Reading> {
        let dut = self.dut.value(table, row)?;
        let values = match &self.method {
            Method::Comparison { reference, output } => Values::Comparison {
                reference: reference.value(table, row)?,
                reference_output: output.value(table, row)?,
                dut,
            },
            Method::Consecutive {
                reference,
                before,
                after,
            } => Values::Consecutive {
                reference: reference.value(table, row)?,
                readings: Consecutive {
                    before: before.value(table, row)?,
                    dut,
                    after: after.value(table, row)?,
                },
            },
            Method::Calibrator { amplitude } => Values::Calibrator {
                amplitude: positive(table, row, amplitude)?,
                dut,
            },
        };
        Ok(Reading {
            frequency_hz: positive(table, row, self.frequency)?,
            values,
        })
    }
}
