//! A capture: raw sample pairs kept for a host, beside every measurement.
//!
//! ```text
//!              arm                  take                     take
//!   nothing --------> armed ------------------> taking ---------------> whole
//!                       ^   first block            | lose
//!                       |                          v
//!                       +---- arm, from any ---- broken
//! ```
//!
//! Nothing is decided here: the pairs are those the measurement gets too, in
//! the order they were sampled. A gap among them breaks the capture, so that
//! what a host reads is without one.

use calib_protocol::capture::{CAPTURE_CHUNK_PAIRS, CapturePart, MAX_CAPTURE_PAIRS};
use calib_protocol::message::Refusal;
use heapless::Vec;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
enum State {
    Nothing = 0,
    Armed = 1,
    Taking = 2,
    Whole = 3,
    Broken = 4,
}

/// Memory of one capture.
pub struct Capture {
    state: State,
    first: u64,
    total: u16,
    taken: u16,
    pairs: [u32; MAX_CAPTURE_PAIRS as usize],
}

impl Default for Capture {
    fn default() -> Self {
        Self::new()
    }
}

impl Capture {
    /// Nothing captured: all zero, so that it may lie in memory that is cleared
    /// at the start.
    pub const fn new() -> Self {
        Self {
            state: State::Nothing,
            first: 0,
            total: 0,
            taken: 0,
            pairs: [0; MAX_CAPTURE_PAIRS as usize],
        }
    }

    /// Wants `pairs` pairs from the next block on, and forgets those there are.
    ///
    /// # Errors
    /// [`Refusal::CaptureLength`]; then nothing is forgotten.
    pub fn arm(&mut self, pairs: u16) -> Result<(), Refusal> {
        if !(1..=MAX_CAPTURE_PAIRS).contains(&pairs) {
            return Err(Refusal::CaptureLength);
        }
        self.state = State::Armed;
        (self.first, self.total, self.taken) = (0, pairs, 0);
        Ok(())
    }

    /// Takes what it wants of a block whose first pair has the running number
    /// `first`. Copies at most the block.
    pub fn take(&mut self, first: u64, block: &[u32]) {
        match self.state {
            State::Nothing | State::Whole | State::Broken => return,
            State::Armed => (self.state, self.first) = (State::Taking, first),
            State::Taking => {}
        }
        let room = self
            .pairs
            .get_mut(usize::from(self.taken)..self.total.into());
        let room = room.unwrap_or_default();
        let count = room.len().min(block.len());
        for (kept, pair) in room.iter_mut().zip(block) {
            *kept = *pair;
        }
        // Not more than `total`, so the count fits.
        self.taken += count as u16;
        if self.taken == self.total {
            self.state = State::Whole;
        }
    }

    /// Pairs are missing before the next block.
    pub fn lose(&mut self) {
        if self.state == State::Taking {
            self.state = State::Broken;
        }
    }

    /// Pairs from `offset` on once all are taken, and how far it is until then.
    ///
    /// # Errors
    /// [`Refusal::NotCaptured`], [`Refusal::CaptureBroken`], and
    /// [`Refusal::OffsetOutOfRange`] behind the end.
    pub fn part(&self, offset: u16) -> Result<CapturePart, Refusal> {
        match self.state {
            State::Nothing => return Err(Refusal::NotCaptured),
            State::Broken => return Err(Refusal::CaptureBroken),
            _ if offset > self.total => return Err(Refusal::OffsetOutOfRange),
            State::Armed | State::Taking | State::Whole => {}
        }
        let mut data = Vec::new();
        if self.state == State::Whole {
            let wanted = self.pairs.get(usize::from(offset)..self.total.into());
            for pair in wanted.unwrap_or_default().iter().take(CAPTURE_CHUNK_PAIRS) {
                // The chunk fits, so nothing is left out.
                let _ = data.extend_from_slice(&pair.to_le_bytes());
            }
        }
        Ok(CapturePart {
            first: self.first,
            total: self.total,
            taken: self.taken,
            offset,
            data,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The pair with this running number: no two alike, no byte constant.
    fn pair(number: u64) -> u32 {
        (number as u32).wrapping_mul(0x9E37_79B1)
    }

    fn block(first: u64, length: usize) -> std::vec::Vec<u32> {
        (first..).map(pair).take(length).collect()
    }

    /// Reads it as a host does, part after part.
    fn read(capture: &Capture) -> std::vec::Vec<u32> {
        let mut words = std::vec::Vec::new();
        loop {
            let part = capture.part(words.len() as u16).expect("whole");
            if part.data.is_empty() {
                assert_eq!(words.len(), usize::from(part.total));
                return words;
            }
            let word = |[reference, dut]: [u16; 2]| u32::from(dut) << 16 | u32::from(reference);
            words.extend(part.codes().map(word));
        }
    }

    proptest! {
        #[test]
        fn every_pair_comes_once_and_in_order(
            pairs in 1..=MAX_CAPTURE_PAIRS,
            start in 0..u64::from(u32::MAX),
            length in 1_usize..3000,
        ) {
            let mut capture = Capture::new();
            capture.arm(pairs).expect("in range");
            let mut first = start;
            while !capture.part(0).expect("armed").is_whole() {
                prop_assert!(capture.part(0).expect("armed").data.is_empty());
                capture.take(first, &block(first, length));
                first += length as u64;
            }
            // What comes later does not touch it, nor does a gap.
            capture.take(first, &block(first, length));
            capture.lose();
            prop_assert_eq!(capture.part(0).expect("whole").first, start);
            prop_assert_eq!(read(&capture), block(start, pairs.into()));
        }
    }

    #[test]
    fn a_gap_breaks_it_until_it_is_armed_again() {
        let mut capture = Capture::new();
        assert_eq!(capture.part(0), Err(Refusal::NotCaptured));
        capture.arm(600).expect("in range");
        // Before the first block a gap is none of its own.
        capture.lose();
        capture.take(1000, &block(1000, 500));
        capture.lose();
        capture.take(2000, &block(2000, 500));
        assert_eq!(capture.part(0), Err(Refusal::CaptureBroken));
        capture.arm(500).expect("in range");
        capture.take(2500, &block(2500, 500));
        assert_eq!(read(&capture), block(2500, 500));
    }

    #[test]
    fn lengths_and_offsets_out_of_range_are_refused() {
        let mut capture = Capture::new();
        capture.arm(10).expect("in range");
        capture.take(0, &block(0, 500));
        for pairs in [0, MAX_CAPTURE_PAIRS + 1, u16::MAX] {
            assert_eq!(capture.arm(pairs), Err(Refusal::CaptureLength));
        }
        // The capture there was is untouched.
        assert_eq!(read(&capture), block(0, 10));
        assert!(capture.part(10).expect("its end").data.is_empty());
        assert_eq!(capture.part(11), Err(Refusal::OffsetOutOfRange));
    }
}
