//! Files that are either there and whole, or not there.

use crate::{Error, Result};
use std::io::{ErrorKind, Write};
use std::path::Path;

/// Treatment of a file that is there already with other content.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Existing {
    /// It stays and nothing is written: what was once given out is kept.
    #[default]
    Keep,
    /// It is replaced.
    Replace,
}

/// [`create`] or [`replace`].
///
/// # Errors
/// Theirs.
pub fn write(path: &Path, content: &[u8], existing: Existing) -> Result<()> {
    match existing {
        Existing::Keep => create(path, content),
        Existing::Replace => replace(path, content),
    }
}

/// Writes a file so that a reader sees the old content or the new one, never
/// half of it: a temporary file beside it, synchronised, then renamed.
///
/// # Errors
/// [`Error::File`]; nothing is left behind.
pub fn replace(path: &Path, content: &[u8]) -> Result<()> {
    let temporary = temporary(path, content)?;
    temporary
        .persist(path)
        .map_err(|error| Error::file("write", path, error.error))?;
    sync_folder(folder_of(path))
}

/// Gives a whole file, or a folder, that is on disk its name, for good.
///
/// # Errors
/// [`Error::File`].
pub fn rename(from: &Path, to: &Path) -> Result<()> {
    std::fs::rename(from, to).map_err(|error| Error::file("write", to, error))?;
    sync_folder(folder_of(to))
}

/// Like [`replace`], but never over an existing file with other content.
///
/// # Errors
/// [`Error::Input`] when the file exists with other content; [`Error::File`].
pub fn create(path: &Path, content: &[u8]) -> Result<()> {
    let temporary = temporary(path, content)?;
    let Err(error) = temporary.persist_noclobber(path) else {
        return sync_folder(folder_of(path));
    };
    if error.error.kind() != ErrorKind::AlreadyExists {
        return Err(Error::file("write", path, error.error));
    }
    match std::fs::read(path) {
        Ok(existing) if existing == content => Ok(()),
        Ok(_) => Err(Error::input(
            path.display().to_string(),
            "exists with another content, and is not overwritten",
            "give another directory with --out, or move the file away",
        )),
        Err(error) => Err(Error::file("read", path, error)),
    }
}

/// Opens a file to add to, or to lock, and makes it if it is not there. What is in it stays, and what a link of this name
/// leads to is not touched.
///
/// # Errors
/// [`Error::File`].
pub fn open_itself(path: &Path) -> Result<std::fs::File> {
    let mut options = std::fs::OpenOptions::new();
    options.read(true).append(true).create(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags(rustix::fs::OFlags::NOFOLLOW.bits().cast_signed());
    }
    let opened = options.open(path);
    opened.map_err(|error| Error::file("write", path, error))
}

pub(crate) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Makes a new name outlive a power cut: until its folder is on disk, the file has the old name or none.
#[cfg(unix)]
pub(crate) fn sync_folder(folder: &Path) -> Result<()> {
    let synced = std::fs::File::open(folder).and_then(|folder| folder.sync_all());
    match synced {
        // Some file systems of networks cannot.
        Err(error) if error.kind() != ErrorKind::InvalidInput => {
            Err(Error::file("write", folder, error))
        }
        _ => Ok(()),
    }
}

/// A folder cannot be opened here; its entries are journalled by the system.
#[cfg(not(unix))]
pub(crate) fn sync_folder(_: &Path) -> Result<()> {
    Ok(())
}

/// The content, on disk, under a temporary name beside `path`.
pub(crate) fn temporary(path: &Path, content: &[u8]) -> Result<tempfile::NamedTempFile> {
    let failed = |error| Error::file("write", path, error);
    let directory = folder_of(path);
    std::fs::create_dir_all(directory).map_err(|error| Error::file("create", directory, error))?;
    let mut file = tempfile::Builder::new()
        .permissions_like_a_plain_file()
        .tempfile_in(directory)
        .map_err(failed)?;
    file.write_all(content).map_err(failed)?;
    file.as_file().sync_all().map_err(failed)?;
    Ok(file)
}

/// Temporary files are private by default; a certificate is not.
trait PlainPermissions {
    fn permissions_like_a_plain_file(&mut self) -> &mut Self;
}

impl PlainPermissions for tempfile::Builder<'_, '_> {
    #[cfg(unix)]
    fn permissions_like_a_plain_file(&mut self) -> &mut Self {
        use std::os::unix::fs::PermissionsExt;
        // The user's mask is applied to this by the system.
        self.permissions(std::fs::Permissions::from_mode(0o666))
    }

    #[cfg(not(unix))]
    fn permissions_like_a_plain_file(&mut self) -> &mut Self {
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_or_kept_as_asked() {
        let directory = tempfile::tempdir().expect("directory");
        let path = directory.path().join("new/folder/a.csv");
        create(&path, b"one").expect("created");
        create(&path, b"one").expect("the same again");
        let error = create(&path, b"two").expect_err("other content");
        assert_eq!(error.exit_code(), 6);
        assert_eq!(std::fs::read(&path).expect("read"), b"one");
        replace(&path, b"two").expect("replaced");
        assert_eq!(std::fs::read(&path).expect("read"), b"two");
        let left = std::fs::read_dir(path.parent().expect("folder")).expect("list");
        assert_eq!(left.count(), 1, "no temporary file stays");
    }

    #[cfg(unix)]
    #[test]
    fn what_a_link_leads_to_is_not_touched() {
        let directory = tempfile::tempdir().expect("directory");
        let at = |name: &str| directory.path().join(name);
        std::fs::write(at("precious"), "kept").expect("written");
        std::os::unix::fs::symlink(at("precious"), at("board.lock")).expect("linked");
        assert!(open_itself(&at("board.lock")).is_err());
        assert!(open_itself(&at("precious")).is_ok(), "a file is itself");
        assert_eq!(std::fs::read(at("precious")).expect("read"), b"kept");
    }

    #[test]
    fn a_path_that_cannot_be_written_is_named() {
        let directory = tempfile::tempdir().expect("directory");
        let file = directory.path().join("file");
        replace(&file, b"x").expect("written");
        let error = replace(&file.join("below"), b"y").expect_err("a file is no folder");
        assert_eq!(error.exit_code(), 1);
        assert!(error.to_string().contains("file"), "{error}");
    }
}
