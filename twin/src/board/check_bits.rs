//! Check bits of the flash: words that do not fit theirs, and what a read of one leaves behind.
//!
//! A word with one wrong bit, *weak*, is mended on its way out and sets `SNECCERR`; one with two, *poisoned*,
//! cannot be and sets `DBECCERR` (RM0433 Rev 9, 4.7.7 and 4.7.8). For the core a poisoned word is a bus fault
//! as well, for a DMA controller the flag is all. Either flag stands until it is cleared, and the failing
//! address is that of the read that set the first one (4.9.37).

use std::collections::BTreeSet;
use std::ops::Range;

use rigless::device::RegisterFile;
use rigless::soc::stm32h743::generated::flash::{Register, ecc_fa2r, sr1, sr2};
use serde::{Deserialize, Serialize};

/// Result of reading a word whose check bits do not fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum Met {
    /// One bit was wrong, and is mended in what was read.
    Corrected,
    /// Two were: what was read means nothing.
    Poisoned,
}

/// First addresses of the words whose check bits do not fit.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(crate) struct CheckBits {
    poisoned: BTreeSet<u64>,
    weak: BTreeSet<u64>,
    /// Met by a DMA controller, and not yet seen in the registers.
    by_dma: Vec<(u64, Met)>,
}

impl CheckBits {
    /// Words that cannot be read.
    pub(super) fn poisoned(&self) -> usize {
        self.poisoned.len()
    }

    /// These words cannot be read any more.
    pub(super) fn poison(&mut self, words: impl IntoIterator<Item = u64>) {
        self.poisoned.extend(words);
    }

    /// One bit of a word is wrong from now on.
    pub(super) fn weaken(&mut self, word: u64) {
        self.weak.insert(word);
    }

    /// The words of a range are as good as new.
    pub(super) fn heal(&mut self, range: &Range<u64>) {
        self.poisoned.retain(|word| !range.contains(word));
        self.weak.retain(|word| !range.contains(word));
    }

    /// All words whose check bits do not fit.
    pub(super) fn unfit(&self) -> Vec<u64> {
        self.poisoned.union(&self.weak).copied().collect()
    }

    /// Result of reading `word`, where its check bits do not fit.
    pub(super) fn met(&self, word: u64) -> Option<Met> {
        if self.poisoned.contains(&word) {
            return Some(Met::Poisoned);
        }
        self.weak.contains(&word).then_some(Met::Corrected)
    }

    /// A DMA controller has read `word`.
    pub(super) fn read_by_dma(&mut self, word: u64) {
        self.by_dma.extend(self.met(word).map(|met| (word, met)));
    }

    /// Reads of misfitting words by DMA controllers since the last call.
    pub(super) fn take_met_by_dma(&mut self) -> Vec<(u64, Met)> {
        std::mem::take(&mut self.by_dma)
    }
}

/// The interface shows that the `nth_word` of a bank was read and its check bits did not fit.
pub(super) fn latch(bank: usize, nth_word: u64, met: Met, registers: &mut RegisterFile) {
    let (status, [corrected, poisoned], failing) = match bank {
        0 => (
            Register::Sr1,
            [sr1::SNECCERR, sr1::DBECCERR1],
            Register::EccFa1r,
        ),
        _ => (
            Register::Sr2,
            [sr2::SNECCERR2, sr2::DBECCERR2],
            Register::EccFa2r,
        ),
    };
    let before = registers.get(status);
    if before & (corrected.mask() | poisoned.mask()) == 0 {
        registers.set(failing, ecc_fa2r::FAIL_ECC_ADDR2.set(0, nth_word));
    }
    let flag = match met {
        Met::Corrected => corrected,
        Met::Poisoned => poisoned,
    };
    registers.set(status, before | flag.mask());
}
