//! Records: what a calibration leaves behind, as hosts get and keep it.
//!
//! In flash it takes less room: see [`crate::stored`].
//!
//! | bytes | content |
//! |---|---|
//! | 2 | record version, u16 LE: [`RECORD_VERSION`], with the kind in the upper byte |
//! | n | [`Record`], postcard; of another kind: [`crate::change`] |
//! | 4 | CRC-32 of everything before, LE |

use crate::frame::CRC;
pub use crate::head::{RecordHead, RunLabels, Sha256Sum};
use crate::stored_point;
use calib_core::point::PointResult;
use calib_core::settings::{ReferenceChannel, Settings};
use calib_core::verdict::Verdict;
use core::ops::Range;
use heapless::{String, Vec};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// Version of this form.
pub const RECORD_VERSION: u16 = 1;
/// Most points of one run.
pub const MAX_POINTS: usize = 200;

/// What a record is about.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RecordKind {
    /// A run that was measured: a [`Record`].
    #[default]
    Calibration,
    /// Another calibration of the reference: a [`crate::change::ReferenceChange`].
    ReferenceChange,
}

impl RecordKind {
    /// The first two bytes of a record of this kind.
    const fn mark(self) -> u16 {
        match self {
            Self::Calibration => RECORD_VERSION,
            Self::ReferenceChange => 0x0100 | RECORD_VERSION,
        }
    }
}

/// One calibration, as stored.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Number, place in the chain, instrument and labels.
    pub head: RecordHead,
    /// Settings and reference calibration the run was made with.
    pub settings: Settings,
    /// What made the instrument restart since the record before, if that was a
    /// panic or a fault.
    pub incident: Option<String<160>>,
    /// True when every point of the list was attempted.
    pub complete: bool,
    /// Results in the order measured.
    #[serde(with = "crate::stored_point")]
    pub points: Vec<PointResult, MAX_POINTS>,
}

impl Record {
    /// A record of nothing, for memory that waits for one.
    pub const BLANK: Self = Self {
        head: RecordHead::BLANK,
        settings: Settings::BLANK,
        incident: None,
        complete: false,
        points: Vec::new(),
    };
}

/// One line of the record list.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordSummary {
    /// Running number.
    pub id: u32,
    /// Stored bytes.
    pub bytes: u32,
    /// Seconds since 1970-01-01 UTC; 0 = not known.
    pub unix_time_s: u64,
    /// Serial number of the device under test.
    pub dut_serial: String<48>,
    /// Points in the record.
    pub points: u16,
    /// Points refused.
    pub refused: u16,
    /// [`digest`] of the record.
    pub sha256: Sha256Sum,
    /// What it is about.
    pub kind: RecordKind,
}

/// Where a record stands in the chain of its instrument.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChainLink {
    /// What the record is about.
    pub kind: RecordKind,
    /// Running number.
    pub id: u32,
    /// Serial number of the instrument.
    pub instrument_serial: String<32>,
    /// What it says of the record before: its [`digest`].
    pub previous_sha256: Sha256Sum,
    /// Its own [`digest`].
    pub sha256: Sha256Sum,
}

/// SHA-256 of the bytes of a record, as [`encode`] writes them.
///
/// Each record carries that of the one before: a record that was removed or
/// altered breaks the chain at the next.
pub fn digest(record: &[u8]) -> Sha256Sum {
    Sha256::digest(record).into()
}

/// Why stored bytes are not a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RecordError {
    /// Too short to be a record, or the buffer is too small to write one.
    Length,
    /// Written by another version of the firmware.
    Version {
        /// Record version found; this code reads [`RECORD_VERSION`].
        found: u16,
    },
    /// The checksum differs: bytes were damaged or are missing.
    Checksum,
    /// The checksum holds, and yet the content is no record of this version.
    Content,
    /// A record of another kind than the one wanted.
    Kind {
        /// The kind it is.
        found: RecordKind,
    },
}

impl core::fmt::Display for RecordError {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Length => formatter.write_str("wrong length for a record"),
            Self::Version { found } => write!(
                formatter,
                "record version {found}, only {RECORD_VERSION} is known here"
            ),
            Self::Checksum => formatter.write_str("checksum of the record failed"),
            Self::Content => formatter.write_str("content is no record"),
            Self::Kind {
                found: RecordKind::ReferenceChange,
            } => formatter.write_str("logs a change of the reference and is no calibration"),
            Self::Kind {
                found: RecordKind::Calibration,
            } => formatter.write_str("is a calibration and logs no change of the reference"),
        }
    }
}

impl core::error::Error for RecordError {}

/// Writes a record and returns its length in bytes.
///
/// # Errors
/// [`RecordError::Length`] when the buffer is too small.
pub fn encode(record: &Record, buffer: &mut [u8]) -> Result<usize, RecordError> {
    seal(RecordKind::Calibration, record, buffer)
}

/// Writes content between kind and checksum.
pub(crate) fn seal(
    kind: RecordKind,
    content: &impl Serialize,
    buffer: &mut [u8],
) -> Result<usize, RecordError> {
    let (version, rest) = buffer
        .split_first_chunk_mut::<2>()
        .ok_or(RecordError::Length)?;
    *version = kind.mark().to_le_bytes();
    let body = postcard::to_slice(content, rest).map_err(|_| RecordError::Length)?;
    let end = 2 + body.len();
    let checksum = CRC.checksum(buffer.get(..end).ok_or(RecordError::Length)?);
    buffer
        .get_mut(end..end + 4)
        .ok_or(RecordError::Length)?
        .copy_from_slice(&checksum.to_le_bytes());
    Ok(end + 4)
}

/// Checks length, checksum and version, in this order, and returns kind and
/// content.
///
/// # Errors
/// See [`RecordError`]; `Checksum` before `Version`, because a damaged version
/// number is damage and no version.
pub fn check(bytes: &[u8]) -> Result<(RecordKind, &[u8]), RecordError> {
    let (content, checksum) = bytes.split_last_chunk::<4>().ok_or(RecordError::Length)?;
    let (version, body) = content
        .split_first_chunk::<2>()
        .ok_or(RecordError::Length)?;
    if CRC.checksum(content) != u32::from_le_bytes(*checksum) {
        return Err(RecordError::Checksum);
    }
    let found = u16::from_le_bytes(*version);
    let kind = kind_of(found).ok_or(RecordError::Version { found })?;
    Ok((kind, body))
}

/// Kind of the records that begin with `mark`.
pub(crate) fn kind_of(mark: u16) -> Option<RecordKind> {
    let mut kinds = [RecordKind::Calibration, RecordKind::ReferenceChange].into_iter();
    kinds.find(|kind| kind.mark() == mark)
}

/// Content of a record of this kind.
pub(crate) fn content_of(kind: RecordKind, bytes: &[u8]) -> Result<&[u8], RecordError> {
    match check(bytes)? {
        (found, body) if found == kind => Ok(body),
        (found, _) => Err(RecordError::Kind { found }),
    }
}

/// Where a record of any kind stands in the chain.
///
/// # Errors
/// As [`decode`], for any kind.
pub fn link(bytes: &[u8]) -> Result<ChainLink, RecordError> {
    let (kind, body) = check(bytes)?;
    let (head, _) = head_of(body).map_err(|_| RecordError::Content)?;
    Ok(ChainLink {
        kind,
        id: head.id,
        instrument_serial: head.instrument_serial,
        previous_sha256: head.previous_sha256,
        sha256: digest(bytes),
    })
}

/// The head of a record's content, and what follows it.
pub(crate) fn head_of(content: &[u8]) -> postcard::Result<(RecordHead, &[u8])> {
    postcard::take_from_bytes(content)
}

/// Fields between its settings and its points; the number of points.
type Middle = (Option<String<160>>, bool, u16);

/// Where the settings lie in the bytes of a record, and what the record list
/// says of it. Read point by point: that takes little memory, where [`decode`]
/// takes room for the longest record.
///
/// # Errors
/// As [`decode`].
pub fn inspect(bytes: &[u8]) -> Result<(RecordSummary, Range<usize>), RecordError> {
    let content = |_| RecordError::Content;
    let (kind, body) = check(bytes)?;
    let (head, rest) = head_of(body).map_err(content)?;
    let start = bytes.len() - 4 - rest.len();
    let (_, rest) = postcard::take_from_bytes::<Settings>(rest).map_err(content)?;
    let settings = start..bytes.len() - 4 - rest.len();
    let (points, refused) = match kind {
        RecordKind::Calibration => count_points(rest)?,
        RecordKind::ReferenceChange => channel_alone(rest).map(|()| (0, 0))?,
    };
    let summary = RecordSummary {
        id: head.id,
        bytes: bytes.len() as u32,
        unix_time_s: head.labels.unix_time_s,
        dut_serial: head.labels.dut_serial,
        points,
        refused,
        sha256: digest(bytes),
        kind,
    };
    Ok((summary, settings))
}

/// Whether what follows the settings is a channel and nothing more.
fn channel_alone(bytes: &[u8]) -> Result<(), RecordError> {
    match postcard::take_from_bytes::<ReferenceChannel>(bytes) {
        Ok((_, [])) => Ok(()),
        _ => Err(RecordError::Content),
    }
}

/// Points and refused points of what follows the settings.
fn count_points(bytes: &[u8]) -> Result<(u16, u16), RecordError> {
    let content = |_| RecordError::Content;
    let (middle, mut rest) = postcard::take_from_bytes::<Middle>(bytes).map_err(content)?;
    let (_, _, points) = middle;
    let mut refused = 0;
    for _ in 0..points {
        let (point, after) = stored_point::take(rest).map_err(content)?;
        refused += u16::from(point.verdict != Verdict::Pass);
        rest = after;
    }
    if !rest.is_empty() || usize::from(points) > MAX_POINTS {
        return Err(RecordError::Content);
    }
    Ok((points, refused))
}

/// Reads the record of a calibration.
///
/// # Errors
/// Those of [`check`], [`RecordError::Content`] and [`RecordError::Kind`].
pub fn decode(bytes: &[u8]) -> Result<Record, RecordError> {
    let body = content_of(RecordKind::Calibration, bytes)?;
    match postcard::take_from_bytes(body) {
        Ok((record, [])) => Ok(record),
        _ => Err(RecordError::Content),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_core::point::PointSpec;
    use calib_core::verdict::Reason;

    fn record() -> Record {
        let head = RecordHead {
            id: 7,
            previous_sha256: [3; 32],
            instrument_serial: "A1".try_into().expect("short"),
            firmware: "0.1.0".try_into().expect("short"),
            sample_rate_hz: 50_000.0,
            ..RecordHead::BLANK
        };
        let complete = true;
        Record {
            head,
            complete,
            ..Record::BLANK
        }
    }

    fn stored() -> std::vec::Vec<u8> {
        let mut bytes = vec![0; 1024];
        let length = encode(&record(), &mut bytes).expect("fits");
        bytes.truncate(length);
        bytes
    }

    #[test]
    fn a_default_run_stays_small() {
        // 31 points with a full table of the reference: 50 bytes a point, 20 a
        // row of the table, and the texts.
        let mut record = record();
        record.settings = Settings::field_calibrator();
        let spec = PointSpec {
            frequency_hz: 31.5,
            acceleration_rms_ms2: 10.0,
        };
        let mut point = PointResult::refused(spec, None, Reason::DriveLimit);
        point.sensitivity_v_per_ms2 = 0.009_8;
        let points = core::iter::repeat_n(point, 31);
        record.points = points.collect();
        let mut bytes = vec![0; 8192];
        let length = encode(&record, &mut bytes).expect("fits");
        assert!(length < 2_700, "{length}");
        let read = decode(&bytes[..length]).expect("whole");
        assert_eq!(read.settings, record.settings);
        assert_eq!(read.points, record.points);
    }

    #[test]
    fn decoding_inverts_encoding() {
        assert_eq!(decode(&stored()), Ok(record()));
    }

    #[test]
    fn the_summary_is_that_of_the_whole_record() {
        let mut record = record();
        record.head.labels.dut_serial = "D 9".try_into().expect("short");
        record.head.labels.unix_time_s = 1_800_000_000;
        for reason in [None, Some(Reason::Clipped), None] {
            let spec = PointSpec {
                frequency_hz: 160.0,
                acceleration_rms_ms2: 10.0,
            };
            let mut point = PointResult::refused(spec, None, reason.unwrap_or(Reason::Stopped));
            if reason.is_none() {
                point.verdict = Verdict::Pass;
            }
            record.points.push(point).expect("room");
        }
        let mut bytes = vec![0; 2048];
        let length = encode(&record, &mut bytes).expect("fits");
        let summary = RecordSummary {
            id: 7,
            bytes: length as u32,
            unix_time_s: 1_800_000_000,
            dut_serial: record.head.labels.dut_serial.clone(),
            points: 3,
            refused: 1,
            sha256: digest(&bytes[..length]),
            kind: RecordKind::Calibration,
        };
        let (found, settings) = inspect(&bytes[..length]).expect("a record");
        assert_eq!(found, summary);
        let settings = postcard::from_bytes(&bytes[settings]);
        assert_eq!(settings, Ok(record.settings));
        assert_eq!(inspect(&bytes[..length - 1]), Err(RecordError::Checksum));
    }

    #[test]
    fn every_flipped_bit_is_noticed() {
        let whole = stored();
        for bit in 0..whole.len() * 8 {
            let mut bytes = whole.clone();
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(decode(&bytes), Err(RecordError::Checksum), "bit {bit}");
        }
    }

    #[test]
    fn every_shortened_record_is_refused() {
        let whole = stored();
        for length in 0..whole.len() {
            assert!(decode(&whole[..length]).is_err(), "{length}");
        }
    }

    #[test]
    fn a_newer_version_is_named() {
        let mut bytes = stored();
        bytes[0] = 9;
        let end = bytes.len() - 4;
        let checksum = CRC.checksum(&bytes[..end]).to_le_bytes();
        bytes[end..].copy_from_slice(&checksum);
        assert_eq!(decode(&bytes), Err(RecordError::Version { found: 9 }));
    }

    #[test]
    fn a_buffer_of_any_short_length_is_refused() {
        for room in 0..stored().len() {
            let mut buffer = vec![0; room];
            assert_eq!(
                encode(&record(), &mut buffer),
                Err(RecordError::Length),
                "{room}"
            );
        }
    }
}
