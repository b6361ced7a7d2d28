//! The journal: what was entered, in its order, each entry chained to the one before.
//!
//! Lists, points, operators and instruments are made of the records' bytes and can be made again; sensors and
//! certificates cannot, and a record could be taken away with all that is made of it. The journal has a sum of
//! each. It has no key: who knows this file can write a journal of his own, or cut its end off. What it shows by
//! itself is damage, and the work of programs and hands that do not know it; what is signed (see seals.rs) nobody
//! writes anew.

use super::row;
use rusqlite::{Connection, OptionalExtension, params};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// Things that have entries.
#[derive(Clone, Copy, Debug)]
pub(super) enum Subject {
    Sensor,
    Record,
    Certificate,
    CheckStandard,
    Key,
    SignedFile,
    Amendment,
    Joined,
    SelfCheck,
    LaterKey,
}

impl Subject {
    const ALL: [Self; 10] = [
        Self::Sensor,
        Self::Record,
        Self::Certificate,
        Self::CheckStandard,
        Self::Key,
        Self::SignedFile,
        Self::Amendment,
        Self::Joined,
        Self::SelfCheck,
        Self::LaterKey,
    ];

    fn word(self) -> &'static str {
        match self {
            Self::Sensor => "sensor",
            Self::Record => "record",
            Self::Certificate => "certificate",
            Self::Key => "key",
            Self::SignedFile => "signed file",
            Self::CheckStandard => "check standard",
            Self::Amendment => "amendment",
            Self::Joined => "record of certificate",
            Self::SelfCheck => "check of the reference",
            Self::LaterKey => "later key",
        }
    }

    /// Its rows, after their names.
    fn rows(self) -> &'static str {
        match self {
            // In the order of the columns; a resonance that nobody stated adds nothing to what was entered before there
            // was one.
            Self::Sensor => {
                "SELECT serial, serial, manufacturer, model, sensitivity, range_ms2, iepe, mounting, owner, \
                 due_day, teds, tolerance, \
                 CASE WHEN resonance_hz IS NULL THEN unit ELSE coalesce(unit, '') || ' ' || resonance_hz END \
                 FROM sensors"
            }
            Self::Record => "SELECT CAST(id AS TEXT), sha256 FROM records",
            Self::Certificate => "SELECT CAST(number AS TEXT), * FROM certificates",
            Self::Key => "SELECT instrument, * FROM keys",
            Self::SignedFile => "SELECT lower(hex(sha256)), * FROM signed_files",
            Self::CheckStandard => "SELECT serial, * FROM check_standards",
            Self::Amendment => "SELECT certificate, * FROM amendments",
            Self::SelfCheck => "SELECT CAST(number AS TEXT), * FROM self_checks",
            Self::LaterKey => "SELECT instrument || ' ' || series, * FROM later_keys",
            Self::Joined => {
                "SELECT certificate || ' ' || role || ' ' || lower(hex(record_sha256)), * FROM joined"
            }
        }
    }

    /// The one of the name that is the statement's parameter.
    fn of_name(self) -> &'static str {
        match self {
            Self::Sensor | Self::CheckStandard => "WHERE serial = ?1",
            Self::Record => "WHERE id = CAST(?1 AS INTEGER)",
            Self::Certificate | Self::SelfCheck => "WHERE number = CAST(?1 AS INTEGER)",
            Self::Key => "WHERE instrument = ?1",
            Self::SignedFile => "WHERE sha256 = unhex(?1)",
            Self::Amendment => "WHERE certificate = ?1",
            Self::LaterKey => "WHERE instrument || ' ' || series = ?1",
            Self::Joined => {
                "WHERE certificate || ' ' || role || ' ' || lower(hex(record_sha256)) = ?1"
            }
        }
    }
}

/// Enters what is there now under this name, or that nothing is any more: the end of every change, in the
/// change's own transaction.
pub(super) fn enter(connection: &Connection, subject: Subject, name: &str) -> rusqlite::Result<()> {
    let sql = format!("{} {}", subject.rows(), subject.of_name());
    let row = connection
        .prepare_cached(&sql)?
        .query_row([name], row::bytes)
        .optional()?;
    append(connection, subject, name, row.as_deref())
}

/// Enters all there is: the first entries of a file from before there was a journal.
pub(super) fn begin(connection: &Connection) -> rusqlite::Result<()> {
    for subject in Subject::ALL {
        for (name, bytes) in row::all(connection, subject.rows())? {
            append(connection, subject, &name, Some(&bytes))?;
        }
    }
    Ok(())
}

fn append(
    connection: &Connection,
    subject: Subject,
    name: &str,
    row: Option<&[u8]>,
) -> rusqlite::Result<()> {
    let before: Option<Vec<u8>> = connection
        .prepare_cached("SELECT chain FROM journal ORDER BY number DESC LIMIT 1")?
        .query_row([], |row| row.get(0))
        .optional()?;
    let sum = row.map(|row| Sha256::digest(row).to_vec());
    let chain = link(
        &before.unwrap_or_default(),
        subject.word(),
        name,
        sum.as_deref(),
    );
    connection
        .prepare_cached("INSERT INTO journal (subject, name, sum, chain) VALUES (?1, ?2, ?3, ?4)")?
        .execute(params![subject.word(), name, sum, chain])
        .map(drop)
}

/// Sum of the chain before an entry, and of the entry.
fn link(before: &[u8], subject: &str, name: &str, sum: Option<&[u8]>) -> Vec<u8> {
    let mut chain = Sha256::new();
    for part in [
        before,
        subject.as_bytes(),
        name.as_bytes(),
        sum.unwrap_or_default(),
    ] {
        chain.update((part.len() as u64).to_le_bytes());
        chain.update(part);
    }
    chain.finalize().to_vec()
}

/// Says what is not as it was entered, in words; nothing when all is.
pub(super) fn check(connection: &Connection) -> rusqlite::Result<Vec<String>> {
    let (mut last, mut wrong) = read(connection)?;
    for subject in Subject::ALL {
        for (name, bytes) in row::all(connection, subject.rows())? {
            let entered = last.remove(&(subject.word().to_owned(), name.clone()));
            let problem = match entered {
                Some(sum) if sum[..] == Sha256::digest(&bytes)[..] => continue,
                Some(_) => "is not as it was entered",
                None => "was never entered",
            };
            wrong.push(format!("{} {name}: {problem}", subject.word()));
        }
    }
    let gone = last.into_keys();
    wrong.extend(gone.map(|(subject, name)| format!("{subject} {name}: was entered, and is gone")));
    Ok(wrong)
}

/// Sum of the last entry of each name that was not removed.
type Last = BTreeMap<(String, String), Vec<u8>>;

/// Things that are there by the journal, and places where its chain does not hold.
fn read(connection: &Connection) -> rusqlite::Result<(Last, Vec<String>)> {
    let sql = "SELECT number, subject, name, sum, chain FROM journal ORDER BY number";
    let mut statement = connection.prepare(sql)?;
    let mut rows = statement.query([])?;
    let (mut last, mut wrong) = (Last::new(), Vec::new());
    let (mut before, mut expected) = (Vec::new(), 1);
    while let Some(row) = rows.next()? {
        let (number, subject, name): (i64, String, String) =
            (row.get(0)?, row.get(1)?, row.get(2)?);
        let (sum, chain): (Option<Vec<u8>>, Vec<u8>) = (row.get(3)?, row.get(4)?);
        if number != expected || chain != link(&before, &subject, &name, sum.as_deref()) {
            wrong.push(format!(
                "journal: entry {number} does not follow from the one before"
            ));
        }
        (before, expected) = (chain, number + 1);
        match sum {
            Some(sum) => last.insert((subject, name), sum),
            None => last.remove(&(subject, name)),
        };
    }
    Ok((last, wrong))
}
