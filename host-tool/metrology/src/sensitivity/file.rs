//! Readings from a table; its columns say which method it is.

use super::columns::Columns;
use super::conversion::Quantity;
use super::reading::Reading;
use crate::input::{Source, Table};
use calib_files::Result;
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
pub fn load(path: &Path, quantity: Quantity) -> Result<Readings> {
    parse(Source::read(path)?, quantity)
}

/// [`load`] from a text.
///
/// # Errors
/// As [`load`], without those of the file system.
pub fn parse(source: Source, quantity: Quantity) -> Result<Readings> {
    let table = Table::parse(source)?;
    let columns = Columns::of(&table)?;
    let mut points: Vec<(Reading, usize)> = Vec::new();
    for row in &table.rows {
        let reading = columns.reading(&table, row)?;
        columns.believable(&table, row, quantity)?;
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
    let unread = table.unread(&columns.all());
    let unread = unread
        .into_iter()
        .map(|name| format!("column '{name}' is not read"));
    let without =
        "S has no uncertainty here: `calib budget --template a1` begins the budget it needs";
    let remarks = unread.chain([without.to_owned()]).collect();
    Ok(Readings {
        points: points.into_iter().map(|(reading, _)| reading).collect(),
        with_phase: columns.dut.phase.is_some(),
        remarks,
    })
}
