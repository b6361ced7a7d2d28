//! The envelope around the content of every record: two bytes that say its kind and form, and a checksum.

use crate::error::RecordError;
use crate::frame::CRC;
use crate::kind::{Form, RecordKind, kind_of};
use serde::Serialize;

/// First two bytes of a record.
pub(crate) const MARK_BYTES: usize = 2;
/// Checksum at its end.
pub(crate) const CHECKSUM_BYTES: usize = 4;

/// Writes content between kind and checksum.
pub(crate) fn seal(
    kind: RecordKind,
    content: &impl Serialize,
    buffer: &mut [u8],
) -> Result<usize, RecordError> {
    let (version, rest) = buffer
        .split_first_chunk_mut::<MARK_BYTES>()
        .ok_or(RecordError::Length)?;
    *version = kind.mark().to_le_bytes();
    let body = postcard::to_slice(content, rest).map_err(|_| RecordError::Length)?;
    let end = MARK_BYTES + body.len();
    close(buffer, end)
}

/// Writes the checksum of what stands before `end` there; the length of the record.
pub(crate) fn close(buffer: &mut [u8], end: usize) -> Result<usize, RecordError> {
    let checksum = CRC.checksum(buffer.get(..end).ok_or(RecordError::Length)?);
    buffer
        .get_mut(end..end + CHECKSUM_BYTES)
        .ok_or(RecordError::Length)?
        .copy_from_slice(&checksum.to_le_bytes());
    Ok(end + CHECKSUM_BYTES)
}

/// Content between the first two bytes of a record and its checksum.
#[derive(Clone, Copy)]
pub(crate) struct Content<'a> {
    pub(crate) kind: RecordKind,
    pub(crate) form: Form,
    pub(crate) bytes: &'a [u8],
}

impl<'a> Content<'a> {
    /// The content whose first two bytes are `mark`; it may end early.
    pub(crate) fn begun(beginning: &'a [u8]) -> Result<Self, RecordError> {
        let (mark, bytes) = beginning
            .split_first_chunk::<MARK_BYTES>()
            .ok_or(RecordError::Length)?;
        let found = u16::from_le_bytes(*mark);
        let (kind, form) = kind_of(found).ok_or(RecordError::Version { found })?;
        Ok(Self { kind, form, bytes })
    }
}

/// Checks length, checksum and version, in this order.
pub(crate) fn open(bytes: &[u8]) -> Result<Content<'_>, RecordError> {
    let (content, checksum) = bytes
        .split_last_chunk::<CHECKSUM_BYTES>()
        .ok_or(RecordError::Length)?;
    if content.len() < MARK_BYTES {
        return Err(RecordError::Length);
    }
    if CRC.checksum(content) != u32::from_le_bytes(*checksum) {
        return Err(RecordError::Checksum);
    }
    Content::begun(content)
}

/// Whether the bytes are a record: length, checksum and version, in this order.
///
/// # Errors
/// See [`RecordError`]; `Checksum` before `Version`, because a damaged version
/// number is damage and no version.
pub fn check(bytes: &[u8]) -> Result<(), RecordError> {
    open(bytes).map(drop)
}

/// Sections of a record of any kind; none of one that was made before there were any.
pub(crate) fn sections_of(bytes: &[u8]) -> Result<Option<&[u8]>, RecordError> {
    let content = open(bytes)?;
    Ok((content.form == Form::Sections).then_some(content.bytes))
}

/// Content of a record of this kind.
pub(crate) fn content_of(kind: RecordKind, bytes: &[u8]) -> Result<Content<'_>, RecordError> {
    match open(bytes)? {
        content if content.kind == kind => Ok(content),
        content => Err(RecordError::Kind {
            found: content.kind,
        }),
    }
}
