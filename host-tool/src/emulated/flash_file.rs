//! The file in which an emulated calibrator keeps records and settings.

use super::{EmulatedBoard, firmware};
use crate::{Error, Result};
use calib_files::file;
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::runner::{Emulator, Error as BoardError};
use std::fs::{File, TryLockError};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// A file that one process holds at a time: of two boards that begin with the same content, the one
/// switched off last would undo what the other stored.
pub struct FlashFile {
    path: PathBuf,
    /// Locked until it is closed, however the process ends.
    _lock: File,
}

impl FlashFile {
    /// Takes the file, which need not be there, with a lock file beside it.
    ///
    /// # Errors
    /// [`Error::Input`] when another process holds it; [`Error::File`] when nothing can be kept there.
    pub fn hold(path: &Path) -> Result<Self> {
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(|e| Error::file("create", folder, e))?;
        }
        let beside = path.with_added_extension("lock");
        let lock = file::open_itself(&beside)?;
        match lock.try_lock() {
            Ok(()) => Ok(Self {
                path: path.to_owned(),
                _lock: lock,
            }),
            Err(TryLockError::WouldBlock) => Err(Error::input(
                path.display().to_string(),
                "the emulated calibrator is in use by another program",
                "wait for it, or close it; CALIB_STATE_DIR names a place for another one",
            )),
            Err(TryLockError::Error(error)) => Err(Error::file("lock", &beside, error)),
        }
    }

    /// Switches a board on that has what the file holds; `None` when there is no file.
    ///
    /// # Errors
    /// As [`EmulatedBoard::power_on`]; [`Error::File`]; [`Error::Input`] when it holds no flash.
    pub fn power_on(&self, rig: &Rig) -> Result<Option<EmulatedBoard>> {
        let flash = match std::fs::read(&self.path) {
            Ok(flash) => flash,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(Error::file("read", &self.path, error)),
        };
        let rig = Box::new(Plant::new(rig));
        match Emulator::power_on_with_flash(&firmware()?, rig, &flash) {
            Err(error @ BoardError::FlashSize { .. }) => Err(Error::input(
                self.path.display().to_string(),
                error.to_string(),
                "move the file away: the emulated calibrator then begins anew",
            )),
            board => EmulatedBoard::around(board).map(Some),
        }
    }

    /// Keeps what `board` has stored.
    ///
    /// # Errors
    /// [`Error::File`]: the file is as it was before.
    pub fn keep(&self, board: &EmulatedBoard) -> Result<()> {
        self.write(&board.record_flash()?)
    }

    /// Writes the content of a flash.
    ///
    /// # Errors
    /// [`Error::File`]: the file is as it was before.
    pub fn write(&self, content: &[u8]) -> Result<()> {
        Ok(file::replace(&self.path, content)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_at_a_time_holds_the_file() {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("state/board.flash");
        let first = FlashFile::hold(&path).expect("free");
        let error = FlashFile::hold(&path).err().expect("held");
        assert!(error.to_string().contains("in use"), "{error}");
        drop(first);
        assert!(FlashFile::hold(&path).is_ok());
    }
}
