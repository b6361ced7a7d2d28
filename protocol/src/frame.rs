//! Frames: COBS, sequence number, CRC-32.
//!
//! | bytes before COBS | content |
//! |---|---|
//! | 2 | sequence number, u16 LE: an answer carries the number of its request |
//! | n | message, postcard ([`crate::message`]) |
//! | 4 | CRC-32 (ISO-HDLC) of everything before, LE |
//!
//! A zero byte ends a frame and occurs nowhere inside one, so a receiver that
//! lost its place is back after the next zero, and empty frames mean nothing.

use crc::{CRC_32_ISO_HDLC, Crc, Digest};
use postcard::ser_flavors::Flavor;
use serde::{Deserialize, Serialize};

/// Version of frames, messages and records together. Peers with another
/// number refuse each other instead of misreading bytes.
pub const PROTOCOL_VERSION: u16 = 2;

/// Bit rate of the serial link on USART3, 8 data bits, no parity, 1 stop bit.
/// USB CDC-ACM ignores it.
pub const SERIAL_BAUD: u32 = 115_200;

/// Longest message, in bytes, before sequence number, checksum and COBS.
pub const MAX_MESSAGE: usize = 4096;

/// Longest frame on the wire, with COBS overhead and terminator.
pub const MAX_FRAME: usize = cobs::max_encoding_length(MAX_MESSAGE + 6) + 1;

/// CRC-32 as in Ethernet and zip, of frames and records.
pub const CRC: Crc<u32> = Crc::<u32>::new(&CRC_32_ISO_HDLC);

/// Why a frame could not be made or read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FrameError {
    /// The message does not fit the buffer.
    TooLong,
    /// Not COBS, or too short for sequence number and checksum.
    Malformed,
    /// The checksum differs: bytes were damaged on the way.
    Checksum,
    /// The frame came whole, and its message is none of this protocol version.
    Message,
}

impl core::fmt::Display for FrameError {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        formatter.write_str(match self {
            Self::TooLong => "message too long for a frame",
            Self::Malformed => "malformed frame",
            Self::Checksum => "checksum of the frame failed",
            Self::Message => "unknown message",
        })
    }
}

impl core::error::Error for FrameError {}

/// Writes one frame with its terminator and returns its length in bytes.
///
/// A `buffer` of [`MAX_FRAME`] bytes takes any message of this protocol.
///
/// # Errors
/// [`FrameError::TooLong`] when the buffer is too small.
pub fn encode<M: Serialize>(
    sequence: u16,
    message: &M,
    buffer: &mut [u8],
) -> Result<usize, FrameError> {
    let too_long = |_| FrameError::TooLong;
    let room = buffer.len().checked_sub(2).ok_or(FrameError::TooLong)?;
    let body = buffer.get_mut(..=room).ok_or(FrameError::TooLong)?;
    let mut writer = FrameWriter {
        encoder: cobs::CobsEncoder::new(body),
        digest: CRC.digest(),
    };
    writer
        .try_extend(&sequence.to_le_bytes())
        .map_err(too_long)?;
    let length = postcard::serialize_with_flavor(message, writer).map_err(too_long)?;
    *buffer.get_mut(length).ok_or(FrameError::TooLong)? = 0;
    Ok(length + 1)
}

/// Sums the checksum and stuffs the bytes while postcard produces them.
struct FrameWriter<'a> {
    encoder: cobs::CobsEncoder<'a>,
    digest: Digest<'static, u32>,
}

impl Flavor for FrameWriter<'_> {
    type Output = usize;

    fn try_extend(&mut self, data: &[u8]) -> postcard::Result<()> {
        self.digest.update(data);
        let full = |_| postcard::Error::SerializeBufferFull;
        self.encoder.push(data).map_err(full)
    }

    fn try_push(&mut self, byte: u8) -> postcard::Result<()> {
        self.try_extend(&[byte])
    }

    fn finalize(mut self) -> postcard::Result<usize> {
        let checksum = self.digest.finalize().to_le_bytes();
        let full = |_| postcard::Error::SerializeBufferFull;
        self.encoder.push(&checksum).map_err(full)?;
        Ok(self.encoder.finalize())
    }
}

/// A received frame: whole, with the right checksum, not yet understood.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame<'a> {
    /// Sequence number.
    pub sequence: u16,
    /// Message, postcard.
    pub message: &'a [u8],
    /// CRC-32 of both: with the sequence number it tells a repeated request
    /// from a new one.
    pub checksum: u32,
}

impl<'a> Frame<'a> {
    /// Checks the bytes of one frame, without its terminator; unstuffs in place.
    ///
    /// # Errors
    /// [`FrameError::Malformed`] and [`FrameError::Checksum`]: ask again.
    pub fn check(bytes: &'a mut [u8]) -> Result<Self, FrameError> {
        // The COBS decoder takes a zero for an end and would accept a prefix.
        if bytes.contains(&0) {
            return Err(FrameError::Malformed);
        }
        let length = cobs::decode_in_place(bytes).map_err(|_| FrameError::Malformed)?;
        let plain = bytes.get(..length).ok_or(FrameError::Malformed)?;
        let (content, checksum) = plain.split_last_chunk::<4>().ok_or(FrameError::Malformed)?;
        let (sequence, message) = content
            .split_first_chunk::<2>()
            .ok_or(FrameError::Malformed)?;
        let checksum = u32::from_le_bytes(*checksum);
        if CRC.checksum(content) != checksum {
            return Err(FrameError::Checksum);
        }
        Ok(Self {
            sequence: u16::from_le_bytes(*sequence),
            message,
            checksum,
        })
    }

    /// Reads the message.
    ///
    /// # Errors
    /// [`FrameError::Message`]: the peer speaks another version.
    pub fn message<M: Deserialize<'a>>(&self) -> Result<M, FrameError> {
        match postcard::take_from_bytes(self.message) {
            Ok((message, [])) => Ok(message),
            _ => Err(FrameError::Message),
        }
    }
}

/// Collects bytes from a link into frames.
///
/// An overlong frame is dropped up to its terminator, an empty one at once.
#[derive(Clone, Debug)]
pub struct Receiver {
    buffer: [u8; MAX_FRAME],
    length: usize,
    overlong: bool,
    complete: bool,
}

impl Default for Receiver {
    fn default() -> Self {
        Self::new()
    }
}

impl Receiver {
    /// An empty receiver.
    pub const fn new() -> Self {
        Self {
            buffer: [0; MAX_FRAME],
            length: 0,
            overlong: false,
            complete: false,
        }
    }

    /// Takes one byte; at the end of a frame, returns its bytes without the
    /// terminator, for [`Frame::check`].
    pub fn push(&mut self, byte: u8) -> Option<&mut [u8]> {
        if self.complete {
            self.clear();
        }
        if byte != 0 {
            match self.buffer.get_mut(self.length) {
                Some(slot) => *slot = byte,
                None => self.overlong = true,
            }
            self.length = (self.length + 1).min(MAX_FRAME);
            return None;
        }
        self.complete = true;
        self.whole()
    }

    /// The frame that the last byte ended, if it ended one.
    pub fn whole(&mut self) -> Option<&mut [u8]> {
        if !self.complete || self.overlong || self.length == 0 {
            return None;
        }
        self.buffer.get_mut(..self.length)
    }

    /// Sequence number of a frame that has begun and not ended, once it is here.
    pub fn begun(&self) -> Option<u16> {
        let bytes = self.buffer.get(..self.length).filter(|_| !self.complete)?;
        // COBS: a code, as many bytes less one, and a zero that is left out; of 255 no zero follows.
        let (&code, rest) = bytes.split_first()?;
        let sequence = match (code, rest) {
            (1, [1, ..]) => [0, 0],
            (1, [_, high, ..]) => [0, *high],
            (2, [low, _, ..]) => [*low, 0],
            (_, [low, high, ..]) => [*low, *high],
            _ => return None,
        };
        Some(u16::from_le_bytes(sequence))
    }

    /// Forgets a frame begun.
    pub fn clear(&mut self) {
        (self.length, self.overlong, self.complete) = (0, false, false);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn frame(sequence: u16, message: &[u8]) -> Vec<u8> {
        let mut buffer = vec![0xAA; MAX_FRAME];
        let length = encode(sequence, &message, &mut buffer).expect("fits");
        buffer.truncate(length);
        buffer
    }

    fn receive(receiver: &mut Receiver, bytes: &[u8]) -> Vec<(u16, Vec<u8>)> {
        let mut frames = Vec::new();
        for byte in bytes {
            if let Some(raw) = receiver.push(*byte)
                && let Ok(frame) = Frame::check(raw)
            {
                let message: &[u8] = frame.message().expect("bytes");
                frames.push((frame.sequence, message.to_vec()));
            }
        }
        frames
    }

    #[test]
    fn the_wire_form_is_the_documented_one() {
        // Sequence 0x0002 LE, postcard of &[0u8] = 01 00, and their CRC-32 by
        // Python: zlib.crc32(b"\x02\x00\x01\x00") = 0x925626D6; stuffed by hand.
        assert_eq!(
            frame(2, &[0]),
            [0x02, 0x02, 0x02, 0x01, 0x05, 0xD6, 0x26, 0x56, 0x92, 0]
        );
    }

    proptest! {
        #[test]
        fn decoding_inverts_encoding(sequence: u16, message in prop::collection::vec(any::<u8>(), 0..3000)) {
            let bytes = frame(sequence, &message);
            prop_assert_eq!(bytes.iter().position(|byte| *byte == 0), Some(bytes.len() - 1));
            let mut receiver = Receiver::new();
            prop_assert_eq!(receive(&mut receiver, &bytes), vec![(sequence, message)]);
        }

        #[test]
        fn a_frame_that_has_begun_tells_its_number(
            sequence in prop_oneof![any::<u16>(), 0..256_u16, (0..256_u16).prop_map(|high| high << 8)],
            message in prop::collection::vec(any::<u8>(), 0..600),
            here: prop::sample::Index,
        ) {
            let bytes = frame(sequence, &message);
            let (begun, rest) = bytes.split_at(3 + here.index(bytes.len() - 3));
            let mut receiver = Receiver::new();
            prop_assert_eq!(receive(&mut receiver, begun), vec![]);
            prop_assert_eq!(receiver.begun(), Some(sequence));
            prop_assert_eq!(receive(&mut receiver, rest), vec![(sequence, message)]);
            prop_assert_eq!(receiver.begun(), None);
        }

        #[test]
        fn one_damaged_byte_never_passes(
            message in prop::collection::vec(any::<u8>(), 0..600),
            position: prop::sample::Index,
            flip in 1_u8..,
        ) {
            let mut bytes = frame(7, &message);
            let position = position.index(bytes.len());
            bytes[position] ^= flip;
            bytes.push(0);
            prop_assert_eq!(receive(&mut Receiver::new(), &bytes), vec![]);
        }

        #[test]
        fn any_bytes_are_survived_and_the_next_frame_is_read(
            noise in prop::collection::vec(any::<u8>(), 0..9000),
        ) {
            let mut receiver = Receiver::new();
            receive(&mut receiver, &noise);
            receive(&mut receiver, &[0]);
            prop_assert_eq!(receive(&mut receiver, &frame(3, b"here")), vec![(3, b"here".to_vec())]);
        }
    }

    #[test]
    fn a_message_longer_than_the_buffer_is_refused_at_every_length() {
        let whole = frame(1, &[9; 300]).len();
        for room in 0..whole {
            let mut buffer = vec![0; room];
            let message: &[u8] = &[9; 300];
            assert_eq!(
                encode(1, &message, &mut buffer),
                Err(FrameError::TooLong),
                "{room}"
            );
        }
    }

    #[test]
    fn trailing_bytes_make_a_message_unknown() {
        let mut bytes = frame(1, &[1, 2]);
        bytes.pop();
        let checked = Frame::check(&mut bytes).expect("whole");
        assert_eq!(checked.message::<u8>(), Err(FrameError::Message));
    }
}
