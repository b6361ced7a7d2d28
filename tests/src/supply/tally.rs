//! Which cuts there were, and what they came to.

use super::{Doing, Met};
use calib_twin::runner::Torn;
use std::collections::BTreeMap;

/// Cuts while a host did one thing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// Cuts in no operation on the flash.
    pub between: u32,
    /// Cuts that tore a word.
    pub words: u32,
    /// Cuts that tore a sector.
    pub sectors: u32,
}

impl Row {
    /// Cuts of this row.
    pub fn cuts(self) -> u32 {
        self.between + self.words + self.sectors
    }
}

/// The cuts so far, by what the host did. Nothing was lost in any of them, or the survey had ended.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Cuts of the session itself, and such cuts in the start of the second board.
    pub rows: BTreeMap<Doing, Row>,
    /// Cuts in a start that followed another cut.
    pub again: Row,
    /// Cuts that came, whose second board was compared with the first one's start.
    pub came: u32,
    /// Starts of a board after a cut: each was heard, and nothing but its power-on restarted it.
    pub starts: u32,
    /// Second boards that went on to a round of work.
    pub rounds: u32,
    /// Records compared by second hosts.
    pub compared: u64,
}

impl Tally {
    /// All cuts.
    pub fn cuts(&self) -> u32 {
        self.rows.values().map(|row| row.cuts()).sum::<u32>() + self.again.cuts()
    }

    pub(super) fn note(&mut self, met: Met) {
        note(self.rows.entry(met.doing).or_default(), met.torn);
    }

    pub(super) fn note_again(&mut self, torn: Torn) {
        note(&mut self.again, torn);
    }
}

fn note(row: &mut Row, torn: Torn) {
    match torn {
        Torn::Nothing => row.between += 1,
        Torn::Word { .. } => row.words += 1,
        Torn::Sector { .. } => row.sectors += 1,
    }
}
