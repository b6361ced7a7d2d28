//! Where the cuts of a survey are.

use super::outage::Cut;
use calib_twin::runner::Emulator;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::time::Duration;

/// A start, with the scan of a full area.
const START_US: u64 = 300_000;
/// Longest time between two cuts at random instants.
const SPELL_US: u64 = 400_000;
/// Most operations from one cut to the next: prime to the fractions, so that each meets every place.
const STRIDES: u64 = 7;
/// How far into an operation.
const FRACTIONS: [f64; 5] = [0.02, 0.25, 0.5, 0.75, 0.98];
/// Cuts of one erase.
const CUTS_OF_AN_ERASE: f64 = 12.0;
/// Every so many cuts one is at a random instant, one has the second board cut again, one sends it to
/// work, and one comes.
const RANDOM: u64 = 8;
const AGAIN: u64 = 4;
const WORK: u64 = 4;
const COMES: u64 = 25;

/// Draws cuts.
#[derive(Debug)]
pub(super) struct Plan {
    number: u64,
    random: ChaCha8Rng,
}

/// Actions at a cut besides a look at the second board.
#[derive(Clone, Debug)]
pub(super) struct Fate {
    /// Cuts of the second board's start, one after the other.
    pub(super) again: Vec<Cut>,
    /// The second board goes on to a round of work.
    pub(super) works: bool,
    /// The supply of the first board fails.
    pub(super) comes: bool,
}

impl Plan {
    pub(super) fn new(seed: u64) -> Self {
        Self {
            number: 0,
            random: ChaCha8Rng::seed_from_u64(seed),
        }
    }

    /// The first cut of a spell: in the start, or in the erase that mends.
    pub(super) fn first(&mut self) -> Cut {
        self.of_a_start()
    }

    /// The cut after one that `board` stands at.
    pub(super) fn next(&mut self, board: &Emulator) -> Cut {
        if let Some(cut) = self.further_in_the_erase(board) {
            return cut;
        }
        let drawn = self.draw();
        let fraction = self.fraction();
        match self.number % RANDOM {
            0 => Cut::After(Duration::from_micros(1 + drawn % SPELL_US)),
            _ => Cut::InOperationOrErase {
                nth: 1 + drawn % STRIDES,
                fraction,
            },
        }
    }

    /// Fate of the cut that has come.
    pub(super) fn fate(&mut self, tears_a_sector: bool) -> Fate {
        self.number += 1;
        let again = match self.number {
            _ if tears_a_sector => 1 + self.draw() % 2,
            number if number % AGAIN == 1 => 1,
            _ => 0,
        };
        Fate {
            again: (0..again).map(|_| self.of_a_start()).collect(),
            works: self.number % WORK == 2,
            comes: self.number.is_multiple_of(COMES),
        }
    }

    /// Half of them in the first operation of a start, which is mostly the erase that mends.
    fn of_a_start(&mut self) -> Cut {
        let drawn = self.draw();
        let fraction = self.fraction();
        match drawn % 2 {
            0 => Cut::InOperation { nth: 1, fraction },
            _ => Cut::After(Duration::from_micros(1 + drawn / 2 % START_US)),
        }
    }

    /// A later instant of the erase under way.
    fn further_in_the_erase(&mut self, board: &Emulator) -> Option<Cut> {
        let (begun, lasts) = board.flash_watch().erase_under_way()?;
        let step = lasts.mul_f64(2.0 * self.share() / CUTS_OF_AN_ERASE);
        (board.elapsed() + step < begun + lasts).then_some(Cut::After(step))
    }

    fn fraction(&mut self) -> f64 {
        FRACTIONS[self.draw() as usize % FRACTIONS.len()]
    }

    /// From 0 to 1.
    fn share(&mut self) -> f64 {
        (self.draw() % 1000) as f64 / 1000.0
    }

    fn draw(&mut self) -> u64 {
        self.random.next_u64()
    }
}
