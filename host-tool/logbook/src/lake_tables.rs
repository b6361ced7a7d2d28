//! Tables of a lake: what each record is there, in rows.

use super::Logbook;
use super::records::Content;
use super::table::{Part, Table};
use calib_certificate::{Certificate, Particulars};
use calib_core::settings::Settings;
use calib_files::{Error, Result};
use rusqlite::params;
use rusqlite::types::ValueRef;
use serde_json::Value;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

/// `WHERE` of every question: instrument and year of a partition.
const OF_PARTITION: &str = "records.instrument = ?1 AND iif(unix_time_s > 0,
    CAST(strftime('%Y', unix_time_s, 'unixepoch') AS INTEGER), 0) = ?2";

/// Tables in the order they are written. Columns are only ever added, and at the end.
pub(super) const LAKE_TABLES: [Table; 5] = [
    Table {
        name: "points",
        columns: "record_sha256 text, instrument_serial text, time time, dut_serial text, \
                  dut_model text, operator text, position integer, frequency_hz real, \
                  set_acceleration_rms_ms2 real, state text, reason_text text, \
                  sensitivity_v_per_ms2 real, expanded_uncertainty_rel real, coverage_factor real, \
                  phase_deg real, expanded_uncertainty_phase_deg real",
        select: "SELECT id, lower(hex(sha256)), instrument,
                 iif(unix_time_s > 0, 1000 * unix_time_s, NULL), sensor_serial, sensor_model, operator, position,
                 frequency_hz, acceleration_rms_ms2,
                 CASE state WHEN 'valid' THEN 'valid' ELSE 'refused' END,
                 nullif(substr(state, length('refused: ') + 1), ''),
                 points.sensitivity_v_per_ms2, points.expanded_uncertainty_rel, coverage_factor,
                 57.29577951308232 * phase_rad, 57.29577951308232 * expanded_uncertainty_phase_rad
                 FROM records JOIN points ON record = id",
    },
    Table {
        name: "settings",
        columns: "record_sha256 text, instrument_serial text, time time, key text, value_number real, \
                  value_text text",
        select: "",
    },
    Table {
        name: "budgets",
        columns: "record_sha256 text, instrument_serial text, time time, row integer, value_rel real, \
                  distribution text, divisor real, sensitivity_coefficient real, \
                  contribution_rel real, degrees_of_freedom real",
        select: "",
    },
    Table {
        name: "checks",
        columns: "record_sha256 text, instrument_serial text, time time, check_serial text, \
                  every_days integer, frequency_hz real, state text, sensitivity_v_per_ms2 real, \
                  expanded_uncertainty_rel real, certified_v_per_ms2 real, \
                  certified_expanded_uncertainty_rel real",
        select: "SELECT id, lower(hex(sha256)), instrument,
                 iif(unix_time_s > 0, 1000 * unix_time_s, NULL), check_standards.serial, every_days,
                 points.frequency_hz, CASE state WHEN 'valid' THEN 'valid' ELSE 'refused' END,
                 points.sensitivity_v_per_ms2, points.expanded_uncertainty_rel, certified_v_per_ms2,
                 certified_expanded_uncertainty_rel
                 FROM check_standards JOIN records ON sensor_serial = check_standards.serial
                 JOIN points ON record = id AND abs(points.frequency_hz / check_standards.frequency_hz - 1) < 0.01",
    },
    Table {
        name: "records",
        columns: "record_sha256 text, instrument_serial text, record_id integer, time time, \
                  kind text, dut_serial text, dut_model text, operator text, complete boolean, \
                  points integer, refused integer, reference_frequency_hz real, \
                  sensitivity_v_per_ms2 real, expanded_uncertainty_rel real",
        select: "SELECT id, lower(hex(sha256)), instrument, number,
                 iif(unix_time_s > 0, 1000 * unix_time_s, NULL), kind, sensor_serial, sensor_model, operator,
                 complete, points, refused, reference_frequency_hz, sensitivity_v_per_ms2,
                 expanded_uncertainty_rel FROM records",
    },
];

/// Rows of these records of a partition, table by table.
pub(super) fn rows(
    logbook: &Logbook,
    partition: &Partition,
    ids: &HashSet<i64>,
) -> Result<Vec<Part>> {
    let mut parts: Vec<Part> = LAKE_TABLES.iter().map(|table| table.empty(None)).collect();
    for (table, part) in LAKE_TABLES.iter().zip(&mut parts) {
        if !table.select.is_empty() {
            asked(logbook, table, partition, ids, part)?;
        }
    }
    let [_, settings, budgets, ..] = &mut parts[..] else {
        return Ok(parts);
    };
    let mut ordered: Vec<i64> = ids.iter().copied().collect();
    ordered.sort_unstable();
    for id in ordered {
        read(&logbook.record(id)?, settings, budgets)?;
    }
    Ok(parts)
}

/// Rows that the tables of the logbook have.
fn asked(
    logbook: &Logbook,
    table: &Table,
    partition: &Partition,
    ids: &HashSet<i64>,
    part: &mut Part,
) -> Result<()> {
    let sql = format!("{} WHERE {OF_PARTITION} ORDER BY id", table.select);
    let of = params![partition.instrument, partition.year];
    logbook.all(&sql, of, |row| {
        if ids.contains(&row.get(0)?) {
            for (index, values) in part.columns.iter_mut().enumerate() {
                values.push(row.get_ref(index + 1)?);
            }
        }
        Ok(())
    })?;
    Ok(())
}

/// Rows that only the record itself has.
fn read(bytes: &[u8], settings: &mut Part, budgets: &mut Part) -> Result<()> {
    let unusable = |error: &dyn std::fmt::Display| {
        Error::input(
            "record of the logbook",
            error.to_string(),
            "`calib logbook check` says which, and what to do",
        )
    };
    let content = Content::of(bytes).map_err(|error| unusable(&error))?;
    let (head, in_force): (_, &Settings) = match &content {
        Content::Calibration(record) => (&record.head, &record.settings),
        Content::ReferenceChange(change) => (&change.head, &change.settings),
    };
    let time_ms = i64::try_from(head.labels.unix_time_s).ok();
    let time_ms = time_ms.filter(|at| *at > 0).map(|at| 1000 * at);
    let sum = hex::encode(calib_protocol::record::digest(bytes));
    let whose = [Cell::Text(&sum), Cell::Text(&head.instrument_serial)];
    let whose = [&whose[..], &[time_ms.map_or(Cell::None, Cell::Integer)]].concat();
    let value = serde_json::to_value(in_force).map_err(|error| unusable(&error))?;
    flatten("", &value, &mut |key, number, text| {
        let said = [
            Cell::Text(key),
            number.map_or(Cell::None, Cell::Real),
            text.map_or(Cell::None, Cell::Text),
        ];
        settings.row(whose.iter().chain(&said));
    });
    let Content::Calibration(record) = &content else {
        return Ok(());
    };
    let certificate = Certificate::from_record(record, &Particulars::default());
    for row in certificate.budget.iter().flat_map(|budget| &budget.rows) {
        let freedom = Some(row.degrees_of_freedom).filter(|freedom| freedom.is_finite());
        let said = [
            Cell::Integer(row.row.into()),
            Cell::Real(row.value_percent / 100.0),
            Cell::Text(row.distribution.0),
            Cell::Real(row.divisor),
            Cell::Real(row.sensitivity_coefficient),
            Cell::Real(row.contribution_percent / 100.0),
            freedom.map_or(Cell::None, Cell::Real),
        ];
        budgets.row(whose.iter().chain(&said));
    }
    Ok(())
}

/// Tells every value of a document with its path, such as `reference.points[3].frequency_hz`.
fn flatten(key: &str, value: &Value, tell: &mut impl FnMut(&str, Option<f64>, Option<&str>)) {
    match value {
        Value::Object(members) => {
            for (name, member) in members {
                let below = match key {
                    "" => name.clone(),
                    some => format!("{some}.{name}"),
                };
                flatten(&below, member, tell);
            }
        }
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                flatten(&format!("{key}[{index}]"), item, tell);
            }
        }
        Value::Null => {}
        Value::Bool(is) => tell(key, Some(f64::from(u8::from(*is))), None),
        Value::Number(number) => tell(key, number.as_f64(), None),
        Value::String(text) => tell(key, None, Some(text)),
    }
}

/// A cell of a row.
#[derive(Clone, Copy)]
enum Cell<'a> {
    None,
    Text(&'a str),
    Real(f64),
    Integer(i64),
}

impl Part {
    fn row<'a>(&mut self, cells: impl Iterator<Item = &'a Cell<'a>>) {
        for (values, cell) in self.columns.iter_mut().zip(cells) {
            values.push(match *cell {
                Cell::None => ValueRef::Null,
                Cell::Text(text) => ValueRef::Text(text.as_bytes()),
                Cell::Real(value) => ValueRef::Real(value),
                Cell::Integer(value) => ValueRef::Integer(value),
            });
        }
    }
}

/// Where the records of an instrument and year are.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Partition {
    pub(super) instrument: String,
    /// UTC; 0 where the time is not known.
    pub(super) year: i64,
}

impl Partition {
    /// Its folder below that of a laboratory.
    pub(super) fn below(&self) -> PathBuf {
        let instrument = format!("instrument={}", escaped(&self.instrument));
        Path::new(&instrument).join(format!("year={}", self.year))
    }
}

/// A value as Hive and Spark write it into a path, and every engine reads it back.
pub(super) fn escaped(value: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.".contains(&byte);
    let one = |byte: u8| match plain(byte) {
        true => char::from(byte).to_string(),
        false => format!("%{byte:02X}"),
    };
    match value {
        "" => "__HIVE_DEFAULT_PARTITION__".to_owned(),
        some => some.bytes().map(one).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn every_value_of_a_document_has_its_path() {
        let document = json!({ "a": { "b": [1, { "c": "x" }], "d": null }, "e": true });
        let mut told = Vec::new();
        flatten("", &document, &mut |key, number, text| {
            told.push((key.to_owned(), number, text.map(str::to_owned)));
        });
        let expected = [
            ("a.b[0]", Some(1.0), None),
            ("a.b[1].c", None, Some("x")),
            ("e", Some(1.0), None),
        ];
        let expected =
            expected.map(|(key, number, text)| (key.to_owned(), number, text.map(str::to_owned)));
        assert_eq!(told, expected);
    }
}
