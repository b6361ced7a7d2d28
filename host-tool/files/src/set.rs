//! Files that are never half-written: all to temporary names, then renamed.

use crate::file::{self, Existing};
use crate::{Error, Result};
use std::collections::BTreeSet;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Writes `files` (name, content) into `folder`, creating it if necessary.
///
/// Every file is written and flushed to disk under a temporary name in the
/// same folder before the first one gets its name. When one cannot be written
/// (disk full, no permission) none appears and the temporary ones are removed;
/// a reader never sees part of a file.
///
/// # Errors
/// [`Error::Input`] when a file with other content is to be kept,
/// [`Error::File`] with the path and what the operating system said.
pub fn write_all(
    folder: &Path,
    files: &[(String, Vec<u8>)],
    existing: Existing,
) -> Result<Vec<PathBuf>> {
    std::fs::create_dir_all(folder).map_err(|e| Error::file("create", folder, e))?;
    let mut staged = Staged::new(existing);
    for (name, content) in files {
        staged.add(folder.join(name), content)?;
    }
    staged.name_all()
}

/// Files that are whole and on disk, and have no name yet: what must be done before anybody sees them is done
/// now. Without [`Staged::name_all`] none of them stays.
#[derive(Debug, Default)]
pub struct Staged {
    files: Vec<(tempfile::NamedTempFile, PathBuf)>,
    existing: Existing,
}

impl Staged {
    /// None yet.
    pub fn new(existing: Existing) -> Self {
        let files = Vec::new();
        Self { files, existing }
    }

    /// Writes one that is to be at `path`.
    ///
    /// # Errors
    /// As [`write_all`].
    pub fn add(&mut self, path: PathBuf, content: &[u8]) -> Result<()> {
        may_be_written(&path, content, self.existing)?;
        self.files.push((file::temporary(&path, content)?, path));
        Ok(())
    }

    /// Gives all of them their names, or none.
    ///
    /// # Errors
    /// As [`write_all`].
    pub fn name_all(self) -> Result<Vec<PathBuf>> {
        let mut written = Vec::with_capacity(self.files.len());
        let mut new = Vec::new();
        for (temporary, path) in self.files {
            match name(temporary, &path, self.existing) {
                Ok(true) => new.push(path.clone()),
                Ok(false) => (),
                Err(error) => {
                    // All or none: those of this set that were not there before go.
                    new.iter().for_each(|path| drop(std::fs::remove_file(path)));
                    return Err(error);
                }
            }
            written.push(path);
        }
        let folders: BTreeSet<&Path> = written.iter().map(|path| file::folder_of(path)).collect();
        folders.into_iter().try_for_each(file::sync_folder)?;
        Ok(written)
    }
}

/// Gives a file its name; false when a file of that name was there before.
fn name(temporary: tempfile::NamedTempFile, path: &Path, existing: Existing) -> Result<bool> {
    let failed = |error| Error::file("write", path, error);
    if existing == Existing::Replace {
        let old = path.exists();
        let renamed = temporary.persist(path).map_err(|e| failed(e.error));
        return renamed.map(|_| !old);
    }
    match temporary.persist_noclobber(path) {
        Ok(_) => Ok(true),
        Err(error) if error.error.kind() == ErrorKind::AlreadyExists => {
            // Another program may have come first.
            let ours = std::fs::read(error.file.path()).map_err(failed)?;
            may_be_written(path, &ours, existing).map(|()| false)
        }
        Err(error) => Err(failed(error.error)),
    }
}

fn may_be_written(path: &Path, content: &[u8], existing: Existing) -> Result<()> {
    if path.is_dir() {
        let source = std::io::ErrorKind::IsADirectory.into();
        return Err(Error::file("replace", path, source));
    }
    let kept =
        existing == Existing::Keep && std::fs::read(path).is_ok_and(|present| present != content);
    if kept {
        return Err(Error::input(
            path.display().to_string(),
            "exists with other content, and a certificate is not overwritten",
            "give another directory with --out, or move the file away",
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = std::fs::read_dir(folder).expect("folder");
        let mut names: Vec<_> = entries
            .map(|entry| {
                entry
                    .expect("entry")
                    .file_name()
                    .to_string_lossy()
                    .into_owned()
            })
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_file_that_cannot_be_written_leaves_no_other_behind() {
        let folder = tempfile::tempdir().expect("folder");
        std::fs::create_dir(folder.path().join("b.csv")).expect("a folder in the way");
        let files = [
            ("a.csv".to_owned(), b"a".to_vec()),
            ("b.csv".to_owned(), b"b".to_vec()),
        ];
        let error =
            write_all(folder.path(), &files, Existing::Keep).expect_err("b.csv is a folder");
        assert!(error.to_string().contains("b.csv"), "{error}");
        assert_eq!(names(folder.path()), ["b.csv"]);
    }

    #[test]
    fn a_folder_that_is_a_file_is_named() {
        let folder = tempfile::tempdir().expect("folder");
        let file = folder.path().join("certificates");
        std::fs::write(&file, "x").expect("written");
        let error = write_all(&file, &[], Existing::Keep).expect_err("not a folder");
        assert!(error.to_string().contains("certificates"), "{error}");
    }

    #[test]
    fn an_older_file_is_kept_or_replaced_whole_as_asked() {
        let folder = tempfile::tempdir().expect("folder");
        let put = |content: &[u8], existing| {
            write_all(
                folder.path(),
                &[("a.txt".to_owned(), content.to_vec())],
                existing,
            )
        };
        let content = || std::fs::read(folder.path().join("a.txt")).expect("read");
        put(b"first and longer", Existing::Keep).expect("written");
        put(b"first and longer", Existing::Keep).expect("the same again");
        let error = put(b"second", Existing::Keep).expect_err("kept");
        assert!(error.to_string().contains("a.txt"), "{error}");
        assert_eq!(content(), b"first and longer");
        put(b"second", Existing::Replace).expect("replaced");
        assert_eq!(content(), b"second");
        assert_eq!(names(folder.path()), ["a.txt"]);
    }
}
