//! The file: where it is, how it is opened, and its failures in words.

use crate::{Error, Result};
use rusqlite::{Connection, ErrorCode, OpenFlags};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Form of the tables, in SQLite's `user_version`.
const VERSION: i64 = 1;
/// Mark of our files, in SQLite's `application_id`: "CALB".
const APPLICATION: i64 = 0x4341_4c42;

const SCHEMA: &str = include_str!("schema.sql");

/// The bench of records.
///
/// Every call may fail with [`Error::Input`] when the file is damaged, in use or
/// refuses, and [`Error::File`] when the disk does.
pub struct Bench {
    pub(super) connection: Connection,
    pub(super) path: PathBuf,
}

/// `CALIB_BENCH`, else `bench.sqlite` beside the user's data.
pub fn default_path() -> PathBuf {
    match std::env::var_os("CALIB_BENCH") {
        Some(path) => PathBuf::from(path),
        None => dirs::data_dir()
            .unwrap_or_else(|| PathBuf::from("."))
            .join("calib")
            .join("bench.sqlite"),
    }
}

impl Bench {
    /// Opens the bench, and creates it if it is not there.
    ///
    /// # Errors
    /// [`Error::Input`] when the file is none of ours, damaged, or of a newer
    /// release; [`Error::File`] when it cannot be created.
    pub fn open(path: &Path) -> Result<Self> {
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(|e| Error::file("create", folder, e))?;
        }
        Self::with_flags(path, OpenFlags::default())
    }

    /// Opens the bench if there is one.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn open_if_there(path: &Path) -> Result<Option<Self>> {
        match path.exists() {
            true => Self::open(path).map(Some),
            false => Ok(None),
        }
    }

    fn with_flags(path: &Path, flags: OpenFlags) -> Result<Self> {
        let failed = |error| failure(path, error);
        let connection = Connection::open_with_flags(path, flags).map_err(failed)?;
        let bench = Self {
            connection,
            path: path.to_owned(),
        };
        bench.prepare()?;
        Ok(bench)
    }

    /// Settings of the connection; tables, if the file is new.
    fn prepare(&self) -> Result<()> {
        let failed = |error| failure(&self.path, error);
        let connection = &self.connection;
        connection
            .busy_timeout(Duration::from_secs(5))
            .map_err(failed)?;
        connection
            .pragma_update(None, "foreign_keys", true)
            .map_err(failed)?;
        let read = |pragma: &str| -> Result<i64> {
            connection
                .pragma_query_value(None, pragma, |row| row.get(0))
                .map_err(failed)
        };
        match (read("application_id")?, read("user_version")?) {
            (APPLICATION, VERSION) => Ok(()),
            (APPLICATION, found) if found > VERSION => Err(Error::input(
                self.path.display().to_string(),
                format!("is a bench of form {found}, this tool knows {VERSION}"),
                "install the release of this tool that wrote it",
            )),
            (0, 0) if self.is_empty()? => self.create(),
            _ => Err(Error::input(
                self.path.display().to_string(),
                "is a database, and no bench of records",
                "name another file with --bench or CALIB_BENCH",
            )),
        }
    }

    fn is_empty(&self) -> Result<bool> {
        let count = "SELECT count(*) FROM sqlite_schema";
        let count: i64 = self.one(count, [])?;
        Ok(count == 0)
    }

    fn create(&self) -> Result<()> {
        let script = format!(
            "BEGIN IMMEDIATE;\n{SCHEMA}\nPRAGMA application_id = {APPLICATION};\n\
             PRAGMA user_version = {VERSION};\nCOMMIT;"
        );
        self.connection
            .execute_batch(&script)
            .map_err(|error| failure(&self.path, error))
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// A single value.
    pub(super) fn one<T: rusqlite::types::FromSql>(
        &self,
        sql: &str,
        parameters: impl rusqlite::Params,
    ) -> Result<T> {
        self.connection
            .query_row(sql, parameters, |row| row.get(0))
            .map_err(|error| self.failure(error))
    }

    /// All rows of a question.
    pub(super) fn all<T>(
        &self,
        sql: &str,
        parameters: impl rusqlite::Params,
        row: impl FnMut(&rusqlite::Row<'_>) -> rusqlite::Result<T>,
    ) -> Result<Vec<T>> {
        let rows = || {
            let mut statement = self.connection.prepare(sql)?;
            let rows = statement.query_map(parameters, row)?;
            rows.collect::<rusqlite::Result<Vec<T>>>()
        };
        rows().map_err(|error| self.failure(error))
    }

    pub(super) fn failure(&self, error: rusqlite::Error) -> Error {
        failure(&self.path, error)
    }
}

/// What SQLite said, in our words and with a way out.
pub(super) fn failure(path: &Path, error: rusqlite::Error) -> Error {
    let (problem, hint) = match error.sqlite_error_code() {
        Some(ErrorCode::DiskFull) => {
            let full = std::io::ErrorKind::StorageFull.into();
            return Error::file("write", path, full);
        }
        Some(ErrorCode::CannotOpen | ErrorCode::ReadOnly | ErrorCode::PermissionDenied) => {
            return Error::file("open", path, std::io::Error::other(error.to_string()));
        }
        Some(ErrorCode::DatabaseCorrupt | ErrorCode::NotADatabase) => (
            format!("is damaged, or no bench of records: {error}"),
            "put the last backup in its place; `calib bench check` says what is lost",
        ),
        Some(ErrorCode::DatabaseBusy | ErrorCode::DatabaseLocked) => (
            "is in use by another program".to_owned(),
            "wait for it, or close it",
        ),
        _ => (
            error.to_string(),
            "`calib bench check` looks at every entry",
        ),
    };
    Error::input(path.display().to_string(), problem, hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_file_becomes_a_bench_and_stays_one() {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("below/bench.sqlite");
        assert!(Bench::open_if_there(&path).expect("none").is_none());
        Bench::open(&path).expect("created");
        assert!(Bench::open_if_there(&path).expect("opened").is_some());
    }

    #[test]
    fn what_is_no_bench_is_left_alone() {
        let folder = tempfile::tempdir().expect("folder");
        let text = folder.path().join("text");
        std::fs::write(&text, "no database at all, just words ".repeat(99)).expect("file");
        let other = folder.path().join("other.sqlite");
        let database = Connection::open(&other).expect("database");
        database.execute_batch("CREATE TABLE a (b)").expect("table");
        let newer = folder.path().join("newer.sqlite");
        let bench = Bench::open(&newer).expect("bench");
        let update = bench.connection.pragma_update(None, "user_version", 9);
        update.expect("form 9");
        for (path, words) in [(text, "damaged"), (other, "no bench"), (newer, "form 9")] {
            let before = std::fs::read(&path).expect("read");
            let error = Bench::open(&path).err().expect("no bench");
            assert!(error.to_string().contains(words), "{error}");
            assert_eq!(error.exit_code(), 6);
            assert_eq!(std::fs::read(&path).expect("read"), before);
        }
    }
}
