//! The chain of an instrument's records: what was removed or altered shows.
//!
//! Every record carries its running number and the SHA-256 of the record before.
//! [`Evidence`] is what is at hand of an instrument's records: their bytes, and
//! the list with their sums that the instrument gives. Whatever contradicts
//! itself is a [`Break`].
//!
//! | somebody | found by |
//! |---|---|
//! | flips a bit | the checksum of the record |
//! | alters a record and mends its checksum | its sum, in the next record or in the list |
//! | removes a record | the gap in the numbers of the list |
//! | puts another record in its place | its number, its instrument, or its sum |
//! | makes a record up, the last of all too | its signature, where the instrument has a key |
//!
//! A forgery that nothing at hand contradicts cannot be found: the last record of all,
//! altered with a right checksum, where there is neither an instrument to ask nor a key.

use crate::signature::{Signed, short, signed};
use calib_protocol::record::{self, HashLink, RecordSummary, Sha256Sum};
use calib_protocol::signature::{DeviceKey, PublicKey};
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

/// Where the hash chain does not hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Break {
    /// The instrument has records before and after these, and not these.
    Missing {
        /// First missing number.
        from: u32,
        /// Last missing number.
        through: u32,
    },
    /// The bytes are no whole record.
    Damaged {
        /// Number of the record.
        id: u32,
    },
    /// The bytes are a record of another number or instrument.
    Another {
        /// Number the record should have.
        id: u32,
    },
    /// The bytes are not those the instrument lists.
    NotAsListed {
        /// Number of the record.
        id: u32,
    },
    /// The record is not the one that the next was made after.
    Altered {
        /// Number of the record; the next says so.
        id: u32,
    },
    /// The first record of an instrument says that there was one before.
    NotFirst,
    /// The record carries a signature that does not fit.
    Forged {
        /// Number of the record.
        id: u32,
    },
    /// The record carries none, and the instrument had its key by then.
    Unsigned {
        /// Number of the record.
        id: u32,
    },
    /// The record is signed by another key than the instrument's.
    OtherKey {
        /// Number of the record.
        id: u32,
        /// The key it is signed by.
        found: PublicKey,
    },
}

impl Break {
    /// Whether record `id` cannot be trusted because of it.
    fn concerns(&self, id: u32) -> bool {
        match *self {
            // The next of them carries the sum of the last that is missing.
            Self::Missing { through, .. } => through.checked_add(1) == Some(id),
            Self::Damaged { id: of }
            | Self::Another { id: of }
            | Self::NotAsListed { id: of }
            | Self::Forged { id: of }
            | Self::Unsigned { id: of }
            | Self::OtherKey { id: of, .. } => of == id,
            Self::Altered { id: of } => of == id || of.checked_add(1) == Some(id),
            Self::NotFirst => id == 1,
        }
    }
}

impl fmt::Display for Break {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Missing { from, through } if from == through => {
                write!(formatter, "record {from} was removed")
            }
            Self::Missing { from, through } => {
                write!(formatter, "records {from} to {through} were removed")
            }
            Self::Damaged { id } => write!(formatter, "record {id} is damaged"),
            Self::Another { id } => write!(
                formatter,
                "what stands for record {id} is another record, or one of another instrument"
            ),
            Self::NotAsListed { id } => {
                write!(formatter, "record {id} is not the one the instrument lists")
            }
            Self::Altered { id } => write!(
                formatter,
                "record {id} is not the one that record {} was made after: it was altered",
                id + 1
            ),
            Self::NotFirst => formatter.write_str("record 1 says that there was one before"),
            Self::Forged { id } => write!(
                formatter,
                "the signature of record {id} does not fit: it was altered after the instrument signed it"
            ),
            Self::Unsigned { id } => write!(
                formatter,
                "record {id} is not signed, and the instrument signed all of its records by then"
            ),
            Self::OtherKey { id, found } => write!(
                formatter,
                "record {id} is signed by the key {}, which is not the instrument's",
                short(&found)
            ),
        }
    }
}

/// Standing of a record in the hash chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Standing {
    /// It is the first of its instrument.
    First,
    /// The record before is at hand, and is the one it was made after.
    Verified,
    /// The record before is not at hand.
    NotAtHand,
    /// It, or the record before, was altered, or the record before was removed.
    Broken,
}

/// Records of one instrument at hand.
#[derive(Clone, Debug, Default)]
pub struct Evidence {
    instrument_serial: String,
    links: BTreeMap<u32, HashLink>,
    listed: BTreeMap<u32, Sha256Sum>,
    signed: BTreeMap<u32, Signed>,
    key: Option<DeviceKey>,
    unusable: Vec<Break>,
}

impl Evidence {
    /// Nothing yet of the instrument with this serial number.
    pub fn of(instrument_serial: &str) -> Self {
        Self {
            instrument_serial: instrument_serial.to_owned(),
            ..Self::default()
        }
    }

    /// Takes note of the instrument's key, if one is known.
    pub fn key(&mut self, key: Option<DeviceKey>) {
        self.key = key;
    }

    /// Takes note of all that the instrument lists.
    pub fn list(&mut self, records: &[RecordSummary]) {
        let lines = records.iter().map(|line| (line.id, line.sha256));
        self.listed.extend(lines);
    }

    /// Takes note of the bytes that stand for record `id`.
    pub fn bytes(&mut self, id: u32, bytes: &[u8]) {
        match record::hash_link(bytes) {
            Ok(link) if link.id == id && link.instrument_serial == *self.instrument_serial => {
                self.links.insert(id, link);
                // Of what is a record, a signature can be read, or is none.
                let signed = signed(bytes).unwrap_or(Signed::Falsely);
                self.signed.insert(id, signed);
            }
            Ok(_) => self.unusable.push(Break::Another { id }),
            Err(_) => self.unusable.push(Break::Damaged { id }),
        }
    }

    /// Takes note of the neighbours of record `id` that were downloaded into
    /// `folder`; files of another instrument are nobody's neighbours.
    pub fn neighbours(&mut self, id: u32, folder: &Path) {
        for id in [id.checked_sub(1), id.checked_add(1)].into_iter().flatten() {
            if self.links.contains_key(&id) {
                continue;
            }
            let Ok(bytes) = std::fs::read(folder.join(file_name(id))) else {
                continue;
            };
            let foreign = |link: HashLink| link.instrument_serial != *self.instrument_serial;
            if !record::hash_link(&bytes).is_ok_and(foreign) {
                self.bytes(id, &bytes);
            }
        }
    }

    /// The sum of record `id`.
    fn sum(&self, id: u32) -> Option<Sha256Sum> {
        let of_bytes = self.links.get(&id).map(|link| link.sha256);
        of_bytes.or_else(|| self.listed.get(&id).copied())
    }

    /// Break by the signature of a record, if any.
    fn misgiving(&self, id: u32, signed: Signed) -> Option<Break> {
        match (signed, self.key) {
            (Signed::Falsely, _) => Some(Break::Forged { id }),
            (Signed::No, Some(key)) if id >= key.since => Some(Break::Unsigned { id }),
            (Signed::By(found), Some(key)) if found != key.public => {
                Some(Break::OtherKey { id, found })
            }
            _ => None,
        }
    }

    /// Places that concern record `id`.
    pub fn breaks_of(&self, id: u32) -> Vec<Break> {
        let mut breaks = self.breaks();
        breaks.retain(|found| found.concerns(id));
        breaks
    }

    /// Every place where the hash chain does not hold.
    pub fn breaks(&self) -> Vec<Break> {
        let numbers: Vec<u32> = self.listed.keys().copied().collect();
        let gaps = numbers.windows(2).filter(|pair| pair[1] - pair[0] > 1);
        let missing = gaps.map(|pair| Break::Missing {
            from: pair[0] + 1,
            through: pair[1] - 1,
        });
        let mut breaks: Vec<Break> = missing.chain(self.unusable.iter().cloned()).collect();
        let signed = self.signed.iter();
        breaks.extend(signed.filter_map(|(&id, &signed)| self.misgiving(id, signed)));
        for (&id, link) in &self.links {
            let listed = self.listed.get(&id);
            if listed.is_some_and(|sum| *sum != link.sha256) {
                breaks.push(Break::NotAsListed { id });
            }
            match id.checked_sub(1) {
                Some(0) if link.previous_sha256 != [0; 32] => breaks.push(Break::NotFirst),
                Some(before)
                    if self
                        .sum(before)
                        .is_some_and(|sum| sum != link.previous_sha256) =>
                {
                    breaks.push(Break::Altered { id: before });
                }
                _ => {}
            }
        }
        breaks
    }

    /// Standing of record `id`.
    pub fn standing(&self, id: u32) -> Standing {
        let before = id.saturating_sub(1);
        if !self.breaks_of(id).is_empty() {
            Standing::Broken
        } else if id == 1 {
            Standing::First
        } else if self.sum(before).is_some() {
            Standing::Verified
        } else {
            Standing::NotAtHand
        }
    }
}

/// Name of the file a record is downloaded into.
pub fn file_name(id: u32) -> PathBuf {
    PathBuf::from(format!("record-{id:05}.calibrec"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{self, mend};
    use calib_protocol::record::{RecordKind, digest};

    const SERIAL: &str = "CAL-0042";

    /// Four records in a hash chain, one of them the log of a change.
    fn records() -> Vec<Vec<u8>> {
        let mut record = sample::record(&[160.0]);
        let mut chain: Vec<Vec<u8>> = Vec::new();
        for id in 1..=4 {
            record.head.id = id;
            record.head.previous_sha256 = chain.last().map_or([0; 32], |bytes| digest(bytes));
            let mut bytes = vec![0; 8192];
            let length = match id {
                3 => calib_protocol::change::encode(
                    &record.head,
                    &record.settings,
                    &record.settings,
                    &record.provenance,
                    &mut bytes,
                ),
                _ => record::encode(&record, &mut bytes),
            };
            bytes.truncate(length.expect("fits"));
            chain.push(bytes);
        }
        chain
    }

    fn list(records: &[Vec<u8>]) -> Vec<RecordSummary> {
        let line = |bytes: &Vec<u8>| record::inspect(bytes).expect("a record").0;
        records.iter().map(line).collect()
    }

    fn evidence(records: &[Vec<u8>]) -> Evidence {
        let mut evidence = Evidence::of(SERIAL);
        for (id, bytes) in (1..).zip(records) {
            evidence.bytes(id, bytes);
        }
        evidence
    }

    #[test]
    fn an_untouched_chain_holds() {
        let records = records();
        let mut evidence = evidence(&records);
        assert_eq!(evidence.breaks(), []);
        assert_eq!(evidence.standing(1), Standing::First);
        assert_eq!(evidence.standing(4), Standing::Verified);
        evidence.list(&list(&records));
        assert_eq!(evidence.breaks(), []);
        // Alone, nothing is known; with the list it is.
        let mut alone = Evidence::of(SERIAL);
        alone.bytes(3, &records[2]);
        assert_eq!(alone.standing(3), Standing::NotAtHand);
        alone.list(&list(&records));
        assert_eq!(alone.standing(3), Standing::Verified);
        assert_eq!(list(&records)[2].kind, RecordKind::ReferenceChange);
    }

    /// A flip the checksum tells, and one whose checksum was mended: everywhere, but for the last
    /// record, found without the instrument; and everywhere with its list.
    #[test]
    fn every_flipped_bit_of_every_record_is_found() {
        let records = records();
        let listed = list(&records);
        let whole = evidence(&records);
        for (index, bytes) in records.iter().enumerate() {
            let id = index as u32 + 1;
            for bit in 0..(bytes.len() - 4) * 8 {
                let mut flipped = bytes.clone();
                flipped[bit / 8] ^= 1 << (bit % 8);
                assert!(
                    record::hash_link(&flipped).is_err(),
                    "record {id}, bit {bit}"
                );
                mend(&mut flipped);
                let mut evidence = whole.clone();
                evidence.links.remove(&id);
                evidence.bytes(id, &flipped);
                let last = index + 1 == records.len();
                let found = !evidence.breaks().is_empty();
                assert!(found || last, "record {id}, bit {bit}");
                evidence.list(&listed);
                assert!(!evidence.breaks().is_empty(), "record {id}, bit {bit}");
            }
        }
    }

    #[test]
    fn a_removed_record_is_named_by_its_number() {
        let records = records();
        for removed in [2, 3] {
            let mut lines = list(&records);
            lines.retain(|line| line.id != removed);
            let mut evidence = Evidence::of(SERIAL);
            evidence.list(&lines);
            let (from, through) = (removed, removed);
            assert_eq!(evidence.breaks(), [Break::Missing { from, through }]);
            assert_eq!(evidence.standing(removed + 1), Standing::Broken);
        }
        // What made room at the beginning was released, and is no gap.
        let mut evidence = Evidence::of(SERIAL);
        evidence.list(&list(&records)[2..]);
        assert_eq!(evidence.breaks(), []);
    }

    #[test]
    fn an_altered_record_is_named_and_its_neighbours_are_not_blamed_for_more() {
        let mut records = records();
        // A digit of the firmware's version.
        let mut places = records[1].windows(5);
        let at = places.position(|bytes| bytes == b"0.1.0");
        records[1][at.expect("its version")] ^= 1;
        mend(&mut records[1]);
        let evidence = evidence(&records);
        assert_eq!(evidence.breaks(), [Break::Altered { id: 2 }]);
        let standing = [1, 2, 3, 4].map(|id| evidence.standing(id));
        let (first, broken, verified) = (Standing::First, Standing::Broken, Standing::Verified);
        assert_eq!(standing, [first, broken, broken, verified]);
    }

    /// The last record of all, its result altered and its checksum mended: without a key nothing says so.
    #[test]
    fn with_a_key_the_last_record_of_all_cannot_be_made_up() {
        let record = sample::record(&[160.0]);
        let id = record.head.id;
        let bytes = sample::signed(&record, &[5; 32]);
        let Ok(Signed::By(public)) = signed(&bytes) else {
            panic!("it was signed");
        };
        let since = id - 2;
        let breaks = |bytes: &[u8], key| {
            let mut evidence = Evidence::of(SERIAL);
            evidence.key(key);
            evidence.bytes(id, bytes);
            evidence.breaks()
        };
        let key = Some(DeviceKey { public, since });
        assert_eq!(breaks(&bytes, key), []);
        assert_eq!(breaks(&bytes, None), []);
        let mut altered = bytes.clone();
        let mut places = altered.windows(5);
        let at = places.position(|bytes| bytes == b"0.1.0");
        altered[at.expect("its version")] ^= 1;
        mend(&mut altered);
        assert_eq!(breaks(&altered, None), [Break::Forged { id }]);
        // Without its signature, or with that of another key.
        let bare = sample::bytes(&record);
        assert_eq!(breaks(&bare, None), []);
        assert_eq!(breaks(&bare, key), [Break::Unsigned { id }]);
        let later = Some(DeviceKey {
            public,
            since: id + 1,
        });
        assert_eq!(breaks(&bare, later), []);
        let other = sample::signed(&record, &[6; 32]);
        let found = breaks(&other, key);
        assert!(matches!(found[..], [Break::OtherKey { .. }]), "{found:?}");
    }

    #[test]
    fn neighbours_are_found_beside_a_file_and_those_of_others_ignored() {
        let folder = tempfile::tempdir().expect("a folder");
        let records = records();
        let keep = |id: u32, bytes: &[u8]| {
            std::fs::write(folder.path().join(file_name(id)), bytes).expect("writes");
        };
        let standing = || {
            let mut evidence = Evidence::of(SERIAL);
            evidence.bytes(2, &records[1]);
            evidence.neighbours(2, folder.path());
            evidence.standing(2)
        };
        assert_eq!(standing(), Standing::NotAtHand);
        keep(1, &records[0]);
        assert_eq!(standing(), Standing::Verified);
        let mut other = sample::record(&[80.0]);
        other.head.instrument_serial = sample::text("CAL-0043");
        let mut bytes = vec![0; 8192];
        let length = record::encode(&other, &mut bytes).expect("fits");
        keep(1, &bytes[..length]);
        assert_eq!(standing(), Standing::NotAtHand);
    }
}
