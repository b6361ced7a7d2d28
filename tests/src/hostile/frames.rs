//! The frame decoder, against a second one that shares no code with it.

use calib_protocol::frame::{Frame, MAX_FRAME, Receiver, encode};
use serde::ser::{Serialize, SerializeTuple, Serializer};

/// A frame that came whole.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Whole {
    /// Its sequence number.
    pub sequence: u16,
    /// Its message.
    pub message: Vec<u8>,
}

/// The decoder finds the same frames as docs/protocol.md says there are, and
/// the next good frame after them.
pub fn frames(data: &[u8]) {
    let mut receiver = Receiver::new();
    let mut take = |bytes: &[u8]| -> Vec<Whole> {
        let mut found = Vec::new();
        for byte in bytes {
            let Some(raw) = receiver.push(*byte) else {
                continue;
            };
            if let Ok(frame) = Frame::check(raw) {
                found.push(Whole {
                    sequence: frame.sequence,
                    message: frame.message.to_vec(),
                });
            }
        }
        found
    };
    let mut found = take(data);
    found.extend(take(&[0]));
    assert_eq!(found, whole_frames(data));
    let next = Whole {
        sequence: 0x5AA5,
        message: vec![0, 1, 2],
    };
    assert_eq!(take(&framed(&next)), [next]);
}

/// Every whole frame in `data`, of which the last may lack its zero.
pub fn whole_frames(data: &[u8]) -> Vec<Whole> {
    let parts = data.split(|byte| *byte == 0);
    let short = parts.filter(|part| !part.is_empty() && part.len() <= MAX_FRAME);
    short
        .filter_map(unstuffed)
        .filter_map(|plain| checked(&plain))
        .collect()
}

/// COBS, from its description: each group has its length in front and stands
/// for a zero after it, except the longest groups and the last.
fn unstuffed(part: &[u8]) -> Option<Vec<u8>> {
    let mut plain = Vec::new();
    let mut rest = part;
    while let Some((&length, after)) = rest.split_first() {
        let (group, next) = after.split_at_checked(usize::from(length) - 1)?;
        plain.extend_from_slice(group);
        if length < 255 && !next.is_empty() {
            plain.push(0);
        }
        rest = next;
    }
    Some(plain)
}

fn checked(plain: &[u8]) -> Option<Whole> {
    let (content, sum) = plain.split_last_chunk::<4>()?;
    let (sequence, message) = content.split_first_chunk::<2>()?;
    (crc_32(content) == u32::from_le_bytes(*sum)).then(|| Whole {
        sequence: u16::from_le_bytes(*sequence),
        message: message.to_vec(),
    })
}

/// CRC-32/ISO-HDLC bit by bit.
fn crc_32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |sum, byte| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| {
            (sum >> 1) ^ (0xEDB8_8320 & (sum & 1).wrapping_neg())
        })
    })
}

/// The bytes of a frame on the wire, its message cut to what fits.
pub fn framed(whole: &Whole) -> Vec<u8> {
    let mut buffer = vec![0; MAX_FRAME];
    let longest = calib_protocol::frame::MAX_MESSAGE;
    let message = &whole.message[..whole.message.len().min(longest)];
    // The longest message fits, as the length of a frame is made of it.
    let length = encode(whole.sequence, &Raw(message), &mut buffer).unwrap_or_default();
    buffer.truncate(length);
    buffer
}

/// Bytes that postcard writes as they are.
struct Raw<'a>(&'a [u8]);

impl Serialize for Raw<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(self.0.len())?;
        self.0
            .iter()
            .try_for_each(|byte| tuple.serialize_element(byte))?;
        tuple.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_decoder_knows_the_check_value_and_the_longest_groups() {
        assert_eq!(crc_32(b"123456789"), 0xCBF4_3926);
        for length in [0, 1, 247, 248, 249, 253, 254, 255, 600, 4096] {
            let whole = Whole {
                sequence: 7,
                message: vec![9; length],
            };
            assert_eq!(whole_frames(&framed(&whole)), [whole], "{length}");
        }
    }
}
