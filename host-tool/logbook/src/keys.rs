//! Keys of instruments: what a record must be signed by to be kept.

use super::Logbook;
use super::journal::Subject;
use calib_files::{Error, Result};
use calib_protocol::record::{self, Sha256Sum};
use calib_protocol::signature::DeviceKey;
use calib_record::hash_chain::Evidence;
use calib_record::signature::short;
use rusqlite::{Connection, OptionalExtension, params};

impl Logbook {
    /// The key of an instrument, if one was ever entered.
    ///
    /// # Errors
    /// Those of the file.
    pub fn key(&self, instrument: &str) -> Result<Option<DeviceKey>> {
        key_of(&self.connection, instrument).map_err(|error| self.failure(error))
    }

    /// Instruments that have a key.
    pub(super) fn keyed_instruments(&self) -> Result<Vec<String>> {
        self.all(
            "SELECT instrument FROM keys ORDER BY instrument",
            [],
            |row| row.get(0),
        )
    }

    /// Enters the key that an instrument states; whether it is new. An instrument has one key in its life.
    ///
    /// # Errors
    /// [`Error::Input`] when the logbook has another.
    pub fn enter_key(&self, instrument: &str, key: &DeviceKey) -> Result<bool> {
        match self.key(instrument)? {
            Some(known) if known == *key => return Ok(false),
            Some(known) => {
                return Err(Error::input(
                    format!("instrument {instrument}"),
                    format!(
                        "states the key {} and not {}, which the logbook has: it is another instrument, \
                         or its memory was erased",
                        short(&key.public),
                        short(&known.public)
                    ),
                    "ask who serviced it; after an erase, begin another logbook for it",
                ));
            }
            None => {}
        }
        self.change(
            Subject::Key,
            instrument,
            "INSERT INTO keys VALUES (?1, ?2, ?3)",
            params![instrument, &key.public[..], key.since],
        )?;
        Ok(true)
    }
}

pub(super) fn key_of(
    connection: &Connection,
    instrument: &str,
) -> rusqlite::Result<Option<DeviceKey>> {
    let find = "SELECT public, since FROM keys WHERE instrument = ?1";
    connection
        .prepare_cached(find)?
        .query_row([instrument], |row| {
            Ok(DeviceKey {
                public: row.get(0)?,
                since: row.get(1)?,
            })
        })
        .optional()
}

/// Why a record that is new here cannot be the instrument's, in words; none when nothing speaks against it, or
/// the bytes are no record.
pub(super) fn objection(connection: &Connection, bytes: &[u8]) -> rusqlite::Result<Option<String>> {
    let Ok(link) = record::link(bytes) else {
        return Ok(None);
    };
    let (instrument, number) = (link.instrument_serial.as_str(), link.id);
    let mut evidence = Evidence::of(instrument);
    evidence.key(key_of(connection, instrument)?);
    evidence.bytes(number, bytes);
    if let Some(found) = evidence.breaks_of(number).first() {
        return Ok(Some(found.to_string()));
    }
    let other = "SELECT id, sha256 FROM records WHERE instrument = ?1 AND number = ?2";
    let other: Option<(i64, Sha256Sum)> = connection
        .prepare_cached(other)?
        .query_row(params![instrument, number], |row| {
            Ok((row.get(0)?, row.get(1)?))
        })
        .optional()?;
    Ok(other.map(|(id, sum)| {
        format!(
            "record {number} of {instrument} is there already, number {id} of the logbook, with the SHA-256 \
             {} .. and not {} ..: one of the two was altered",
            short(&sum),
            short(&link.sha256)
        )
    }))
}
