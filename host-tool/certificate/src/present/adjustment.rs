//! Results before and after an adjustment in words.

use super::columns::{DASH, cell, state, value_of};
use super::table::{Row, Table};
use crate::adjustment;
use crate::model::{Certificate, Point, PointValues};
use crate::words::Language;

/// Results before and after an adjustment, side by side.
pub(super) fn as_found(certificate: &Certificate, language: Language) -> Option<(Table, String)> {
    let found = certificate.as_found.as_deref()?;
    let heading = |key: &str, unit: &str| {
        let word = language.word(&format!("column.{key}")).to_owned();
        (word, unit.to_owned())
    };
    let unit = certificate.kind.stated_unit().printed();
    let mut columns = vec![
        heading("frequency", "Hz"),
        heading("acceleration", "m/s²"),
        heading("as_found", unit),
        heading("uncertainty", "%"),
        heading("as_left", unit),
        heading("uncertainty", "%"),
        heading("change", "%"),
    ];
    if certificate.decision.is_some() {
        columns.extend([
            heading("conformity_found", ""),
            heading("conformity_left", ""),
        ]);
    }
    let row = |(index, (left, found)): (usize, (&Point, Option<&Point>))| {
        let mut cells = vec![
            language.shortest(left.nominal_frequency_hz),
            language.shortest(left.nominal_acceleration_ms2),
        ];
        cells.extend(found.map_or([DASH.to_owned(), DASH.to_owned()], |p| result(p, language)));
        cells.extend(result(left, language));
        cells.push(cell(left, |values| {
            let change = adjustment::change_percent(found, left)?;
            Some(language.number(change, values.printed_uncertainty_percent.1))
        }));
        if certificate.decision.is_some() {
            cells.push(found.map_or(DASH.to_owned(), |p| state(p, language)));
            cells.push(state(left, language));
        }
        Row {
            cells,
            refused: left.outcome.is_err(),
            reference: certificate.reference == Some(index),
        }
    };
    let rows = certificate.pairs().enumerate().map(row).collect();
    let day = found.day.map_or(DASH.to_owned(), |day| day.to_string());
    let note = language.phrase("as_found.note", &[&found.number, &day]);
    Some((Table { columns, rows }, note))
}

/// Sensitivity and U of a point.
fn result(point: &Point, language: Language) -> [String; 2] {
    let uncertainty = |values: &PointValues| {
        let (percent, decimals) = values.printed_uncertainty_percent;
        Some(language.number(percent, decimals))
    };
    [
        cell(point, |v| Some(value_of(&v.printed, language))),
        cell(point, uncertainty),
    ]
}
