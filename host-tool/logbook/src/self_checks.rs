//! Checks of an instrument's reference by reciprocity, as they were found.

use super::Logbook;
use super::journal::{self, Subject};
use calib_files::{Error, Result};
use rusqlite::{OptionalExtension, params};

/// A check of the reference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SelfCheck {
    /// Serial number of the instrument.
    pub instrument: String,
    /// Serial number of its reference.
    pub reference: String,
    /// Certificate of that, as the instrument had it.
    pub certificate: String,
    /// When its last run was measured, s since 1970-01-01 UTC.
    pub measured_s: i64,
    /// Later ones are compared with it.
    pub is_baseline: bool,
    /// The result as JSON.
    pub evaluation: String,
}

const COLUMNS: &str = "instrument, reference, certificate, measured_s, baseline, evaluation";

impl Logbook {
    /// Keeps a check; false where it is there already.
    ///
    /// # Errors
    /// [`Error::Input`] when another of the same instrument and moment is there; those of the file.
    pub fn keep_self_check(&self, check: &SelfCheck) -> Result<bool> {
        if let Some(known) = self.self_check_at(&check.instrument, check.measured_s)? {
            return match known == *check {
                true => Ok(false),
                false => Err(Error::input(
                    format!("check of the reference of {}", check.instrument),
                    "is another in the logbook at the same moment",
                    "a check that is kept is not changed: measure another",
                )),
            };
        }
        let put = || {
            let transaction = self.writing()?;
            let sql =
                format!("INSERT INTO self_checks ({COLUMNS}) VALUES (?1, ?2, ?3, ?4, ?5, ?6)");
            let values = params![
                check.instrument,
                check.reference,
                check.certificate,
                check.measured_s,
                check.is_baseline,
                check.evaluation
            ];
            transaction.execute(&sql, values)?;
            let number = transaction.last_insert_rowid().to_string();
            journal::enter(&transaction, Subject::SelfCheck, &number)?;
            transaction.commit()
        };
        put().map(|()| true).map_err(|error| self.failure(error))
    }

    /// All checks, the oldest first.
    ///
    /// # Errors
    /// Those of the file.
    pub fn self_checks(&self) -> Result<Vec<SelfCheck>> {
        let find = format!("SELECT {COLUMNS} FROM self_checks ORDER BY measured_s, number");
        self.all(&find, [], SelfCheck::from_row)
    }

    fn self_check_at(&self, instrument: &str, measured_s: i64) -> Result<Option<SelfCheck>> {
        let find =
            format!("SELECT {COLUMNS} FROM self_checks WHERE instrument = ?1 AND measured_s = ?2");
        self.connection
            .query_row(&find, params![instrument, measured_s], SelfCheck::from_row)
            .optional()
            .map_err(|error| self.failure(error))
    }
}

impl SelfCheck {
    fn from_row(row: &rusqlite::Row<'_>) -> rusqlite::Result<Self> {
        Ok(Self {
            instrument: row.get(0)?,
            reference: row.get(1)?,
            certificate: row.get(2)?,
            measured_s: row.get(3)?,
            is_baseline: row.get(4)?,
            evaluation: row.get(5)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(measured_s: i64) -> SelfCheck {
        SelfCheck {
            instrument: "CAL-1".into(),
            reference: "R-7".into(),
            certificate: "K-2026-1".into(),
            measured_s,
            is_baseline: measured_s == 1,
            evaluation: "{}".into(),
        }
    }

    #[test]
    fn a_check_is_kept_once_stays_and_is_taken_over() {
        let folder = tempfile::tempdir().expect("a folder");
        let open = |name: &str| Logbook::open(&folder.path().join(name)).expect("a logbook");
        let logbook = open("one.sqlite");
        assert!(logbook.keep_self_check(&check(2)).expect("kept"));
        assert!(logbook.keep_self_check(&check(1)).expect("kept"));
        assert!(!logbook.keep_self_check(&check(1)).expect("there already"));
        let other = SelfCheck {
            is_baseline: true,
            ..check(2)
        };
        let message = logbook
            .keep_self_check(&other)
            .expect_err("another")
            .to_string();
        assert!(message.contains("at the same moment"), "{message}");
        assert_eq!(logbook.self_checks().expect("both"), [check(1), check(2)]);
        for sql in [
            "UPDATE self_checks SET baseline = 1",
            "DELETE FROM self_checks",
        ] {
            assert!(logbook.connection.execute(sql, []).is_err(), "{sql}");
        }
        assert_eq!(logbook.inspect().expect("sound"), [""; 0]);
        let mut second = open("two.sqlite");
        second.merge(&logbook).expect("merged");
        assert_eq!(second.self_checks().expect("both"), [check(1), check(2)]);
        assert_eq!(second.inspect().expect("sound"), [""; 0]);
    }
}
