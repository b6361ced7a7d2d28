//! Keys of instruments: what a record must be signed by to be kept.
//!
//! An instrument makes one key in its life. One whose memory was erased, or whose board was changed, has another and
//! counts its records anew: a series of its own, which begins with a person's statement, for nobody else can tell
//! it from a forger's. Records of before stay with the key of before.

use super::Logbook;
use super::journal::{self, Subject};
use super::seals::line;
use calib_files::{Error, Result};
use calib_protocol::record::{self, Sha256Sum};
use calib_protocol::signature::{DeviceKey, PublicKey};
use calib_record::hash_chain::Evidence;
use calib_record::signature::{short, signer};
use rusqlite::{Connection, OptionalExtension, Row, params};

/// A key of an instrument.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InstrumentKey {
    /// The series of record numbers it signs: 0 for the first key of an instrument, and for what is not signed.
    pub series: i64,
    /// The key.
    pub key: DeviceKey,
    /// Why it is another than the one before; empty of the first.
    pub reason: String,
    /// When that was said, s since 1970-01-01 UTC; 0 of the first.
    pub stated_s: i64,
}

/// A series of record numbers of an instrument, and the key that signs it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Series {
    /// Its number.
    pub number: i64,
    /// Its key; none where the logbook has none.
    pub key: Option<DeviceKey>,
}

impl Logbook {
    /// The keys an instrument has had, the first first.
    ///
    /// # Errors
    /// Those of the file.
    pub fn keys(&self, instrument: &str) -> Result<Vec<InstrumentKey>> {
        keys_of(&self.connection, instrument).map_err(|error| self.failure(error))
    }

    /// The series of a record of `instrument` that is signed by this key, or by none. Where the key is none of the
    /// instrument's, it is judged by the last one.
    ///
    /// # Errors
    /// Those of the file.
    pub fn series(&self, instrument: &str, signed_by: Option<PublicKey>) -> Result<Series> {
        Ok(series_of(&self.keys(instrument)?, signed_by))
    }

    /// Instruments that have a key.
    pub(super) fn keyed_instruments(&self) -> Result<Vec<String>> {
        let all = "SELECT instrument FROM keys UNION SELECT instrument FROM later_keys ORDER BY 1";
        self.all(all, [], |row| row.get(0))
    }

    /// Enters the key that an instrument states; whether it is new.
    ///
    /// # Errors
    /// [`Error::Input`] when the logbook has another, or a record that this key should have signed and did not.
    pub fn enter_key(&self, instrument: &str, key: &DeviceKey) -> Result<bool> {
        let keys = self.keys(instrument)?;
        let said = match keys.last() {
            Some(last) if last.key == *key => return Ok(false),
            Some(last) => Some(format!(
                "states the key {} and not {}, which the logbook has",
                short(&key.public),
                short(&last.key.public)
            )),
            None => self.unsigned_since(instrument, key)?.map(|number| {
                let key = short(&key.public);
                format!(
                    "states the key {key}, and the logbook has record {number} that it did not sign"
                )
            }),
        };
        if let Some(said) = said {
            return Err(Error::input(
                format!("instrument {instrument}"),
                format!(
                    "{said}: it is another instrument, or its memory was erased or its board changed"
                ),
                "ask who serviced it; where that is so, `calib key --replaced REASON` says it, and records of \
                 before stay valid",
            ));
        }
        let first = InstrumentKey {
            series: 0,
            key: *key,
            reason: String::new(),
            stated_s: 0,
        };
        self.take_key(instrument, &first).map(|()| true)
    }

    /// Enters a key as it is.
    pub(super) fn take_key(&self, instrument: &str, key: &InstrumentKey) -> Result<()> {
        self.in_one_turn(|connection| put(connection, instrument, key))
    }

    /// Enters that an instrument has this key in place of the one before, or of none, and why. Returns the series it
    /// signs from now on.
    ///
    /// # Errors
    /// [`Error::Input`] when it had this key already, or there is nothing it could be in place of; [`Error::Usage`]
    /// for a reason of no line, or of several.
    pub fn replace_key(
        &self,
        instrument: &str,
        key: &DeviceKey,
        reason: &str,
        stated_s: i64,
    ) -> Result<i64> {
        let reason = line(reason)?;
        if reason.is_empty() {
            let hint = "such as \"board changed after a fault, order 4711\"; it is kept for good";
            return Err(Error::usage("nothing says why the key is another", hint));
        }
        let refused = |problem: &str| {
            let place = format!("instrument {instrument}");
            let key = short(&key.public);
            Error::input(place, format!("{problem} {key}"), "`calib key` shows it")
        };
        let keys = self.keys(instrument)?;
        if keys.iter().any(|had| had.key.public == key.public) {
            return Err(refused("has, or had, the key"));
        }
        if keys.is_empty() && self.unsigned_since(instrument, key)?.is_none() {
            return Err(refused(
                "has had no other key, and no record that speaks against",
            ));
        }
        let series = keys.last().map_or(1, |last| last.series + 1);
        let later = InstrumentKey {
            series,
            key: *key,
            reason,
            stated_s,
        };
        self.take_key(instrument, &later).map(|()| series)
    }

    /// A record of the instrument that the key should have signed, and did not.
    fn unsigned_since(&self, instrument: &str, key: &DeviceKey) -> Result<Option<u32>> {
        let kept = kept(&self.connection, instrument, key.since);
        let kept = kept.map_err(|error| self.failure(error))?;
        let mut other = kept
            .iter()
            .filter(|(_, _, bytes)| signer(bytes) != Some(key.public));
        Ok(other.next().map(|(_, number, _)| *number))
    }
}

/// Enters a key in the transaction of its caller. What it signed before anybody said so is of its series too.
fn put(connection: &Connection, instrument: &str, later: &InstrumentKey) -> rusqlite::Result<()> {
    let (series, key) = (later.series, &later.key);
    if series == 0 {
        connection.execute(
            "INSERT INTO keys VALUES (?1, ?2, ?3)",
            params![instrument, &key.public[..], key.since],
        )?;
        return journal::enter(connection, Subject::Key, instrument);
    }
    connection.execute(
        "INSERT INTO later_keys VALUES (?1, ?2, ?3, ?4, ?5, ?6)",
        params![
            instrument,
            series,
            &key.public[..],
            key.since,
            later.reason,
            later.stated_s
        ],
    )?;
    for (id, _, bytes) in kept(connection, instrument, 0)? {
        if signer(&bytes) == Some(key.public) {
            let moved = "UPDATE records SET series = ?2 WHERE id = ?1";
            connection.execute(moved, params![id, series])?;
        }
    }
    let name = format!("{instrument} {series}");
    journal::enter(connection, Subject::LaterKey, &name)
}

/// Records of an instrument from this running number on: number in the logbook, running number and bytes.
fn kept(
    connection: &Connection,
    instrument: &str,
    from: u32,
) -> rusqlite::Result<Vec<(i64, u32, Vec<u8>)>> {
    let find = "SELECT id, number, bytes FROM records JOIN contents ON record = id
                WHERE instrument = ?1 AND number >= ?2 ORDER BY number";
    let mut find = connection.prepare_cached(find)?;
    let rows = find.query_map(params![instrument, from], |row| {
        Ok((row.get(0)?, row.get(1)?, row.get(2)?))
    })?;
    rows.collect()
}

fn keys_of(connection: &Connection, instrument: &str) -> rusqlite::Result<Vec<InstrumentKey>> {
    let find = "SELECT 0, public, since, '', 0 FROM keys WHERE instrument = ?1 UNION ALL
                SELECT series, public, since, reason, stated_s FROM later_keys WHERE instrument = ?1
                ORDER BY 1";
    let key = |row: &Row<'_>| {
        Ok(InstrumentKey {
            series: row.get(0)?,
            key: DeviceKey {
                public: row.get(1)?,
                since: row.get(2)?,
            },
            reason: row.get(3)?,
            stated_s: row.get(4)?,
        })
    };
    let mut find = connection.prepare_cached(find)?;
    let rows = find.query_map([instrument], key)?;
    rows.collect()
}

fn series_of(keys: &[InstrumentKey], signed_by: Option<PublicKey>) -> Series {
    let of = |key: &InstrumentKey| Series {
        number: key.series,
        key: Some(key.key),
    };
    let found = match signed_by {
        Some(public) => {
            let own = keys.iter().find(|key| key.key.public == public);
            own.or(keys.last())
        }
        // With every later key all records are signed.
        None => keys.first().filter(|first| first.series == 0),
    };
    found.map(of).unwrap_or_default()
}

/// The series a record belongs to that is new here, or why it cannot be the instrument's, in words. Bytes that are
/// no record belong to the first.
pub(super) fn place(
    connection: &Connection,
    bytes: &[u8],
) -> rusqlite::Result<std::result::Result<i64, String>> {
    let Ok(link) = record::hash_link(bytes) else {
        return Ok(Ok(0));
    };
    let (instrument, number) = (link.instrument_serial.as_str(), link.id);
    let series = series_of(&keys_of(connection, instrument)?, signer(bytes));
    let mut evidence = Evidence::of(instrument);
    evidence.key(series.key);
    evidence.bytes(number, bytes);
    if let Some(found) = evidence.breaks_of(number).first() {
        return Ok(Err(found.to_string()));
    }
    let other =
        "SELECT id, sha256 FROM records WHERE instrument = ?1 AND series = ?2 AND number = ?3";
    let other: Option<(i64, Sha256Sum)> = connection
        .prepare_cached(other)?
        .query_row(params![instrument, series.number, number], |row| {
            Ok((row.get(0)?, row.get(1)?))
        })
        .optional()?;
    Ok(other.map_or(Ok(series.number), |(id, sum)| {
        Err(format!(
            "record {number} of {instrument} is there already, number {id} of the logbook, with the SHA-256 \
             {} .. and not {} ..: one of the two was altered",
            short(&sum),
            short(&link.sha256)
        ))
    }))
}
