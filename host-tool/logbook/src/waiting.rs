//! Records that wait for the logbook: another program may hold it when a run ends, and the record of that run
//! is entered all the same, by the next run or the page.

use super::records::TRUE_ONE;
use super::{Kept, Logbook};
use calib_files::file::{self, Existing};
use calib_files::{Error, Result};
use calib_protocol::record;
use calib_protocol::signature::DeviceKey;
use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Serial number of an instrument, and the key it states.
pub type Stated = (String, DeviceKey);

/// Where records wait: beside the logbook, under its name and `.waiting`.
pub fn folder(logbook: &Path) -> PathBuf {
    logbook.with_added_extension("waiting")
}

/// Puts a record there, on disk, and returns its place.
///
/// # Errors
/// [`Error::File`].
pub fn put(logbook: &Path, bytes: &[u8]) -> Result<PathBuf> {
    let name = hex::encode(record::digest(bytes));
    let folder = folder(logbook);
    std::fs::create_dir_all(&folder).map_err(|e| Error::file("create", &folder, e))?;
    private(&folder)?;
    let path = folder.join(name).with_extension("calibrec");
    file::write(&path, bytes, Existing::Replace)?;
    Ok(path)
}

/// The folder is for its user alone, as the logbook is.
#[cfg(unix)]
fn private(folder: &Path) -> Result<()> {
    use std::os::unix::fs::PermissionsExt;
    let mode = std::fs::Permissions::from_mode(0o700);
    std::fs::set_permissions(folder, mode).map_err(|e| Error::file("close", folder, e))
}

/// Files are for their user alone in the places this system has for them.
#[cfg(not(unix))]
fn private(_: &Path) -> Result<()> {
    Ok(())
}

/// Outcome for the records that waited.
#[derive(Debug, Default)]
pub struct Entered {
    /// Places and numbers of those that are in the logbook now.
    pub numbers: Vec<(PathBuf, i64)>,
    /// Those that were put aside, with why.
    pub refused: Vec<(PathBuf, String)>,
}

impl Entered {
    /// Error that names all files put aside; none where nothing was.
    pub fn objection(&self) -> Option<Error> {
        let said = self.refused.iter();
        let said = said.map(|(place, problem)| format!("{}: {problem}", place.display()));
        let all: Vec<String> = said.collect();
        (!all.is_empty()).then(|| Error::input("put aside", all.join("; "), TRUE_ONE))
    }
}

impl Logbook {
    /// Enters what waits for the logbook at `path`, which is made if there is none, and returns places and
    /// numbers. One that is no record, or cannot be the instrument's, is put aside under `.refused` with why, and is
    /// in no other's way. Keys that instruments stated are entered first; where one is refused, the records of its
    /// instrument go on waiting.
    ///
    /// # Errors
    /// As [`Self::open`], [`Self::enter_key`] and [`Self::keep`].
    pub fn enter_waiting(path: &Path, keys: &[Stated]) -> Result<Entered> {
        let waiting = listed(&folder(path))?;
        let mut entered = Entered::default();
        if waiting.is_empty() {
            return Ok(entered);
        }
        let mut logbook = Self::open(path)?;
        let stated = keys
            .iter()
            .map(|(of, key)| (of, logbook.enter_key(of, key)));
        let mut refused: BTreeMap<&String, Error> = stated
            .filter_map(|(of, entered)| Some((of, entered.err()?)))
            .collect();
        for place in waiting {
            let bytes = std::fs::read(&place).map_err(|e| Error::file("read", &place, e))?;
            let of =
                record::hash_link(&bytes).map(|link| link.instrument_serial.as_str().to_owned());
            if of.is_ok_and(|of| refused.contains_key(&of)) {
                continue;
            }
            let problem = match record::check(&bytes) {
                Ok(_) => logbook.objection(&bytes)?,
                Err(error) => Some(error.to_string()),
            };
            if let Some(problem) = problem {
                let aside = place.with_extension("refused");
                file::rename(&place, &aside)?;
                entered.refused.push((aside, problem));
                continue;
            }
            let (Kept::Added(id) | Kept::Known(id)) = logbook.keep(&bytes)?;
            std::fs::remove_file(&place).map_err(|e| Error::file("remove", &place, e))?;
            entered.numbers.push((place, id));
        }
        match refused.pop_first() {
            Some((_, error)) => Err(error),
            None => Ok(entered),
        }
    }
}

fn listed(folder: &Path) -> Result<Vec<PathBuf>> {
    let failed = |error| Error::file("read", folder, error);
    let files = match std::fs::read_dir(folder) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        files => files.map_err(failed)?,
    };
    let mut paths = Vec::new();
    for file in files {
        let path = file.map_err(failed)?.path();
        if path.extension().is_some_and(|kind| kind == "calibrec") {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}
