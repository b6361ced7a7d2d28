//! Certificates that took the place of others (ISO/IEC 17025, 7.8.8). What was measured does not change by that:
//! the new one is made of the records of the old one.

use super::Logbook;
use super::issue::{Issue, Joined, Role, Sources};
use super::journal::{self, Subject};
use calib_certificate::Amendment;
use calib_files::{Error, Result};
use calib_protocol::record::Sha256Sum;
use rusqlite::{Connection, OptionalExtension, Row, params};

impl Logbook {
    /// Records that the certificate of this number is made of; none when it was never issued here.
    ///
    /// # Errors
    /// Those of the file.
    pub fn sources(&self, certificate: &str) -> Result<Option<Sources>> {
        let find =
            "SELECT record_sha256 FROM certificates WHERE certificate = ?1 ORDER BY number LIMIT 1";
        let record = self.optional(find, certificate, |row| row.get(0))?;
        let Some(record) = record else {
            return Ok(None);
        };
        let beside = "SELECT role, record_sha256 FROM joined WHERE certificate = ?1";
        let mut joined = self.all(beside, [certificate], |row| {
            Ok(Joined {
                role: Role::of(&row.get::<_, String>(0)?),
                record: row.get(1)?,
            })
        })?;
        joined.sort_unstable();
        Ok(Some(Sources { record, joined }))
    }

    /// The record of this sum, as it was downloaded.
    ///
    /// # Errors
    /// Those of the file; a wrong sum.
    pub fn record_of_sum(&self, sum: &Sha256Sum) -> Result<Option<Vec<u8>>> {
        let find = "SELECT id FROM records WHERE sha256 = ?1";
        let id = self
            .connection
            .query_row(find, [&sum[..]], |row| row.get(0));
        let id = id.optional().map_err(|error| self.failure(error))?;
        id.map(|id| self.record(id)).transpose()
    }

    /// Number of the certificate that took the place of this one, and why.
    ///
    /// # Errors
    /// Those of the file.
    pub fn replaced_by(&self, certificate: &str) -> Result<Option<Amendment>> {
        let find = "SELECT certificate, reason FROM amendments WHERE replaces = ?1";
        self.optional(find, certificate, amendment)
    }

    /// Number of the certificate whose place this one took, and why.
    ///
    /// # Errors
    /// Those of the file.
    pub fn replaces(&self, certificate: &str) -> Result<Option<Amendment>> {
        let find = "SELECT replaces, reason FROM amendments WHERE certificate = ?1";
        self.optional(find, certificate, amendment)
    }

    /// Number for what takes the place of this certificate for this reason: the same with `-A1`, `-A2` ..., or
    /// that of the amendment there is, of which another form is wanted.
    ///
    /// # Errors
    /// [`Error::Input`] when it was never issued here, or was replaced for another reason.
    pub fn number_of_amendment(&self, certificate: &str, reason: &str) -> Result<String> {
        if self.sources(certificate)?.is_none() {
            return Err(never_issued(certificate));
        }
        match self.replaced_by(certificate)? {
            Some(amended) if amended.reason == reason => return Ok(amended.certificate),
            Some(amended) => return Err(replaced(certificate, &amended)),
            None => {}
        }
        let (stem, mut count) = counted(certificate);
        loop {
            count += 1;
            let number = format!("{stem}-A{count}");
            if self.sources(&number)?.is_none() {
                return Ok(number);
            }
        }
    }

    /// Says whether this may take the place of what it replaces, and whether what it is itself was replaced.
    /// `is_there`: it was issued in this form.
    pub(super) fn may_replace(&self, issue: &Issue<'_>, is_there: bool) -> Result<()> {
        let number = issue.certificate;
        if let (Some(by), false) = (self.replaced_by(number)?, is_there) {
            return Err(replaced(number, &by));
        }
        let refuse = |problem: &str, hint: &str| {
            let place = format!("certificate {number}");
            Err(Error::input(place, problem, hint))
        };
        let known = self.replaces(number)?;
        match issue.replaces {
            stated if stated == known.as_ref() => Ok(()),
            None => refuse(
                "took the place of another, which this one does not say",
                "--amend that one for the same reason, or give this one a number of its own",
            ),
            Some(_) if self.sources(number)?.is_some() => refuse(
                "was issued already, and did not replace this one for this reason",
                "give the new one a number of its own: `number` under [calibration]",
            ),
            Some(stated) => self.may_be_replaced(&stated.certificate, issue),
        }
    }

    /// Says whether this certificate may be replaced by the one that is to be issued.
    fn may_be_replaced(&self, certificate: &str, issue: &Issue<'_>) -> Result<()> {
        if let Some(by) = self.replaced_by(certificate)? {
            return Err(replaced(certificate, &by));
        }
        let mut joined = issue.joined.to_vec();
        joined.sort_unstable();
        let record = issue.record;
        match self.sources(certificate)? {
            None => Err(never_issued(certificate)),
            Some(sources) if sources == (Sources { record, joined }) => Ok(()),
            Some(_) => Err(Error::input(
                format!("certificate {certificate}"),
                "is made of other records: what was measured does not change by an amendment",
                "name its records, or none: the logbook knows them. Another measurement has a certificate of \
                 its own",
            )),
        }
    }

    /// All amendments: the new certificate, and what it replaces.
    pub(super) fn amendments(&self) -> Result<Vec<(String, Amendment)>> {
        let sql = "SELECT replaces, reason, certificate FROM amendments ORDER BY certificate";
        self.all(sql, [], |row| Ok((row.get(2)?, amendment(row)?)))
    }

    /// Takes over an amendment of another logbook.
    pub(super) fn take_amendment(&self, certificate: &str, theirs: &Amendment) -> Result<()> {
        let ours = (
            self.replaces(certificate)?,
            self.replaced_by(&theirs.certificate)?,
        );
        match ours {
            (None, None) => {
                self.in_one_turn(|connection| enter_amendment(connection, certificate, theirs))
            }
            (Some(ours), _) if ours == *theirs => Ok(()),
            _ => Err(Error::input(
                format!("certificate {}", theirs.certificate),
                "is replaced otherwise in the other logbook",
                "look at both: only one of them can be in force",
            )),
        }
    }

    /// Takes over what certificates of another logbook are made of.
    pub(super) fn take_joined(&self, other: &Self) -> Result<()> {
        let sql = "SELECT certificate, role, record_sha256 FROM joined";
        let theirs = other.all(sql, [], |row| Ok((row.get(0)?, row.get(1)?, row.get(2)?)))?;
        for (certificate, role, sum) in theirs {
            let (certificate, role): (String, String) = (certificate, role);
            let record = |logbook: &Self| {
                let sources = logbook.sources(&certificate);
                sources.map(|sources| sources.map(|sources| sources.record))
            };
            // Another one of this number stays what it is.
            if record(self)? == record(other)? {
                self.in_one_turn(|connection| enter_joined(connection, &certificate, &role, &sum))?;
            }
        }
        Ok(())
    }

    fn optional<T>(
        &self,
        sql: &str,
        name: &str,
        row: impl FnOnce(&Row<'_>) -> rusqlite::Result<T>,
    ) -> Result<Option<T>> {
        let found = self.connection.query_row(sql, [name], row).optional();
        found.map_err(|error| self.failure(error))
    }
}

/// Enters what a certificate replaces and is made of, unless it is there.
pub(super) fn enter(connection: &Connection, issue: &Issue<'_>) -> rusqlite::Result<()> {
    for joined in issue.joined {
        let role = joined.role.word();
        enter_joined(connection, issue.certificate, role, &joined.record)?;
    }
    issue.replaces.map_or(Ok(()), |amended| {
        enter_amendment(connection, issue.certificate, amended)
    })
}

fn enter_joined(
    connection: &Connection,
    certificate: &str,
    role: &str,
    sum: &Sha256Sum,
) -> rusqlite::Result<()> {
    let put = "INSERT OR IGNORE INTO joined VALUES (?1, ?2, ?3)";
    if connection.execute(put, params![certificate, role, &sum[..]])? == 1 {
        let name = format!("{certificate} {role} {}", hex::encode(sum));
        journal::enter(connection, Subject::Joined, &name)?;
    }
    Ok(())
}

fn enter_amendment(
    connection: &Connection,
    certificate: &str,
    amended: &Amendment,
) -> rusqlite::Result<()> {
    let put = "INSERT INTO amendments SELECT ?1, ?2, ?3
               WHERE NOT EXISTS (SELECT 1 FROM amendments WHERE certificate = ?1)";
    let values = params![certificate, amended.certificate, amended.reason];
    if connection.execute(put, values)? == 1 {
        journal::enter(connection, Subject::Amendment, certificate)?;
    }
    Ok(())
}

fn amendment(row: &Row<'_>) -> rusqlite::Result<Amendment> {
    Ok(Amendment {
        certificate: row.get(0)?,
        reason: row.get(1)?,
    })
}

/// A number without the count of its amendments, and that count.
fn counted(certificate: &str) -> (&str, u32) {
    let count = |(stem, count): (_, &str)| Some((stem, count.parse().ok()?));
    let parts = certificate.rsplit_once("-A").and_then(count);
    parts.unwrap_or((certificate, 0))
}

fn never_issued(certificate: &str) -> Error {
    Error::input(
        format!("certificate {certificate}"),
        "was never issued from this logbook",
        "`calib logbook certificates` lists what was; one from elsewhere is named by hand: `replaces` under \
         [calibration]",
    )
}

fn replaced(certificate: &str, by: &Amendment) -> Error {
    Error::input(
        format!("certificate {certificate}"),
        format!("was replaced by {} ({})", by.certificate, by.reason),
        format!("--amend {} instead", by.certificate),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amendments_are_counted_on() {
        for (number, expected) in [
            ("K-17", ("K-17", 0)),
            ("K-17-A1", ("K-17", 1)),
            ("K-A", ("K-A", 0)),
            ("K-A7-A12", ("K-A7", 12)),
            ("K-A99999999999", ("K-A99999999999", 0)),
        ] {
            assert_eq!(counted(number), expected);
        }
    }
}
