//! A lake of many laboratories' records: Parquet by laboratory, instrument and year, added to and never changed.
//!
//! ```text
//! LAKE/records/laboratory=NPL/instrument=23004100075457494E303120/year=2026/1f0c9a...parquet
//! LAKE/points/..., LAKE/settings/..., LAKE/budgets/..., LAKE/checks/...
//! ```
//!
//! A file holds what one call added to a partition and has the same name in every table. That in `records` is
//! written last: with it the addition is there, without it the files of its name are the leftovers of a call that
//! was cut off, which the next one removes. So an addition is seen whole or not at all, and the same record, by its
//! SHA-256, is there once, whoever adds it and how often. Columns are only ever added at the end, and every one may
//! be empty: files of before are read beside those of now.

use super::Logbook;
use super::lake_tables::{LAKE_TABLES, Partition, escaped, rows};
use super::parquet::{texts, write};
use calib_files::{Error, Result, file};
use rusqlite::params;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, HashSet};
use std::ffi::OsString;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// Additions to a lake.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Addition {
    /// Files that are new.
    pub files: Vec<PathBuf>,
    /// Records in them.
    pub records: usize,
}

/// A record of the logbook: its number there and its sum.
type Line = (i64, String);

/// Table whose files say what is there.
const LAST: &str = "records";
/// Files on their way, which no engine reads below this name.
const STAGED: &str = "_staged";

/// Adds what the lake lacks of this logbook, under the name of its laboratory.
///
/// # Errors
/// [`Error::Usage`] for a laboratory without a name; [`Error::File`]; [`Error::Input`] when a record or a file of
/// the lake is damaged.
pub fn add_to_lake(logbook: &Logbook, lake: &Path, laboratory: &str) -> Result<Addition> {
    if laboratory.trim().is_empty() {
        let hint = "name it with --laboratory-name: it is a part of every path";
        return Err(Error::usage("the laboratory has no name", hint));
    }
    let staged = lake.join(STAGED);
    fs::create_dir_all(&staged).map_err(|e| Error::file("create", &staged, e))?;
    // Of two calls at a time the second waits, and then finds what the first has added.
    let lock = lake.join("_lock");
    let held = file::open_itself(&lock)?;
    held.lock().map_err(|e| Error::file("lock", &lock, e))?;
    let of_laboratory = format!("laboratory={}", escaped(laboratory));
    let mut addition = Addition::default();
    for (partition, lines) in logbook.partitions()? {
        let place = Place {
            lake,
            below: Path::new(&of_laboratory).join(partition.below()),
        };
        place.add(logbook, &partition, lines, &mut addition)?;
    }
    Ok(addition)
}

impl Logbook {
    /// Records by instrument and year, in the order they were kept.
    fn partitions(&self) -> Result<BTreeMap<Partition, Vec<Line>>> {
        let sql = "SELECT instrument, iif(unix_time_s > 0,
                   CAST(strftime('%Y', unix_time_s, 'unixepoch') AS INTEGER), 0), id, lower(hex(sha256))
                   FROM records ORDER BY id";
        let mut all: BTreeMap<Partition, Vec<Line>> = BTreeMap::new();
        self.all(sql, params![], |row| {
            let partition = Partition {
                instrument: row.get(0)?,
                year: row.get(1)?,
            };
            let line = (row.get(2)?, row.get(3)?);
            all.entry(partition).or_default().push(line);
            Ok(())
        })?;
        Ok(all)
    }
}

/// A partition of a lake.
struct Place<'a> {
    lake: &'a Path,
    below: PathBuf,
}

impl Place<'_> {
    fn folder(&self, table: &str) -> PathBuf {
        self.lake.join(table).join(&self.below)
    }

    fn add(
        &self,
        logbook: &Logbook,
        partition: &Partition,
        lines: Vec<Line>,
        addition: &mut Addition,
    ) -> Result<()> {
        let known = known(self.lake, partition)?;
        let new: Vec<Line> = lines
            .into_iter()
            .filter(|(_, sum)| !known.contains(sum))
            .collect();
        if new.is_empty() {
            return Ok(());
        }
        let name = name(&new);
        let ids: HashSet<i64> = new.iter().map(|(id, _)| *id).collect();
        let parts = rows(logbook, partition, &ids)?;
        // The order of LAKE_TABLES: `records` is the last.
        for (table, part) in LAKE_TABLES.iter().zip(&parts) {
            let file = self.folder(table.name).join(&name);
            let staged = self.lake.join(STAGED).join(&name);
            write(&staged, table, part)?;
            self.put(&staged, &file)?;
            addition.files.push(file);
        }
        addition.records += new.len();
        Ok(())
    }

    /// A file that is there is whole, and is on disk before the next one is begun.
    fn put(&self, staged: &Path, path: &Path) -> Result<()> {
        let kept = File::options().write(true).open(staged);
        let kept = kept.and_then(|written| written.sync_all());
        kept.map_err(|e| Error::file("write", staged, e))?;
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(|e| Error::file("create", folder, e))?;
        }
        file::rename(staged, path)
    }
}

/// Sums of the records of an instrument and year that are there, by whatever name a laboratory added them: it may have
/// taken another since. What a call has written that was cut off before its `records` is removed.
fn known(lake: &Path, partition: &Partition) -> Result<HashSet<String>> {
    let mut known = HashSet::new();
    // The first table has whatever the last one has.
    for laboratory in folders(&lake.join(LAKE_TABLES[0].name))? {
        let below = Path::new(&laboratory).join(partition.below());
        let whole = files(&lake.join(LAST).join(&below))?;
        for table in LAKE_TABLES.iter().filter(|table| table.name != LAST) {
            remove_others(&lake.join(table.name).join(&below), &whole)?;
        }
        for name in &whole {
            let file = lake.join(LAST).join(&below).join(name);
            known.extend(texts(&file, "record_sha256")?);
        }
    }
    Ok(known)
}

/// Leaves these files in a folder alone.
fn remove_others(folder: &Path, names: &[OsString]) -> Result<()> {
    for left in files(folder)?.iter().filter(|name| !names.contains(name)) {
        let file = folder.join(left);
        fs::remove_file(&file).map_err(|e| Error::file("remove", &file, e))?;
    }
    Ok(())
}

/// Names of the folders in a folder, which need not be there.
fn folders(folder: &Path) -> Result<Vec<OsString>> {
    let mut names = entries(folder)?;
    names.retain(|name| folder.join(name).is_dir());
    Ok(names)
}

/// Names of the Parquet files in a folder, which need not be there.
fn files(folder: &Path) -> Result<Vec<OsString>> {
    let mut names = entries(folder)?;
    names.retain(|name| {
        Path::new(name)
            .extension()
            .is_some_and(|is| is == "parquet")
    });
    Ok(names)
}

/// Names of what is in a folder, which need not be there.
fn entries(folder: &Path) -> Result<Vec<OsString>> {
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries.map_err(|e| Error::file("read", folder, e))?,
    };
    let names = entries.map(|entry| entry.map(|entry| entry.file_name()));
    let names: std::io::Result<Vec<OsString>> = names.collect();
    names.map_err(|e| Error::file("read", folder, e))
}

/// Name by the records: the same records make the same file.
fn name(lines: &[Line]) -> OsString {
    let mut hash = Sha256::new();
    for (_, sum) in lines {
        hash.update(sum.as_bytes());
    }
    format!("{}.parquet", hex::encode(&hash.finalize()[..16])).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_leaves_its_folder_or_becomes_another() {
        assert_eq!(escaped("PTB Braunschweig/1.7"), "PTB%20Braunschweig%2F1.7");
        assert_eq!(escaped("../x=1"), "..%2Fx%3D1");
        assert_eq!(escaped("ä"), "%C3%A4");
        assert_ne!(escaped("a%2F"), escaped("a/"));
        assert_eq!(escaped(""), "__HIVE_DEFAULT_PARTITION__");
    }
}
