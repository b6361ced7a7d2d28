//! The laboratory's signatures on the journal.
//!
//! Who knows this program can write a journal of his own; what he cannot write is a signature. Each is over the
//! chain up to an entry, so over all that was entered until then, and over the signature before it.

use super::Logbook;
use calib_files::{Error, Result};
use calib_protocol::text::is_plain;
use calib_signing::{Certificate, LaboratoryKey, Signature, sign_text, verify_text};
use jiff::Timestamp;
use rusqlite::{Connection, OptionalExtension, Row, params};
use schemars::JsonSchema;
use serde::Serialize;
use sha2::{Digest, Sha256};

/// A signature on the journal.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Seal {
    /// Number of the signature.
    pub seal: i64,
    /// Last entry of the journal it is over.
    pub journal_entry: i64,
    /// When it was made, as its maker says, s since 1970-01-01 UTC.
    #[serde(rename = "signed_unix_time_s")]
    pub signed_s: i64,
    /// Why its key is another than that of the one before; empty when it is the same.
    pub statement: String,
    /// Subject of the key's certificate.
    pub signed_by: String,
    /// SHA-256 of that certificate.
    pub signer_certificate_sha256: String,
}

/// A row of the table.
struct Kept {
    number: i64,
    entry: i64,
    signed_s: i64,
    statement: String,
    signature: Vec<u8>,
}

const ALL: &str = "SELECT number, entry, signed_s, statement, signature FROM seals ORDER BY number";

impl Kept {
    fn from_row(row: &Row<'_>) -> rusqlite::Result<Self> {
        Ok(Self {
            number: row.get(0)?,
            entry: row.get(1)?,
            signed_s: row.get(2)?,
            statement: row.get(3)?,
            signature: row.get(4)?,
        })
    }

    /// Text that is signed.
    fn text(&self, chain: &[u8], before: Option<&[u8]>) -> String {
        let before = before.map(|signature| hex::encode(Sha256::digest(signature)));
        format!(
            "calib journal\nseal {}\nentry {}\nchain {}\nbefore {}\ntime {}\nstatement {}\n",
            self.number,
            self.entry,
            hex::encode(chain),
            before.unwrap_or_default(),
            self.signed_s,
            self.statement
        )
    }

    fn seal(&self, by: &Certificate) -> Seal {
        Seal {
            seal: self.number,
            journal_entry: self.entry,
            signed_s: self.signed_s,
            statement: self.statement.clone(),
            signed_by: by.subject(),
            signer_certificate_sha256: hex::encode(by.fingerprint()),
        }
    }
}

impl Logbook {
    /// Signs the journal as it is now. `statement` says why the key is another than before.
    ///
    /// # Errors
    /// [`Error::Input`] when the last signature is of another key and no statement says why, when something in
    /// the logbook is not as it was entered, and when there is nothing to sign.
    pub fn seal(&self, key: &LaboratoryKey, at: Timestamp, statement: &str) -> Result<Seal> {
        let place = || self.path.display().to_string();
        if let Some(problem) = self.inspect()?.first() {
            let hint = "`calib logbook check` names all of it; what is damaged is not signed";
            return Err(Error::input(place(), problem.as_str(), hint));
        }
        let statement = line(statement)?;
        let own = key.certificate();
        let last = self.seals()?.pop();
        let sum = hex::encode(own.fingerprint());
        let is_other = |last: &Seal| last.signer_certificate_sha256 != sum;
        match &last {
            Some(last) if is_other(last) && statement.is_empty() => {
                return Err(Error::input(
                    place(),
                    format!(
                        "is signed by {} until now, and this key is another",
                        last.signed_by
                    ),
                    "say why with --new-key TEXT; old signatures stay valid",
                ));
            }
            _ => {}
        }
        let make = || {
            self.put_seal(key, at, statement)
                .map(|kept| kept.map(|kept| kept.seal(own)))
        };
        make()
            .map_err(|error| self.failure(error))?
            .map_err(|problem| Error::input(place(), problem, "enter something first, then sign"))
    }

    fn put_seal(
        &self,
        key: &LaboratoryKey,
        at: Timestamp,
        statement: String,
    ) -> rusqlite::Result<std::result::Result<Kept, String>> {
        let transaction = self.writing()?;
        let last = "SELECT number, chain FROM journal ORDER BY number DESC LIMIT 1";
        let last = transaction.query_row(last, [], |row| Ok((row.get(0)?, row.get(1)?)));
        let Some((entry, chain)): Option<(i64, Vec<u8>)> = last.optional()? else {
            return Ok(Err("has an empty journal".to_owned()));
        };
        let before = "SELECT number, signature FROM seals ORDER BY number DESC LIMIT 1";
        let before = transaction.query_row(before, [], |row| Ok((row.get(0)?, row.get(1)?)));
        let before: Option<(i64, Vec<u8>)> = before.optional()?;
        let mut kept = Kept {
            number: before.as_ref().map_or(1, |(number, _)| number + 1),
            entry,
            signed_s: at.as_second(),
            statement,
            signature: Vec::new(),
        };
        let text = kept.text(&chain, before.as_ref().map(|(_, signature)| &signature[..]));
        kept.signature = match sign_text(key, &text) {
            Ok(signature) => signature,
            Err(problem) => return Ok(Err(problem.to_string())),
        };
        transaction.execute(
            "INSERT INTO seals VALUES (?1, ?2, ?3, ?4, ?5)",
            params![
                kept.number,
                kept.entry,
                kept.signed_s,
                kept.statement,
                kept.signature
            ],
        )?;
        transaction.commit()?;
        Ok(Ok(kept))
    }

    /// The signatures that hold, in their order.
    ///
    /// # Errors
    /// Those of the file.
    pub fn seals(&self) -> Result<Vec<Seal>> {
        let found = verified(&self.connection).map_err(|error| self.failure(error))?;
        let held = found.into_iter().filter_map(|(kept, signature)| {
            signature.ok().map(|signature| kept.seal(&signature.by))
        });
        Ok(held.collect())
    }

    /// Signatures that do not hold, or are none of `known`, in words; where nobody is known, only the
    /// former.
    ///
    /// # Errors
    /// Those of the file.
    pub fn inspect_seals(&self, known: &[Certificate]) -> Result<Vec<String>> {
        let found = verified(&self.connection).map_err(|error| self.failure(error))?;
        let mut wrong = Vec::new();
        if found.is_empty() && !known.is_empty() {
            wrong.push("journal: nothing in it is signed".to_owned());
        }
        let (mut by, mut expected) = (None, 1);
        for (kept, signature) in found {
            let name = format!("journal: signature {}", kept.number);
            if kept.number != expected {
                wrong.push(format!("{name}: one before it is gone"));
            }
            expected = kept.number + 1;
            match signature {
                Err(problem) => wrong.push(format!("{name}: {problem}")),
                Ok(signature) => {
                    wrong.extend(
                        doubt(&kept, &signature, by.as_ref(), known)
                            .map(|d| format!("{name}: {d}")),
                    );
                    by = Some(signature.by);
                }
            }
        }
        Ok(wrong)
    }

    /// Entries of the journal, and how many of them the last signature is over.
    ///
    /// # Errors
    /// Those of the file.
    pub fn signed_entries(&self) -> Result<(i64, i64)> {
        let all = self.one("SELECT coalesce(max(number), 0) FROM journal", [])?;
        let signed = self.seals()?.last().map_or(0, |seal| seal.journal_entry);
        Ok((all, signed))
    }
}

/// Doubt about a signature that holds.
fn doubt(
    kept: &Kept,
    signature: &Signature,
    before: Option<&Certificate>,
    known: &[Certificate],
) -> Option<String> {
    let by = signature.by.subject();
    let at = Timestamp::from_second(kept.signed_s).unwrap_or(Timestamp::MAX);
    if !signature.by.is_in_force(at) {
        return Some(format!(
            "the certificate of {by} was not in force when it says it signed"
        ));
    }
    if before.is_some_and(|before| before != &signature.by) && kept.statement.is_empty() {
        return Some(format!("is by another key, {by}, and nothing says why"));
    }
    (!known.is_empty() && !signature.is_of(known, at))
        .then(|| format!("is by {by}, whom nobody here knows"))
}

type Checked = (Kept, std::result::Result<Signature, String>);

/// Every signature with what it proves of the journal as it is.
fn verified(connection: &Connection) -> rusqlite::Result<Vec<Checked>> {
    let mut statement = connection.prepare(ALL)?;
    let kept: Vec<Kept> = statement
        .query_map([], Kept::from_row)?
        .collect::<rusqlite::Result<_>>()?;
    let mut before: Option<Vec<u8>> = None;
    let mut found = Vec::new();
    for one in kept {
        let chain = connection
            .prepare_cached("SELECT chain FROM journal WHERE number = ?1")?
            .query_row([one.entry], |row| row.get::<_, Vec<u8>>(0))
            .optional()?;
        let signature = match chain {
            None => Err(format!("the journal ends before its entry {}", one.entry)),
            Some(chain) => {
                let text = one.text(&chain, before.as_deref());
                verify_text(&one.signature, &text).map_err(|problem| problem.to_string())
            }
        };
        before = Some(one.signature.clone());
        found.push((one, signature));
    }
    Ok(found)
}

/// A statement of one line.
pub(super) fn line(statement: &str) -> Result<String> {
    match is_plain(statement) {
        true => Ok(statement.trim().to_owned()),
        false => Err(Error::usage(
            "a statement is one line, without control characters",
            "say it in one",
        )),
    }
}
