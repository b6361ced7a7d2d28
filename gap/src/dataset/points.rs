//! `points.csv`: steady-state sine points.

use super::cells::Cells;
use super::layout::{Layout, table};
use super::point::Measured;
use crate::error::GapError;
use std::collections::HashMap;
use std::io::Read;

/// Largest table that is read: a diagnosis keeps about 30 kB per row, and takes
/// minutes beyond this.
const MOST_ROWS: usize = 10_000;

/// Reads the table of points.
///
/// # Errors
/// Unknown or duplicate columns, unusable cells, values without their uncertainty, too few or too many rows.
pub(super) fn read(input: impl Read) -> Result<Measured, GapError> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(input);
    let header = reader.headers().map_err(|e| table(e.to_string()))?.clone();
    let layout = Layout::new(&header)?;
    let mut points = Vec::new();
    let mut run_index = HashMap::new();
    let mut used = vec![false; layout.columns.len()];
    let mut row = csv::StringRecord::new();
    while reader
        .read_record(&mut row)
        .map_err(|e| table(e.to_string()))?
    {
        if points.len() == MOST_ROWS {
            return Err(table(format!(
                "more than {MOST_ROWS} rows; average points of the same run and conditions first"
            )));
        }
        let cells = Cells {
            line: row.position().map_or(0, |p| p.line() as usize),
            values: layout.parse(&row, &mut used)?,
        };
        let label = layout.run.and_then(|at| row.get(at)).unwrap_or("");
        let next = run_index.len();
        let run = *run_index.entry(label.to_owned()).or_insert(next);
        points.push(cells.point(run)?);
    }
    if points.len() < 2 {
        return Err(table(format!(
            "{} row(s); a diagnosis needs at least two points",
            points.len()
        )));
    }
    let columns = layout.names(&used);
    Ok(Measured::Points { points, columns })
}
