//! The file: where it is, how it is opened, and its failures in words.

use super::journal::{self, Subject};
use calib_files::{Error, Result};
use rusqlite::{Connection, ErrorCode, Transaction, TransactionBehavior};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Steps that make each form of the tables of the one before, from an empty file on. A form that was ever
/// released stays here as it is: files of every form are opened.
const STEPS: [&str; 13] = [
    include_str!("schema.sql"),
    include_str!("form2.sql"),
    include_str!("form3.sql"),
    include_str!("form4.sql"),
    include_str!("form5.sql"),
    include_str!("form6.sql"),
    include_str!("form7.sql"),
    include_str!("form8.sql"),
    include_str!("form9.sql"),
    include_str!("form10.sql"),
    include_str!("form11.sql"),
    include_str!("form12.sql"),
    include_str!("form13.sql"),
];
/// Form of the tables, in SQLite's `user_version`.
const VERSION: i64 = STEPS.len() as i64;
/// Mark of our files, in SQLite's `application_id`: "CALB".
const APPLICATION: i64 = 0x4341_4c42;
/// Mark and form of a file nobody has written to.
const NEW: (i64, i64) = (0, 0);

/// The logbook.
///
/// Every call may fail with [`Error::Input`] when the file is damaged, in use or
/// refuses, and [`Error::File`] when the disk does.
pub struct Logbook {
    pub(super) connection: Connection,
    pub(super) path: PathBuf,
}

/// Name of a logbook, and the one it had before; a file of either is read for ever.
const NAMES: [&str; 2] = ["logbook.sqlite", "bench.sqlite"];

/// `CALIB_LOGBOOK`, else `logbook.sqlite` beside the user's data, or the
/// `bench.sqlite` that is there instead.
pub fn default_path() -> PathBuf {
    if let Some(path) = std::env::var_os("CALIB_LOGBOOK") {
        return PathBuf::from(path);
    }
    let data = dirs::data_dir().unwrap_or_else(|| PathBuf::from("."));
    in_folder(&data.join("calib"))
}

fn in_folder(folder: &Path) -> PathBuf {
    let [new, old] = NAMES.map(|name| folder.join(name));
    match !new.exists() && old.exists() {
        true => old,
        false => new,
    }
}

impl Logbook {
    /// Opens the logbook, and creates it if it is not there.
    ///
    /// # Errors
    /// [`Error::Input`] when the file is none of ours, damaged, or of a newer
    /// release; [`Error::File`] when it cannot be created.
    pub fn open(path: &Path) -> Result<Self> {
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(|e| Error::file("create", folder, e))?;
        }
        create_private(path)?;
        let logbook = Self::connect(path)?;
        logbook.bring_up()?;
        Ok(logbook)
    }

    /// Opens the logbook that is there: who only reads makes none.
    ///
    /// # Errors
    /// As [`Self::open`], and [`Error::Input`] when there is none, or an empty file.
    pub fn open_existing(path: &Path) -> Result<Self> {
        let none = || {
            let hint = "`calib sensors add` and `calib logbook add` make one; \
                        another is named with --logbook or CALIB_LOGBOOK";
            Error::input(path.display().to_string(), "there is no logbook", hint)
        };
        if !path.exists() {
            return Err(none());
        }
        let logbook = Self::connect(path)?;
        match logbook.form()? {
            NEW if logbook.is_empty()? => return Err(none()),
            _ => logbook.bring_up()?,
        }
        Ok(logbook)
    }

    /// Opens the logbook if there is one.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn open_if_there(path: &Path) -> Result<Option<Self>> {
        match path.exists() {
            true => Self::open(path).map(Some),
            false => Ok(None),
        }
    }

    pub(super) fn connect(path: &Path) -> Result<Self> {
        let failed = |error| failure(path, error);
        let connection = Connection::open(path).map_err(failed)?;
        connection
            .busy_timeout(Duration::from_secs(5))
            .map_err(failed)?;
        connection
            .pragma_update(None, "foreign_keys", true)
            .map_err(failed)?;
        Ok(Self {
            connection,
            path: path.to_owned(),
        })
    }

    /// Whose file it is, and the form of the tables, both of one moment.
    fn form(&self) -> Result<(i64, i64)> {
        let both = "SELECT application_id, user_version \
                    FROM pragma_application_id, pragma_user_version";
        let pair = |row: &rusqlite::Row<'_>| Ok((row.get(0)?, row.get(1)?));
        let pair = self.connection.query_row(both, [], pair);
        pair.map_err(|error| self.failure(error))
    }

    /// The steps from this form to that of this release; nobody else may be writing.
    fn steps_from(&self, form: (i64, i64)) -> Result<&'static [&'static str]> {
        let place = self.path.display().to_string();
        let taken = match form {
            NEW if self.is_empty()? => 0,
            (APPLICATION, found @ 1..=VERSION) => found as usize,
            (APPLICATION, found) if found > VERSION => {
                return Err(Error::input(
                    place,
                    format!("is a logbook of form {found}, this tool knows {VERSION}"),
                    "install the release of this tool that wrote it",
                ));
            }
            _ => {
                return Err(Error::input(
                    place,
                    "is a database, and no logbook",
                    "name another file with --logbook or CALIB_LOGBOOK",
                ));
            }
        };
        Ok(STEPS.get(taken..).unwrap_or_default())
    }

    fn is_empty(&self) -> Result<bool> {
        let count = "SELECT count(*) FROM sqlite_schema";
        let count: i64 = self.one(count, [])?;
        Ok(count == 0)
    }

    /// Brings the tables to the form of this release, all of the way or none of it, unless another
    /// program has just done so.
    pub(super) fn bring_up(&self) -> Result<()> {
        if self.form()? == (APPLICATION, VERSION) {
            return Ok(());
        }
        let failed = |error| self.failure(error);
        let transaction = self.writing().map_err(failed)?;
        let steps = self.steps_from(self.form()?)?.join("\n");
        let script = format!(
            "{steps}\nPRAGMA application_id = {APPLICATION};\nPRAGMA user_version = {VERSION};"
        );
        transaction.execute_batch(&script).map_err(failed)?;
        // A journal that was made just now knows nothing yet of what is there.
        if self.one::<i64>("SELECT count(*) FROM journal", [])? == 0 {
            journal::begin(&transaction).map_err(failed)?;
        }
        transaction.commit().map_err(failed)
    }

    /// Begins to write, and waits for its turn until others have: who had read first could not wait any more.
    pub(super) fn writing(&self) -> rusqlite::Result<Transaction<'_>> {
        Transaction::new_unchecked(&self.connection, TransactionBehavior::Immediate)
    }

    /// A change and what it enters in the journal: both or neither, in its turn among all who write.
    pub(super) fn in_one_turn<T>(
        &self,
        change: impl FnOnce(&Connection) -> rusqlite::Result<T>,
    ) -> Result<T> {
        let both = || {
            let transaction = self.writing()?;
            let changed = change(&transaction)?;
            transaction.commit().map(|()| changed)
        };
        both().map_err(|error| self.failure(error))
    }

    /// Changes the row of this name, and enters it in the journal.
    pub(super) fn change(
        &self,
        subject: Subject,
        name: &str,
        sql: &str,
        values: impl rusqlite::Params,
    ) -> Result<()> {
        self.in_one_turn(|connection| {
            connection.execute(sql, values)?;
            journal::enter(connection, subject, name)
        })
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

/// Makes the file, for its user alone: it names customers. One that is there keeps the rights it was given;
/// SQLite makes its journal with those of the file.
#[cfg(unix)]
pub(super) fn create_private(path: &Path) -> Result<()> {
    use std::os::unix::fs::OpenOptionsExt;
    let mut options = std::fs::OpenOptions::new();
    let made = options.write(true).create_new(true).mode(0o600).open(path);
    match made {
        Err(error) if error.kind() != std::io::ErrorKind::AlreadyExists => {
            Err(Error::file("create", path, error))
        }
        _ => Ok(()),
    }
}

/// Files are for their user alone in the places this system has for them.
#[cfg(not(unix))]
pub(super) fn create_private(_: &Path) -> Result<()> {
    Ok(())
}

/// Error of SQLite, in our words and with a way out.
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
            format!("is damaged, or no logbook: {error}"),
            "put the last backup in its place; `calib logbook check` says what is lost",
        ),
        Some(ErrorCode::DatabaseBusy | ErrorCode::DatabaseLocked) => (
            "is in use by another program".to_owned(),
            "wait for it, or close it",
        ),
        _ => (
            error.to_string(),
            "`calib logbook check` looks at every entry",
        ),
    };
    Error::input(path.display().to_string(), problem, hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_file_becomes_a_logbook_and_stays_one() {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("below/logbook.sqlite");
        assert!(Logbook::open_if_there(&path).expect("none").is_none());
        Logbook::open(&path).expect("created");
        assert!(Logbook::open_if_there(&path).expect("opened").is_some());
    }

    #[cfg(unix)]
    #[test]
    fn a_new_logbook_is_for_its_user_alone() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("logbook.sqlite");
        Logbook::open(&path).expect("created");
        let mode = std::fs::metadata(&path)
            .expect("there")
            .permissions()
            .mode();
        assert_eq!(mode & 0o777, 0o600, "{mode:o}");
    }

    #[test]
    fn the_file_of_before_is_used_until_there_is_a_new_one() {
        let folder = tempfile::tempdir().expect("folder");
        let named = || in_folder(folder.path()).file_name().map(ToOwned::to_owned);
        let make = |name| std::fs::write(folder.path().join(name), "").expect("written");
        assert_eq!(named(), Some("logbook.sqlite".into()));
        make("bench.sqlite");
        assert_eq!(named(), Some("bench.sqlite".into()));
        make("logbook.sqlite");
        assert_eq!(named(), Some("logbook.sqlite".into()));
    }

    #[test]
    fn who_only_reads_makes_no_logbook() {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("logbook.sqlite");
        // A file cut down to nothing is a database to SQLite.
        for content in [None, Some(""), Some("x")] {
            if let Some(content) = content {
                std::fs::write(&path, content).expect("written");
            }
            let error = Logbook::open_existing(&path).err().expect("none");
            assert!(error.to_string().contains("there is no logbook"), "{error}");
            let after = std::fs::read_to_string(&path).ok();
            assert_eq!(after.as_deref(), content);
        }
        Logbook::open(&path).expect("created");
        assert!(Logbook::open_existing(&path).is_ok());
    }

    #[test]
    fn several_programs_may_make_the_logbook_at_once() {
        let folder = tempfile::tempdir().expect("folder");
        for round in 0..20 {
            let path = folder.path().join(format!("{round}.sqlite"));
            std::thread::scope(|scope| {
                let makers: Vec<_> = (0..4)
                    .map(|_| scope.spawn(|| Logbook::open(&path)))
                    .collect();
                for maker in makers {
                    maker.join().expect("no panic").expect("a logbook");
                }
            });
        }
    }

    /// A file that a release of form 1 wrote, with three calibrations, the log of a change of the
    /// reference and what belongs to them.
    #[test]
    fn a_file_of_form_1_is_brought_up_and_keeps_everything() {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("old.sqlite");
        let old = include_bytes!("../../../tests/frozen/stored/bench.sqlite");
        std::fs::write(&path, old).expect("written");
        let count = |logbook: &Logbook, table: &str| -> i64 {
            let sql = format!("SELECT count(*) FROM {table}");
            logbook.one(&sql, []).expect("counted")
        };
        let tables = ["sensors", "records", "contents", "points", "operators"];
        let before = Logbook::connect(&path).expect("opened");
        assert_eq!(before.form().expect("a form"), (APPLICATION, 1));
        let counted = tables.map(|table| count(&before, table));
        assert!(counted[1] > 0);
        drop(before);
        for _again in 0..2 {
            let logbook = Logbook::open_existing(&path).expect("a logbook");
            assert_eq!(logbook.form().expect("a form"), (APPLICATION, VERSION));
            assert_eq!(tables.map(|table| count(&logbook, table)), counted);
            assert_eq!(logbook.inspect().expect("read"), [""; 0]);
            for line in logbook.records(&crate::Filter::default()).expect("listed") {
                let bytes = logbook.record(line.id).expect("kept");
                let link = calib_protocol::record::hash_link(&bytes).expect("a record");
                assert_eq!(link.kind, line.kind);
            }
        }
    }

    #[test]
    fn what_is_no_logbook_is_left_alone() {
        let folder = tempfile::tempdir().expect("folder");
        let text = folder.path().join("text");
        std::fs::write(&text, "no database at all, just words ".repeat(99)).expect("file");
        let other = folder.path().join("other.sqlite");
        let database = Connection::open(&other).expect("database");
        database.execute_batch("CREATE TABLE a (b)").expect("table");
        let newer = folder.path().join("newer.sqlite");
        let logbook = Logbook::open(&newer).expect("logbook");
        let later = VERSION + 1;
        let update = logbook
            .connection
            .pragma_update(None, "user_version", later);
        update.expect("a later form");
        let named = format!("form {later}");
        for (path, words) in [(text, "damaged"), (other, "no logbook"), (newer, &*named)] {
            let before = std::fs::read(&path).expect("read");
            let error = Logbook::open(&path).err().expect("no logbook");
            assert!(error.to_string().contains(words), "{error}");
            assert_eq!(error.exit_code(), 6);
            assert_eq!(std::fs::read(&path).expect("read"), before);
        }
    }
}
