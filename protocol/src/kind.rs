//! The first two bytes of a record: what it is about, and in which form.

use serde::{Deserialize, Serialize};

/// Version of the records that are written.
pub const RECORD_VERSION: u16 = 2;

/// Kind of a record.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RecordKind {
    /// A run that was measured: a [`Record`](crate::calibration::Record).
    #[default]
    Calibration,
    /// Other settings: a [`crate::change::ReferenceChange`]. Changes of the reference were the first to be
    /// logged, and gave the name.
    ReferenceChange,
}

/// How the content of a record is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// Version 1, fields one behind the other.
    Plain,
    /// Version 2, in sections.
    Sections,
}

impl RecordKind {
    /// The first two bytes of a record of this kind, as it is written.
    pub(crate) const fn mark(self) -> u16 {
        match self {
            Self::Calibration => RECORD_VERSION,
            Self::ReferenceChange => 0x0100 | RECORD_VERSION,
        }
    }
}

/// Kind and form of the records that begin with `mark`.
pub(crate) const fn kind_of(mark: u16) -> Option<(RecordKind, Form)> {
    match mark {
        0x0001 => Some((RecordKind::Calibration, Form::Plain)),
        0x0101 => Some((RecordKind::ReferenceChange, Form::Plain)),
        0x0002 => Some((RecordKind::Calibration, Form::Sections)),
        0x0102 => Some((RecordKind::ReferenceChange, Form::Sections)),
        _ => None,
    }
}
