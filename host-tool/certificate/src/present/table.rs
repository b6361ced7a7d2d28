//! The table over frequency in words.

use super::columns::{Column, columns};
use crate::model::{Certificate, Point};
use crate::words::Language;
use serde::Serialize;

/// A table of strings.
#[derive(Clone, Debug, Serialize)]
pub struct Table {
    /// Heading and unit of each column.
    pub columns: Vec<(String, String)>,
    /// Rows; refused ones end in the reason.
    pub rows: Vec<Row>,
}

/// A row of the table over frequency.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// One cell per column.
    pub cells: Vec<String>,
    /// True when the point has no result.
    pub refused: bool,
    /// True at the reference point.
    pub reference: bool,
}

/// The table over frequency, with the columns the laboratory wants.
pub(super) fn table(certificate: &Certificate, language: Language) -> Table {
    let wanted = &certificate.particulars.layout.columns;
    let broadband = certificate
        .points
        .iter()
        .any(|p| p.view.coherence.is_some());
    let kind = certificate.kind;
    let mut columns: Vec<Column> = match wanted.is_empty() {
        true => columns()
            .filter(|column| column.usual && (column.name != "coherence" || broadband))
            .collect(),
        false => wanted
            .iter()
            .filter_map(|name| columns().find(|column| column.name == name))
            .collect(),
    };
    columns.retain(|column| column.unit(kind).is_some());
    let heading = |column: &Column| {
        let unit = column.unit(kind).unwrap_or_default();
        (column.heading(language), unit.to_owned())
    };
    let row = |(index, point): (usize, &Point)| Row {
        cells: columns
            .iter()
            .map(|column| column.cell(point, language))
            .collect(),
        refused: point.outcome.is_err(),
        reference: certificate.reference == Some(index),
    };
    Table {
        columns: columns.iter().map(heading).collect(),
        rows: certificate.points.iter().enumerate().map(row).collect(),
    }
}
