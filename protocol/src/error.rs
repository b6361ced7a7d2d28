//! Why stored bytes are not a record.

use crate::kind::{RECORD_VERSION, RecordKind};

/// Why stored bytes are not a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RecordError {
    /// Too short to be a record, or the buffer is too small to write one.
    Length,
    /// Of a version this code does not know: up to [`RECORD_VERSION`] it does.
    Version {
        /// Version found.
        found: u16,
    },
    /// A section that is needed is of a version this code does not know.
    Section {
        /// Its id.
        id: u8,
        /// Its version.
        version: u8,
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

impl RecordError {
    /// Whether a newer release reads the record.
    pub fn is_of_newer_release(self) -> bool {
        match self {
            Self::Version { found } => found > RECORD_VERSION,
            other => matches!(other, Self::Section { .. }),
        }
    }
}

impl core::fmt::Display for RecordError {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Length => formatter.write_str("wrong length for a record"),
            Self::Version { found } => write!(
                formatter,
                "record version {found}, only 1 to {RECORD_VERSION} are known here"
            ),
            Self::Section { id, version } => write!(
                formatter,
                "version {version} of section {id} of a record is not known here"
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
