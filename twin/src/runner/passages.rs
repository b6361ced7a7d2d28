//! How long a program takes from one place to another.

use std::time::Duration;

use rigless::emulator::{Hit, HitKind, Watch};

/// Bytes of a word.
const WORD: u64 = 4;

/// An instant in the life of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// It arrives at the instruction at this address.
    Arrival(u64),
    /// It has written the word at this address.
    Write(u64),
}

impl Mark {
    pub(super) fn watch(self) -> Watch {
        match self {
            Self::Arrival(address) => Watch::Instruction(address),
            Self::Write(address) => Watch::Writes {
                address,
                length: WORD,
            },
        }
    }

    pub(super) fn is_hit(self, hit: &Hit) -> bool {
        match self {
            Self::Arrival(address) => hit.kind == HitKind::Instruction && hit.address == address,
            Self::Write(address) => hit.kind == HitKind::Write && hit.address == address,
        }
    }
}

/// Ways of a program from one mark to another.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Passages {
    /// How many there were.
    pub count: u64,
    /// Instructions of all of them.
    pub instructions: u64,
    /// Instructions of the longest.
    pub most_instructions: u64,
    /// Virtual time of the slowest: with what it waited for.
    pub longest: Duration,
    entered: Option<(u64, u64)>,
}

impl Passages {
    /// Instructions of one on average.
    #[must_use]
    pub fn mean_instructions(&self) -> f64 {
        self.instructions as f64 / self.count.max(1) as f64
    }

    /// Takes `other` in, as if both had been watched at once.
    pub fn merge(&mut self, other: &Self) {
        self.count += other.count;
        self.instructions += other.instructions;
        self.most_instructions = self.most_instructions.max(other.most_instructions);
        self.longest = self.longest.max(other.longest);
    }

    pub(super) fn enter(&mut self, hit: &Hit) {
        self.entered = Some((hit.instruction_count, hit.at.0));
    }

    pub(super) fn leave(&mut self, hit: &Hit) {
        if let Some((instructions, at)) = self.entered.take() {
            let instructions = hit.instruction_count - instructions;
            self.count += 1;
            self.instructions += instructions;
            self.most_instructions = self.most_instructions.max(instructions);
            self.longest = self.longest.max(Duration::from_nanos(hit.at.0 - at));
        }
    }
}
