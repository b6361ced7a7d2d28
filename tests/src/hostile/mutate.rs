//! Mutations, the same each time.

use super::frames::{framed, whole_frames};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Longest result: longer than any frame, so that overlong ones come up.
const LONGEST: usize = 9000;

/// Draws mutated inputs from seeds.
pub struct Mutator {
    seeds: Vec<Vec<u8>>,
    random: ChaCha8Rng,
}

impl Mutator {
    /// Mutations of these seeds, of which there must be one.
    pub fn new(seeds: Vec<Vec<u8>>, seed: u64) -> Self {
        assert!(!seeds.is_empty(), "no seed");
        let random = ChaCha8Rng::seed_from_u64(seed);
        Self { seeds, random }
    }

    /// The next input: a seed, changed one to eight times.
    pub fn next_input(&mut self) -> Vec<u8> {
        let mut input = self.seed();
        for _ in 0..=self.below(8) {
            self.mutate(&mut input);
        }
        input.truncate(LONGEST);
        input
    }

    fn below(&mut self, end: usize) -> usize {
        (self.random.next_u64() % end.max(1) as u64) as usize
    }

    fn seed(&mut self) -> Vec<u8> {
        let index = self.below(self.seeds.len());
        self.seeds[index].clone()
    }

    fn mutate(&mut self, input: &mut Vec<u8>) {
        let at = self.below(input.len() + 1);
        match self.below(9) {
            0 if at < input.len() => input[at] ^= 1 << self.below(8),
            1 if at < input.len() => input[at] = self.random.next_u64() as u8,
            2 => input.insert(at, [0, 1, 0x7F, 0x80, 0xFF][self.below(5)]),
            3 => input.truncate(at),
            4 if at < input.len() => drop(input.remove(at)),
            5 => self.repeat(input, at),
            6 => {
                let other = self.seed();
                input.splice(at..at, other);
            }
            7 => self.reframe(input),
            _ => {
                let end = input.len().min(at + 1 + self.below(16));
                input.drain(at..end);
            }
        }
    }

    /// Part of the input again, many times: endless frames and floods.
    fn repeat(&mut self, input: &mut Vec<u8>, at: usize) {
        let end = input.len().min(at + 1 + self.below(64));
        let part = input[at..end].to_vec();
        let times = self.below(40);
        for _ in 0..times {
            if input.len() < LONGEST {
                input.splice(at..at, part.iter().copied());
            }
        }
    }

    /// Changes the message of a whole frame and makes it whole again: this is
    /// how what lies behind the checksum is reached.
    fn reframe(&mut self, input: &mut Vec<u8>) {
        let mut frames = whole_frames(input);
        let index = self.below(frames.len());
        if let Some(frame) = frames.get_mut(index) {
            let at = self.below(frame.message.len() + 1);
            match frame.message.get_mut(at) {
                Some(byte) if self.below(4) > 0 => *byte = self.random.next_u64() as u8,
                _ => frame.message.insert(at, self.random.next_u64() as u8),
            }
        }
        if !frames.is_empty() {
            *input = frames.iter().flat_map(framed).collect();
        }
    }
}
