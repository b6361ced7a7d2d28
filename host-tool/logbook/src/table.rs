//! Tables of the logbook, column by column, as other programs read them.

use super::Logbook;
use calib_files::Result;
use rusqlite::types::ValueRef;

/// Kind of a column; every column may have gaps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Text,
    Real,
    Integer,
    Boolean,
    /// Milliseconds since 1970-01-01 UTC.
    Time,
}

/// Values of a column.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Values {
    Text(Vec<Option<String>>),
    Real(Vec<Option<f64>>),
    Integer(Vec<Option<i64>>),
}

/// A table that is exported: its name, its columns, where they come from.
pub(super) struct Table {
    pub(super) name: &'static str,
    /// Name and kind of each.
    pub(super) columns: &'static str,
    /// Question with one value a column, and the year of the row first.
    pub(super) select: &'static str,
}

/// Rows of a table that belong into one file.
pub(super) struct Part {
    /// Year of the rows; `None` for tables that have no time.
    pub(super) year: Option<i64>,
    pub(super) columns: Vec<Values>,
}

use Kind::{Boolean, Integer, Real, Text, Time};

/// Kinds as tables name them.
const KINDS: [(&str, Kind); 5] = [
    ("text", Text),
    ("real", Real),
    ("integer", Integer),
    ("boolean", Boolean),
    ("time", Time),
];

/// Exported tables. Years are UTC.
pub(super) const TABLES: &[Table] = &[
    Table {
        name: "points",
        columns: "logbook_record integer, record_sha256 text, instrument_serial text, \
                  dut_serial text, dut_model text, operator text, time time, position integer, \
                  frequency_hz real, set_acceleration_rms_ms2 real, state text, reason_text text, \
                  sensitivity_v_per_ms2 real, expanded_uncertainty_rel real, coverage_factor real, \
                  phase_deg real, expanded_uncertainty_phase_deg real",
        select: "SELECT CAST(strftime('%Y', unix_time_s, 'unixepoch') AS INTEGER), id,
                 lower(hex(sha256)), instrument, sensor_serial, sensor_model, operator,
                 1000 * unix_time_s, position, frequency_hz, acceleration_rms_ms2,
                 CASE state WHEN 'valid' THEN 'valid' ELSE 'refused' END,
                 nullif(substr(state, length('refused: ') + 1), ''),
                 points.sensitivity_v_per_ms2, points.expanded_uncertainty_rel, coverage_factor,
                 57.29577951308232 * phase_rad, 57.29577951308232 * expanded_uncertainty_phase_rad
                 FROM records JOIN points ON record = id ORDER BY 1, id, position",
    },
    Table {
        name: "records",
        columns: "logbook_record integer, sha256 text, instrument_serial text, record_id integer, \
                  time time, dut_serial text, dut_model text, operator text, complete boolean, \
                  points integer, refused integer, reference_frequency_hz real, \
                  sensitivity_v_per_ms2 real, expanded_uncertainty_rel real",
        select: "SELECT CAST(strftime('%Y', unix_time_s, 'unixepoch') AS INTEGER), id,
                 lower(hex(sha256)), instrument, number, 1000 * unix_time_s, sensor_serial,
                 sensor_model, operator, complete, points, refused, reference_frequency_hz,
                 sensitivity_v_per_ms2, expanded_uncertainty_rel FROM records ORDER BY 1, id",
    },
    Table {
        name: "certificates",
        columns: "number integer, certificate text, format text, record_sha256 text, issued time, \
                  file text, sha256 text",
        select:
            "SELECT CAST(strftime('%Y', issued_s, 'unixepoch') AS INTEGER), number, certificate,
                 format, lower(hex(record_sha256)), 1000 * issued_s, file, lower(hex(sha256))
                 FROM certificates ORDER BY 1, number",
    },
    Table {
        name: "signed_files",
        columns: "sha256 text, certificate text, format text, signed_by text, \
                  signer_certificate_sha256 text, entered time",
        select:
            "SELECT CAST(strftime('%Y', entered_s, 'unixepoch') AS INTEGER), lower(hex(sha256)),
                 certificate, format, signed_by, lower(hex(signer_sha256)), 1000 * entered_s
                 FROM signed_files ORDER BY 1, entered_s, sha256",
    },
    Table {
        name: "sensors",
        columns: "serial text, manufacturer text, model text, sensitivity_v_per_ms2 real, \
                  range_ms2 real, iepe boolean, mounting text, owner text, due_day text, \
                  tolerance text, unit text, resonance_hz real",
        // Of other kinds V/(m/s2) is no number.
        select: "SELECT NULL, serial, manufacturer, model,
                 CASE WHEN unit IS NULL OR unit IN ('mV/(m/s2)', 'mV/g') THEN sensitivity END, range_ms2, iepe,
                 mounting, owner, due_day, tolerance, unit, CAST(resonance_hz AS REAL) FROM sensors ORDER BY serial",
    },
    Table {
        name: "instruments",
        columns: "instrument_serial text, firmware text, reference_serial text, \
                  reference_certificate text, reference_due_day text, reference_table text, \
                  last time",
        select: "SELECT NULL, serial, firmware, reference_serial, reference_certificate, due_day,
                 reference_table, 1000 * last_s FROM instruments ORDER BY serial",
    },
    Table {
        name: "operators",
        columns: "name text, first time, last time",
        select: "SELECT NULL, name, 1000 * first_s, 1000 * last_s FROM operators ORDER BY name",
    },
];

impl Table {
    /// Names and kinds of its columns.
    pub(super) fn columns(&self) -> impl Iterator<Item = (&'static str, Kind)> {
        let named = self.columns.split(", ").filter_map(|it| it.split_once(' '));
        named.filter_map(|(name, word)| {
            let (_, kind) = KINDS.into_iter().find(|(known, _)| *known == word)?;
            Some((name, kind))
        })
    }

    /// No rows yet.
    pub(super) fn empty(&self, year: Option<i64>) -> Part {
        let columns = self.columns().map(|(_, kind)| Values::new(kind)).collect();
        Part { year, columns }
    }

    /// The rows, apart by year.
    pub(super) fn read(&self, logbook: &Logbook) -> Result<Vec<Part>> {
        let mut parts: Vec<Part> = Vec::new();
        logbook.all(self.select, [], |row| {
            let year = row.get(0)?;
            if parts.last().is_none_or(|part| part.year != year) {
                parts.push(self.empty(year));
            }
            if let Some(part) = parts.last_mut() {
                for (index, values) in part.columns.iter_mut().enumerate() {
                    values.push(row.get_ref(index + 1)?);
                }
            }
            Ok(())
        })?;
        Ok(parts)
    }
}

impl Values {
    pub(super) fn new(kind: Kind) -> Self {
        match kind {
            Text => Self::Text(Vec::new()),
            Real => Self::Real(Vec::new()),
            Integer | Boolean | Time => Self::Integer(Vec::new()),
        }
    }

    pub(super) fn push(&mut self, value: ValueRef<'_>) {
        match self {
            Self::Text(all) => all.push(value.as_str().ok().map(str::to_owned)),
            Self::Real(all) => all.push(value.as_f64().ok()),
            Self::Integer(all) => all.push(value.as_i64().ok()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lake_tables::LAKE_TABLES;

    #[test]
    fn every_column_has_a_kind_there_is() {
        for table in TABLES.iter().chain(&LAKE_TABLES) {
            let all = table.columns.split(", ").count();
            assert_eq!(table.columns().count(), all, "{}", table.name);
        }
    }
}
