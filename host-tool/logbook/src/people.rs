//! Operators and instruments: nobody enters them, records name them.

use super::Logbook;
use calib_core::settings::Settings;
use calib_files::Result;
use calib_protocol::record::RecordHead;
use rusqlite::{Transaction, params};
use schemars::JsonSchema;
use serde::Serialize;

/// Who calibrated.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Operator {
    /// As on the records.
    pub name: String,
    /// First record, s since 1970-01-01 UTC.
    #[serde(rename = "first_unix_time_s")]
    pub first_s: i64,
    /// Last record.
    #[serde(rename = "last_unix_time_s")]
    pub last_s: i64,
}

/// An instrument, with the reference its last record was measured with.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Instrument {
    /// Serial number.
    #[serde(rename = "instrument_serial")]
    pub serial: String,
    /// Firmware of the last record.
    pub firmware_version: String,
    /// Serial number of the reference.
    pub reference_serial: String,
    /// Certificate of the reference.
    pub reference_certificate: String,
    /// Day the reference's calibration is due, ISO 8601.
    #[serde(rename = "reference_due_day")]
    pub due_day: Option<String>,
    /// The reference's calibration table.
    #[schemars(with = "[calib_core::settings::ReferencePoint]")]
    pub reference_table: serde_json::Value,
    /// Last record, s since 1970-01-01 UTC.
    #[serde(rename = "last_unix_time_s")]
    pub last_s: i64,
}

impl Logbook {
    /// Everybody who is named on a record.
    ///
    /// # Errors
    /// Those of the file.
    pub fn operators(&self) -> Result<Vec<Operator>> {
        let sql = "SELECT name, first_s, last_s FROM operators ORDER BY name";
        self.all(sql, [], |row| {
            Ok(Operator {
                name: row.get(0)?,
                first_s: row.get(1)?,
                last_s: row.get(2)?,
            })
        })
    }

    /// Every instrument that measured a record.
    ///
    /// # Errors
    /// Those of the file.
    pub fn instruments(&self) -> Result<Vec<Instrument>> {
        let sql = "SELECT serial, firmware, reference_serial, reference_certificate, due_day,
                   reference_table, last_s FROM instruments ORDER BY serial";
        self.all(sql, [], |row| {
            let table: String = row.get(5)?;
            Ok(Instrument {
                serial: row.get(0)?,
                firmware_version: row.get(1)?,
                reference_serial: row.get(2)?,
                reference_certificate: row.get(3)?,
                due_day: row.get(4)?,
                reference_table: serde_json::from_str(&table).unwrap_or_default(),
                last_s: row.get(6)?,
            })
        })
    }
}

/// Enters who and what a record names. An older record changes nothing.
pub(super) fn enter(
    transaction: &Transaction<'_>,
    head: &RecordHead,
    settings: &Settings,
) -> rusqlite::Result<()> {
    let time_s = i64::try_from(head.labels.unix_time_s).unwrap_or(0);
    let operator = head.labels.operator.trim();
    if !operator.is_empty() {
        transaction
            .prepare_cached(
                "INSERT INTO operators (name, first_s, last_s) VALUES (?1, ?2, ?2)
                 ON CONFLICT (name) DO UPDATE SET
                 first_s = min(first_s, excluded.first_s), last_s = max(last_s, excluded.last_s)",
            )?
            .execute(params![operator, time_s])?;
    }
    let reference = &settings.reference;
    let table = serde_json::to_string(&reference.points).unwrap_or_default();
    transaction
        .prepare_cached(
            "INSERT INTO instruments VALUES (?1,?2,?3,?4,?5,?6,?7)
             ON CONFLICT (serial) DO UPDATE SET firmware = excluded.firmware,
             reference_serial = excluded.reference_serial,
             reference_certificate = excluded.reference_certificate,
             due_day = excluded.due_day, reference_table = excluded.reference_table,
             last_s = excluded.last_s WHERE excluded.last_s >= last_s",
        )?
        .execute(params![
            head.instrument_serial.as_str(),
            head.firmware.as_str(),
            reference.serial.as_str(),
            reference.certificate.as_str(),
            calib_certificate::day(reference.due_day).map(|day| day.to_string()),
            table,
            time_s,
        ])
        .map(drop)
}
