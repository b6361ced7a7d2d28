//! Downloading a stored record: chunk by chunk, resumed where it broke off.
//!
//! Received bytes are kept in `NAME.part` beside the destination, chunk by
//! chunk. The next attempt goes on at its end, whatever byte that is. Only a
//! record whose checksum holds gets the final name.

use crate::Client;
use crate::{Error, Result};
use calib_files::file::{self, Existing};
use calib_protocol::record::{self, HashLink, Record, RecordError, RecordSummary};
use calib_protocol::signature::DeviceKey;
use calib_record::hash_chain::{self, Evidence};
use std::fs::{File, TryLockError};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Longest record accepted from a device, in bytes. 200 points take 20 kB; a
/// broken device must not fill the disk.
const MAX_RECORD: u32 = 1 << 20;
/// How long a part that is locked is waited for: 0.2 s.
const LOCK_TRIES: u32 = 20;
const LOCK_PAUSE: Duration = Duration::from_millis(10);

/// A record of any kind that arrived whole.
#[derive(Debug)]
pub struct Fetched {
    /// The file with the record's stored form.
    pub path: PathBuf,
    /// Its content.
    pub bytes: Vec<u8>,
    /// Its place in the chain.
    pub link: HashLink,
    /// Bytes that an earlier, interrupted download had left.
    pub resumed_at: usize,
}

/// The record of a calibration that arrived whole.
#[derive(Debug)]
pub struct Download {
    /// The file with the record's stored form.
    pub path: PathBuf,
    /// Its content.
    pub record: Record,
    /// Bytes that an earlier, interrupted download had left.
    pub resumed_at: usize,
}

/// How far a download is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Bytes that are here.
    pub done: u32,
    /// Bytes of the record.
    pub total: u32,
}

/// Downloads record `id` into `directory`, as `record-00007.calibrec`.
///
/// # Errors
/// Those of the link: call again, and the download goes on where it broke off.
/// [`Error::Input`] when the record is damaged in the device's flash, when it is
/// of another version, and when the file exists with another content.
pub fn download(
    client: &mut Client,
    id: u32,
    directory: &Path,
    progress: impl FnMut(Progress),
) -> Result<Download> {
    download_with(client, id, directory, Existing::Keep, progress)
}

/// As [`download`], and says what happens to an existing file.
///
/// # Errors
/// As [`download`].
pub fn download_with(
    client: &mut Client,
    id: u32,
    directory: &Path,
    existing: Existing,
    progress: impl FnMut(Progress),
) -> Result<Download> {
    let fetched = fetch(client, id, directory, existing, progress)?;
    let record = record::decode(&fetched.bytes).map_err(|error| broken(client, id, error))?;
    Ok(Download {
        path: fetched.path,
        record,
        resumed_at: fetched.resumed_at,
    })
}

/// The record of a calibration and its stored form, of which nothing stays on disk.
///
/// # Errors
/// As [`download`].
pub fn take(client: &mut Client, id: u32) -> Result<(Record, Vec<u8>)> {
    let folder =
        tempfile::tempdir().map_err(|error| Error::file("create", &std::env::temp_dir(), error))?;
    let fetched = fetch(client, id, folder.path(), Existing::Keep, |_| ())?;
    let record = record::decode(&fetched.bytes).map_err(|error| broken(client, id, error))?;
    Ok((record, fetched.bytes))
}

/// As [`download_with`], for a record of any kind.
///
/// # Errors
/// As [`download`].
pub fn fetch(
    client: &mut Client,
    id: u32,
    directory: &Path,
    existing: Existing,
    mut progress: impl FnMut(Progress),
) -> Result<Fetched> {
    std::fs::create_dir_all(directory).map_err(|error| Error::file("create", directory, error))?;
    let path = directory.join(hash_chain::file_name(id));
    let mut part = Part::open(path.with_extension("calibrec.part"))?;
    let resumed_at = part.bytes.len();
    if let Err(error) = part.fetch(client, id, &mut progress) {
        part.drop_if_empty();
        return Err(error);
    }
    let checked = record::check(&part.bytes);
    if resumed_at > 0 && matches!(checked, Err(RecordError::Checksum | RecordError::Length)) {
        // What was left may belong to another instrument: once from the start.
        part.restart()?;
        part.fetch(client, id, &mut progress)?;
    }
    let link = whole(&part.bytes).map_err(|error| {
        // Starting from the first byte is the only thing worth trying again.
        let _ = std::fs::remove_file(&part.path);
        broken(client, id, error)
    })?;
    file::write(&path, &part.bytes, existing)?;
    std::fs::remove_file(&part.path).map_err(|error| Error::file("remove", &part.path, error))?;
    Ok(Fetched {
        path,
        bytes: part.bytes,
        link,
        resumed_at,
    })
}

/// The place of a record that can be read to its end.
fn whole(bytes: &[u8]) -> Result<HashLink, RecordError> {
    record::inspect(bytes)?;
    record::hash_link(bytes)
}

/// Facts from the calibrator and `folder` about records that were downloaded: their
/// sums, and their neighbours.
///
/// # Errors
/// Those of the link.
pub fn evidence(client: &mut Client, fetched: &[Fetched], folder: &Path) -> Result<Evidence> {
    let mut evidence = Evidence::of(&client.info()?.serial);
    evidence.key(client.key()?);
    evidence.list(&lines(client, fetched)?);
    for record in fetched {
        evidence.bytes(record.link.id, &record.bytes);
    }
    for record in fetched {
        evidence.neighbours(record.link.id, folder);
    }
    Ok(evidence)
}

/// Serial number and key of the instrument, if it has one.
///
/// # Errors
/// Those of the link.
pub fn stated_key(client: &mut Client) -> Result<Option<(String, DeviceKey)>> {
    let key = client.key()?;
    let serial = client.info()?.serial;
    Ok(key.map(|key| (serial.as_str().to_owned(), key)))
}

/// For one record the lines around it; where the one before is not among them,
/// and for several records, all there are.
fn lines(client: &mut Client, fetched: &[Fetched]) -> Result<Vec<RecordSummary>> {
    if let [one] = fetched {
        let before = one.link.id.saturating_sub(1);
        let (lines, _) = client.page(before)?;
        if before == 0 || lines.first().is_some_and(|line| line.id == before) {
            return Ok(lines);
        }
    }
    client.records()
}

fn broken(client: &Client, id: u32, error: RecordError) -> Error {
    let hint = match error {
        RecordError::Kind { .. } => "`calib show` shows it",
        _ if error.is_of_newer_release() => {
            "install the release of this tool that came with the firmware"
        }
        _ => "download it once more; if that fails too, the record is damaged in flash",
    };
    Error::input(
        format!("record {id} of {}", client.name()),
        error.to_string(),
        hint,
    )
}

/// The part of a record that is here, in memory and on disk.
struct Part {
    path: PathBuf,
    file: File,
    bytes: Vec<u8>,
}

/// Opens a file for one download at a time, and never what a link of that name leads to.
fn open_alone(path: &Path) -> Result<File> {
    let file = file::open_itself(path)?;
    match locked(&file) {
        Ok(()) => Ok(file),
        Err(TryLockError::WouldBlock) => Err(Error::input(
            path.display().to_string(),
            "another program downloads this record",
            "wait for it, or give another directory with --out",
        )),
        Err(TryLockError::Error(error)) => Err(Error::file("lock", path, error)),
    }
}

/// Locks a file, with patience for a program that is just being started from this one: it holds what is
/// open here until it is loaded.
fn locked(file: &File) -> std::result::Result<(), TryLockError> {
    for _ in 0..LOCK_TRIES {
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => std::thread::sleep(LOCK_PAUSE),
            done => return done,
        }
    }
    file.try_lock()
}

impl Part {
    fn open(path: PathBuf) -> Result<Self> {
        let file = open_alone(&path)?;
        let mut bytes = Vec::new();
        (&file)
            .take(u64::from(MAX_RECORD) + 1)
            .read_to_end(&mut bytes)
            .map_err(|error| Error::file("read", &path, error))?;
        Ok(Self { path, file, bytes })
    }

    /// Removes an empty part: it helps nobody to go on.
    fn drop_if_empty(&self) {
        if self.bytes.is_empty() {
            let _ = std::fs::remove_file(&self.path);
        }
    }

    fn restart(&mut self) -> Result<()> {
        self.bytes.clear();
        self.file
            .set_len(0)
            .map_err(|error| Error::file("write", &self.path, error))
    }

    fn append(&mut self, data: &[u8]) -> Result<()> {
        self.bytes.extend_from_slice(data);
        self.file
            .write_all(data)
            .map_err(|error| Error::file("write", &self.path, error))
    }

    /// Fetches the rest of the record.
    fn fetch(
        &mut self,
        client: &mut Client,
        id: u32,
        progress: &mut impl FnMut(Progress),
    ) -> Result<()> {
        loop {
            let Ok(done) = u32::try_from(self.bytes.len()) else {
                return self.restart();
            };
            let chunk = match client.read_record(id, done) {
                // More is here than the record has, so this was the part of
                // another one: its checksum will fail.
                Err(Error::Refused(refused)) if done > 0 && refused.is_offset() => return Ok(()),
                other => other?,
            };
            if chunk.total > MAX_RECORD {
                return Err(Error::input(
                    format!("record {id} of {}", client.name()),
                    format!("claims {} bytes, more than any record has", chunk.total),
                    "reset the instrument and repeat",
                ));
            }
            self.append(&chunk.data)?;
            let done = self.bytes.len();
            progress(Progress {
                done: u32::try_from(done).unwrap_or(u32::MAX),
                total: chunk.total,
            });
            if done >= chunk.total as usize {
                return Ok(());
            }
            if chunk.data.is_empty() {
                return Err(Error::input(
                    format!("record {id} of {}", client.name()),
                    format!("ends at byte {done} of {}", chunk.total),
                    "reset the instrument and repeat",
                ));
            }
        }
    }
}
