//! Every sum and number checked again: what is made of records is made once more, the rest has its journal.

use super::{Logbook, journal, row};
use calib_files::Result;
use std::collections::BTreeSet;
use std::path::Path;

/// Tables that are made of the records alone, each row after its name. Records and their points are told by
/// the record's sum: numbers in the logbook are those of this file.
const MADE: [&str; 4] = [
    "SELECT 'record ' || number || ' of ' || instrument, sha256, instrument, number, unix_time_s,
     sensor_serial, sensor_model, operator, complete, points, refused, reference_frequency_hz,
     sensitivity_v_per_ms2, expanded_uncertainty_rel, kind, series FROM records",
    "SELECT 'point ' || (position + 1) || ' of record ' || number || ' of ' || instrument, sha256,
     position, frequency_hz, acceleration_rms_ms2, state, points.sensitivity_v_per_ms2,
     points.expanded_uncertainty_rel, coverage_factor, phase_rad, expanded_uncertainty_phase_rad
     FROM points LEFT JOIN records ON id = record",
    "SELECT 'operator ' || name, * FROM operators",
    "SELECT 'instrument ' || serial, * FROM instruments",
];
/// Tables, indexes and triggers themselves, every part with its type: SQLite takes a name that is no text.
const FORM: &str = "SELECT type || ' ' || name, type, name, tbl_name, sql FROM sqlite_schema";
/// Where the next certificate would not get the number after the last.
const GAP: &str = "SELECT count(*) FROM sqlite_sequence
    WHERE name <> 'certificates' OR seq IS NOT (SELECT max(number) FROM certificates)";

impl Logbook {
    /// Looks at the file, at every record, at every number made of one, and at what the journal has of the
    /// rest. Returns what is wrong, in words; nothing when all is well.
    ///
    /// # Errors
    /// Those of a file that cannot be read at all.
    pub fn inspect(&self) -> Result<Vec<String>> {
        // All of one moment, whatever other programs enter meanwhile.
        let moment = self.connection.unchecked_transaction();
        let _moment = moment.map_err(|error| self.failure(error))?;
        let mut wrong = self.all("PRAGMA integrity_check", [], |row| row.get::<_, String>(0))?;
        wrong.retain(|line| line != "ok");
        let mut again = Self::in_memory()?;
        for instrument in self.keyed_instruments()? {
            for had in self.keys(&instrument)? {
                again.take_key(&instrument, &had)?;
            }
        }
        for id in self.all("SELECT id FROM records ORDER BY id", [], |row| row.get(0))? {
            let kept = self.record(id).and_then(|bytes| again.keep(&bytes));
            wrong.extend(kept.err().map(|error| error.to_string()));
        }
        for sql in MADE.into_iter().chain([FORM]) {
            wrong.extend(self.differences(&again, sql)?);
        }
        if self.one::<i64>(GAP, [])? != 0 {
            wrong.push("certificates: the next number would leave a gap".to_owned());
        }
        let journal = journal::check(&self.connection);
        wrong.extend(journal.map_err(|error| self.failure(error))?);
        Ok(wrong)
    }

    /// A logbook of nothing, in no file.
    fn in_memory() -> Result<Self> {
        let logbook = Self::connect(Path::new(":memory:"))?;
        logbook.bring_up()?;
        Ok(logbook)
    }

    /// Rows that only one of the two has.
    fn differences(&self, again: &Self, sql: &str) -> Result<Vec<String>> {
        let rows = |logbook: &Self| -> Result<BTreeSet<_>> {
            let rows = row::all(&logbook.connection, sql);
            Ok(rows
                .map_err(|error| logbook.failure(error))?
                .into_iter()
                .collect())
        };
        let (listed, made) = (rows(self)?, rows(again)?);
        let names = listed.symmetric_difference(&made).map(|(name, _)| name);
        let names: BTreeSet<&String> = names.collect();
        let words = |name| format!("{name}: the list says something else than the records");
        Ok(names.into_iter().map(words).collect())
    }
}
