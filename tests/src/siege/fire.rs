//! What hostile hosts send.

use crate::hostile::{Mutator, Whole, seeds, whole_frames};
use calib_protocol::frame::{MAX_FRAME, encode};
use calib_protocol::message::Request;

/// Number of what any host may ask for, whoever holds the session.
const STOP: u8 = 4;

/// A request as it goes over the line.
pub fn frame(sequence: u16, request: &Request) -> Vec<u8> {
    let mut buffer = vec![0; MAX_FRAME];
    // Any request of this version fits.
    let length = encode(sequence, request, &mut buffer).unwrap_or_default();
    buffer.truncate(length);
    buffer
}

/// Mutated and replayed requests, the same each time.
pub struct Ammunition(Mutator);

impl Ammunition {
    /// A store of them; another number, another store.
    pub fn new(number: u64) -> Self {
        Self(Mutator::new(Self::heard(), number))
    }

    /// Frames of requests: what a host that replays has heard, but for those whose answers alone
    /// take the serial line longer than an answer may take.
    pub fn heard() -> Vec<Vec<u8>> {
        let seeds = seeds().into_iter();
        seeds
            .filter(|seed| seed.target == "commands" && seed.name != "request-07")
            .map(|seed| seed.bytes)
            .collect()
    }

    /// Inputs of so many bytes together whose whole frames, if any, are `allowed`.
    pub fn salvo(&mut self, length: usize, allowed: fn(&Whole) -> bool) -> Vec<u8> {
        let mut salvo = Vec::new();
        while salvo.len() < length {
            let input = self.0.next_input();
            if whole_frames(&input).iter().all(allowed) {
                salvo.extend(input);
                salvo.push(0);
            }
        }
        salvo
    }

    /// Anything but what stops a run, which any host may ask for.
    pub fn no_stop(&mut self, length: usize) -> Vec<u8> {
        self.salvo(length, |whole| whole.message.first() != Some(&STOP))
    }

    /// Nothing that is answered.
    pub fn noise(&mut self, length: usize) -> Vec<u8> {
        self.salvo(length, |_| false)
    }
}
