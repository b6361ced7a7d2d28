//! Records that wait for the logbook: another program may hold it when a run ends, and the record of that run
//! is entered all the same, by whoever opens the logbook next.

use super::records::TRUE_ONE;
use super::{Kept, Logbook};
use calib_files::file::{self, Existing};
use calib_files::{Error, Result};
use calib_protocol::record;
use calib_protocol::signature::DeviceKey;
use std::fmt::Write;
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
    let mut name = String::new();
    for byte in record::digest(bytes) {
        // Writing into memory does not fail.
        let _ = write!(name, "{byte:02x}");
    }
    let path = folder(logbook).join(name).with_extension("calibrec");
    file::write(&path, bytes, Existing::Replace)?;
    Ok(path)
}

impl Logbook {
    /// Enters what waits for the logbook at `path`, which is made if there is none, and returns places and
    /// numbers. One that cannot be the instrument's is put aside under `.refused`, and named once the others
    /// are entered. Keys that instruments stated are entered first.
    ///
    /// # Errors
    /// As [`Self::open`] and [`Self::keep`].
    pub fn enter_waiting(path: &Path, keys: &[Stated]) -> Result<Vec<(PathBuf, i64)>> {
        let waiting = listed(&folder(path))?;
        if waiting.is_empty() {
            return Ok(Vec::new());
        }
        let mut logbook = Self::open(path)?;
        for (instrument, key) in keys {
            logbook.enter_key(instrument, key)?;
        }
        let (mut entered, mut refused) = (Vec::new(), None);
        for place in waiting {
            let bytes = std::fs::read(&place).map_err(|e| Error::file("read", &place, e))?;
            if let Some(problem) = logbook.objection(&bytes)? {
                let aside = place.with_extension("refused");
                std::fs::rename(&place, &aside).map_err(|e| Error::file("rename", &place, e))?;
                refused = Some(Error::input(aside.display().to_string(), problem, TRUE_ONE));
                continue;
            }
            let (Kept::Added(id) | Kept::Known(id)) = logbook.keep(&bytes)?;
            std::fs::remove_file(&place).map_err(|e| Error::file("remove", &place, e))?;
            entered.push((place, id));
        }
        match refused {
            Some(error) => Err(error),
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
