//! A logbook copied as it is, and what another one has taken over.

use super::journal::{self, Subject};
use super::signed_files;
use super::store::create_private;
use super::{CheckStandard, Filter, InstrumentKey, Issued, Kept, Logbook, Sensor};
use calib_files::{Error, Result, file};
use calib_protocol::text::steers;
use calib_record::signature::short;
use rusqlite::{Connection, OptionalExtension, params};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::Path;

/// Result of a merge: entries taken over, and not.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Merged {
    /// Records that are new here.
    pub records: u32,
    /// Sensors and check standards that are new here.
    pub sensors: u32,
    /// Certificates that are new here, or signed files of one.
    pub certificates: u32,
    /// Entries that both had alike.
    pub known: u32,
    /// Entries the other has otherwise, or that something speaks against, in words: they stay there alone.
    pub conflicts: Vec<String>,
}

impl Merged {
    fn count(&mut self, what: fn(&mut Self) -> &mut u32, done: Result<bool>) -> Result<()> {
        match done {
            Ok(true) => *what(self) += 1,
            Ok(false) => self.known += 1,
            // The file of the other or our own cannot be used: no conflict of contents.
            Err(error @ Error::File { .. }) => return Err(error),
            // The words of a file of somebody else: each conflict is one line.
            Err(error) => self.conflicts.push(error.to_string().replace(steers, "?")),
        }
        Ok(())
    }
}

impl Logbook {
    /// Copies the logbook, as it is at one moment, into a new file for its user alone. Returns what is wrong with
    /// the copy, in words: nothing when all is well.
    ///
    /// # Errors
    /// [`Error::Input`] when there is a file of this name, [`Error::File`] when it cannot be written.
    pub fn backup(&self, path: &Path) -> Result<Vec<String>> {
        let place = || path.display().to_string();
        if path.exists() {
            let hint = "name another: a backup is never overwritten";
            return Err(Error::input(place(), "is there already", hint));
        }
        // What a program that was killed has left of it is nobody's.
        let part = path.with_added_extension("part");
        let _ = std::fs::remove_file(&part);
        create_private(&part)?;
        let name = part.to_str().ok_or_else(|| {
            Error::input(place(), "has a name that is no text", "name it otherwise")
        })?;
        let copy = self.connection.execute("VACUUM INTO ?1", [name]);
        copy.map_err(|error| self.failure(error))?;
        let copy = std::fs::File::open(&part).and_then(|file| file.sync_all());
        copy.map_err(|error| Error::file("write", path, error))?;
        file::rename(&part, path)?;
        let copy = Self::open_existing(path)?;
        let mut wrong = copy.inspect()?;
        wrong.extend(copy.inspect_seals(&[])?);
        Ok(wrong)
    }

    /// Takes over what `other` has and this one has not. What both have in different ways is named; both stay as
    /// they are there. The same twice changes nothing.
    ///
    /// # Errors
    /// [`Error::Input`] when something in `other` is not as it was entered, or it is this one; those of the files.
    pub fn merge(&mut self, other: &Self) -> Result<Merged> {
        let same = |a: &Path, b: &Path| a.canonicalize().ok() == b.canonicalize().ok();
        let place = || other.path.display().to_string();
        if same(&self.path, &other.path) {
            return Err(Error::input(
                place(),
                "is this logbook",
                "name the other one",
            ));
        }
        if let Some(problem) = other.inspect()?.first() {
            let hint = "`calib logbook check --logbook FILE` names all of it; mend it first";
            return Err(Error::input(place(), problem.as_str(), hint));
        }
        let mut merged = Merged::default();
        for instrument in other.keyed_instruments()? {
            for theirs in other.keys(&instrument)? {
                let entered = self.merge_key(&instrument, &theirs).map(|()| false);
                merged.count(|merged| &mut merged.known, entered)?;
            }
        }
        self.merge_records(other, &mut merged)?;
        for sensor in other.sensors("")? {
            merged.count(|merged| &mut merged.sensors, self.take_sensor(&sensor))?;
        }
        for standard in other.check_standards()? {
            merged.count(|merged| &mut merged.sensors, self.take_standard(&standard))?;
        }
        for issued in other.certificates()? {
            merged.count(
                |merged| &mut merged.certificates,
                self.take_certificate(&issued),
            )?;
        }
        for (certificate, amended) in other.amendments()? {
            let taken = self.take_amendment(&certificate, &amended);
            merged.count(|merged| &mut merged.known, taken.map(|()| false))?;
        }
        for check in other.self_checks()? {
            let taken = self.keep_self_check(&check);
            merged.count(|merged| &mut merged.known, taken.map(|_| false))?;
        }
        self.take_joined(other)?;
        Ok(merged)
    }

    /// The first key of an instrument is believed; that it has another since is not for a file to say.
    fn merge_key(&self, instrument: &str, theirs: &InstrumentKey) -> Result<()> {
        let ours = self.keys(instrument)?;
        let public = theirs.key.public;
        match theirs.series {
            _ if ours.iter().any(|key| key.key.public == public) => Ok(()),
            0 => self.enter_key(instrument, &theirs.key).map(drop),
            _ => Err(Error::input(
                format!("instrument {instrument}"),
                format!(
                    "has the key {} in the other logbook, because: {}",
                    short(&public),
                    theirs.reason
                ),
                "connect it, and say so here too: `calib key --replaced REASON`; then merge again",
            )),
        }
    }

    /// Oldest first, as they were entered.
    fn merge_records(&mut self, other: &Self, merged: &mut Merged) -> Result<()> {
        for line in other.records(&Filter::default())?.iter().rev() {
            let kept = self.keep(&other.record(line.id)?);
            let taken = kept.map(|kept| matches!(kept, Kept::Added(_)));
            merged.count(|merged| &mut merged.records, taken)?;
        }
        Ok(())
    }

    fn take_sensor(&self, theirs: &Sensor) -> Result<bool> {
        match self.sensor(&theirs.serial)? {
            None => self.put_sensor(theirs).map(|()| true),
            Some(ours) if ours == *theirs => Ok(false),
            Some(_) => Err(differs(&format!("sensor {}", theirs.serial))),
        }
    }

    fn take_standard(&self, theirs: &CheckStandard) -> Result<bool> {
        match self.check_standard(&theirs.serial)? {
            None => self.put_check_standard(theirs).map(|()| true),
            Some(ours) if ours == *theirs => Ok(false),
            Some(_) => Err(differs(&format!("check standard {}", theirs.serial))),
        }
    }

    fn take_certificate(&self, theirs: &Issued) -> Result<bool> {
        let place = format!("certificate {} as {}", theirs.certificate, theirs.format);
        let put = || {
            let transaction = self.writing()?;
            let ours = "SELECT lower(hex(sha256)), lower(hex(record_sha256)) FROM certificates
                        WHERE certificate = ?1 AND format = ?2";
            let ours = transaction.query_row(ours, [&theirs.certificate, &theirs.format], |row| {
                Ok((row.get::<_, String>(0)?, row.get::<_, String>(1)?))
            });
            if let Some((sum, record)) = ours.optional()? {
                let alike = sum == theirs.sha256 && record == theirs.record_sha256;
                let is_new = alike && take_signed(&transaction, theirs)?;
                transaction.commit()?;
                return Ok(match is_new {
                    true => None,
                    false => Some(alike),
                });
            }
            transaction.execute(
                "INSERT INTO certificates (certificate, format, record_sha256, issued_s, file, sha256)
                 VALUES (?1, ?2, unhex(?3), ?4, ?5, unhex(?6))",
                params![
                    theirs.certificate,
                    theirs.format,
                    theirs.record_sha256,
                    theirs.issued_s,
                    theirs.file,
                    theirs.sha256
                ],
            )?;
            let number = transaction.last_insert_rowid().to_string();
            journal::enter(&transaction, Subject::Certificate, &number)?;
            take_signed(&transaction, theirs)?;
            transaction.commit()?;
            Ok(None)
        };
        match put().map_err(|error| self.failure(error))? {
            None => Ok(true),
            Some(true) => Ok(false),
            Some(false) => Err(differs(&place)),
        }
    }
}

/// Takes over the signed files of a certificate; whether one is new.
fn take_signed(connection: &Connection, theirs: &Issued) -> rusqlite::Result<bool> {
    let mut is_new = false;
    for file in &theirs.signed {
        is_new |= signed_files::enter(connection, &theirs.certificate, &theirs.format, file)?;
    }
    Ok(is_new)
}

fn differs(place: &str) -> Error {
    let hint = "look at both, and change the one that is wrong";
    Error::input(place, "is another in the other logbook", hint)
}
