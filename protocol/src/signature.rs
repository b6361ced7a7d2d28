//! Signatures of records by the key of the instrument that made them (Ed25519, RFC 8032).
//!
//! A signed record ends, before its checksum, with section [`SIGNATURE`]. Signed is [`message`]: a constant
//! beginning, so that the signature is good for nothing else, and the SHA-256 of every byte before the section.
//! Bytes alone are laid out here; keys and curves belong to the firmware and to hosts.

use crate::envelope::{CHECKSUM_BYTES, MARK_BYTES, close, sections_of};
use crate::error::RecordError;
use crate::head::{Sha256Sum, digest};
use crate::sections::{Fields, find, section};
use serde::{Deserialize, Serialize};

/// Section of a record that holds its signature, the last one.
const SIGNATURE: u8 = 8;
/// First bytes of the section: id, version and length of the content.
const FRONT: [u8; 3] = [SIGNATURE, 1, 96];
/// Beginning of what is signed.
const CONTEXT: &[u8; 12] = b"calib record";

/// Bytes that a signature makes a record longer.
pub const SIGNATURE_BYTES: usize = FRONT.len() + 96;

/// A public key of Ed25519.
pub type PublicKey = [u8; 32];

/// Bytes that are signed for a record.
pub type Message = [u8; 12 + 32];

/// Public key of an instrument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct DeviceKey {
    /// The key.
    pub public: PublicKey,
    /// Records from this running number on are signed by it.
    pub since: u32,
}

/// A signature, and the key it is said to be of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Signature {
    /// The public key.
    pub key: PublicKey,
    /// The signature: R and S (RFC 8032, 5.1.6).
    pub halves: [[u8; 32]; 2],
}

/// Message to be signed for a record whose content has this SHA-256.
pub fn message(content: &Sha256Sum) -> Message {
    let mut message = [0; 12 + 32];
    let (context, sum) = message.split_at_mut(CONTEXT.len());
    context.copy_from_slice(CONTEXT);
    sum.copy_from_slice(content);
    message
}

/// Signs the record of `length` bytes at the beginning of `buffer`; its length from then on.
///
/// # Errors
/// [`RecordError::Length`] when the buffer is too small.
pub fn append(
    buffer: &mut [u8],
    length: usize,
    sign: impl FnOnce(&Message) -> Signature,
) -> Result<usize, RecordError> {
    let end = length
        .checked_sub(CHECKSUM_BYTES)
        .ok_or(RecordError::Length)?;
    let content = buffer.get(..end).ok_or(RecordError::Length)?;
    let signature = sign(&message(&digest(content)));
    let room = buffer.get_mut(end..).ok_or(RecordError::Length)?;
    let written = postcard::to_slice(&section(SIGNATURE, signature), room);
    let end = end + written.map_err(|_| RecordError::Length)?.len();
    close(buffer, end)
}

/// Signature of a record and what it must fit, none where it is not signed.
///
/// # Errors
/// Those of [`crate::record::check`]; [`RecordError::Content`] when something follows the signature.
pub fn of(record: &[u8]) -> Result<Option<(Signature, Message)>, RecordError> {
    // Records of version 1 have none.
    let Some(sections) = sections_of(record)? else {
        return Ok(None);
    };
    let Some((at, content)) = find(sections, SIGNATURE, 1)? else {
        return Ok(None);
    };
    if at + content.len() != sections.len() {
        return Err(RecordError::Content);
    }
    let front = (MARK_BYTES + at)
        .checked_sub(FRONT.len())
        .ok_or(RecordError::Content)?;
    let (signed, rest) = record.split_at_checked(front).ok_or(RecordError::Content)?;
    // Signed is what stands before it: the section itself can be written in one way alone.
    if !rest.starts_with(&FRONT) {
        return Err(RecordError::Content);
    }
    Ok(Some((Fields(content).take()?, message(&digest(signed)))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::CRC;
    use crate::record::{Record, decode, encode};

    const KEY: PublicKey = [7; 32];

    fn signed() -> (std::vec::Vec<u8>, std::vec::Vec<u8>, Message) {
        let mut bytes = vec![0; 2048];
        let length = encode(&Record::BLANK, &mut bytes).expect("fits");
        let plain = bytes[..length].to_vec();
        let mut asked = None;
        let signing = |message: &Message| {
            asked = Some(*message);
            Signature {
                key: KEY,
                halves: [[1; 32], [2; 32]],
            }
        };
        let longer = append(&mut bytes, length, signing).expect("fits");
        bytes.truncate(longer);
        (plain, bytes, asked.expect("was asked"))
    }

    #[test]
    fn the_signature_is_the_last_section_over_all_before_it() {
        let (plain, bytes, asked) = signed();
        assert_eq!(bytes.len(), plain.len() + SIGNATURE_BYTES);
        let content = &plain[..plain.len() - 4];
        assert_eq!(bytes[..content.len()], *content);
        assert_eq!(bytes[content.len()..content.len() + 3], [8, 1, 96]);
        assert_eq!(&asked[..12], b"calib record");
        assert_eq!(asked[12..], digest(content));
        let (signature, message) = of(&bytes).expect("a record").expect("signed");
        assert_eq!((signature.key, message), (KEY, asked));
        assert_eq!(of(&plain), Ok(None));
    }

    /// A release without signatures reads the record, and its own sum is another.
    #[test]
    fn a_signed_record_reads_as_one_without() {
        let (plain, bytes, _) = signed();
        let mut read = decode(&bytes).expect("whole");
        assert_eq!(read.sha256, Some(digest(&bytes)));
        read.sha256 = Some(digest(&plain));
        assert_eq!(read.signed_by.take(), Some(KEY));
        assert_eq!(Ok(read), decode(&plain));
    }

    #[test]
    fn nothing_follows_a_signature() {
        let (_, bytes, _) = signed();
        let mut longer = bytes.clone();
        longer.truncate(bytes.len() - 4);
        longer.extend_from_slice(&[99, 1, 0]);
        let checksum = CRC.checksum(&longer);
        longer.extend_from_slice(&checksum.to_le_bytes());
        assert_eq!(of(&longer), Err(RecordError::Content));
    }
}
