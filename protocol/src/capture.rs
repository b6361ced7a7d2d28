//! Captures: consecutive sample pairs as the converters gave them.
//!
//! A host asks for a number of pairs, and reads them in parts once they are all
//! taken. Both channels are sampled at one instant, so a pair is one instant.

use heapless::Vec;
use serde::{Deserialize, Serialize};

/// Most pairs of one capture: 0.33 s at 50 kHz, five cycles of 15.3 Hz.
pub const MAX_CAPTURE_PAIRS: u16 = 16_384;

/// Pairs of a capture in one answer.
pub const CAPTURE_CHUNK_PAIRS: usize = 256;

/// Bytes of a pair: the code of the reference channel, then that of the device
/// under test, each u16, little endian, offset binary (32 768 is 0 V).
pub const PAIR_BYTES: usize = 4;

/// A part of a capture, or how far it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CapturePart {
    /// Running number of the first pair, as
    /// [`Status::samples`](crate::message::Status::samples) counts; 0 until it
    /// is taken. It tells one capture from another.
    pub first: u64,
    /// Pairs that were asked for.
    pub total: u16,
    /// Pairs that are taken.
    pub taken: u16,
    /// Position of the first pair of `data` in the capture.
    pub offset: u16,
    /// Pairs from `offset` on, [`PAIR_BYTES`] each; none while `taken` is below
    /// `total`, nor at the end.
    pub data: Vec<u8, { CAPTURE_CHUNK_PAIRS * PAIR_BYTES }>,
}

impl CapturePart {
    /// Whether every pair is taken.
    pub const fn is_whole(&self) -> bool {
        self.taken == self.total
    }

    /// Codes of the pairs in `data`: reference, device under test.
    pub fn codes(&self) -> impl Iterator<Item = [u16; 2]> + '_ {
        let (pairs, _) = self.data.as_chunks::<PAIR_BYTES>();
        pairs.iter().map(|[low, high, dut_low, dut_high]| {
            [
                u16::from_le_bytes([*low, *high]),
                u16::from_le_bytes([*dut_low, *dut_high]),
            ]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::{MAX_FRAME, encode};
    use crate::message::Response;

    #[test]
    fn a_full_part_fits_a_frame_and_keeps_its_pairs() {
        let mut data = Vec::new();
        for number in 0..CAPTURE_CHUNK_PAIRS as u32 {
            // The converters' word: device under test above, reference below.
            let word = ((0xFFFF - number) << 16) | number;
            data.extend_from_slice(&word.to_le_bytes()).expect("fits");
        }
        let part = CapturePart {
            first: u64::MAX,
            total: MAX_CAPTURE_PAIRS,
            taken: MAX_CAPTURE_PAIRS,
            offset: MAX_CAPTURE_PAIRS - 1,
            data,
        };
        let codes: std::vec::Vec<_> = part.codes().collect();
        assert_eq!(codes.len(), CAPTURE_CHUNK_PAIRS);
        assert_eq!(codes[0], [0, 0xFFFF]);
        assert_eq!(codes[255], [255, 0xFF00]);
        let mut buffer = [0; MAX_FRAME];
        let length = encode(1, &Response::CaptureData(part), &mut buffer);
        // Number, first (10 bytes), three u16 (3 each), length (2), data; the
        // frame adds 6, and COBS 1 in 254 and the zero.
        assert!(length.expect("fits") <= 1 + 10 + 9 + 2 + 1024 + 6 + 6);
    }
}
