//! Files of any content, as they come from a colleague, a stick or a text editor.
//!
//! Each is read or refused; a refusal blames the file and says what is wrong.

mod dataset;
mod logbook;
mod metrology;
mod seeds;
mod signed;
mod texts;

pub use dataset::{dataset, rig};
pub use logbook::logbook;
pub use metrology::metrology;
pub use signed::signed;
pub use texts::{particulars, points, settings, teds};

pub(super) use seeds::seeds;

use calib_files::Error;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

thread_local! {
    /// Where this thread's files are put.
    static FOLDER: TempDir = TempDir::new().expect("a folder for files");
}

/// Puts a file of this name and content there.
fn put(name: &str, content: &[u8]) -> PathBuf {
    let path = folder().join(name);
    // A new file: some file systems flush one that is written over.
    let _ = std::fs::remove_file(&path);
    std::fs::write(&path, content).expect("a file");
    path
}

fn folder() -> PathBuf {
    FOLDER.with(|folder| folder.path().to_owned())
}

/// Value read, if it was not refused with the file's name.
fn read_or_refused<T>(path: &Path, read: Result<T, Error>) -> Option<T> {
    let error = match read {
        Ok(read) => return Some(read),
        Err(error) => error,
    };
    let said = error.to_string();
    assert!(matches!(error.exit_code(), 1 | 6), "{said}");
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    assert!(said.contains(&*name), "which file? {said}");
    None
}
