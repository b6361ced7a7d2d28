//! Flash of the part as tests need it: words that are torn cannot be read, and the supply fails in the
//! middle of a chosen operation.

use crate::layout::{FLASH, SECTOR, WORD};
use crate::{BootFlash, SlotFlash};

const BYTES: usize = 8 * SECTOR as usize;

/// Bank 1.
#[derive(Clone)]
pub(crate) struct Model {
    bytes: Vec<u8>,
    poisoned: Vec<bool>,
    /// Words and erases begun.
    pub(crate) operations: u32,
    /// The operation the supply fails in, and how: see [`Cut`].
    pub(crate) cut: Option<(u32, Cut)>,
    /// The supply has failed: nothing happens any more.
    pub(crate) is_off: bool,
}

/// State of the operation in which the supply fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cut {
    /// It had not begun.
    Before,
    /// A half of it, which cannot be read.
    Poisoned,
    /// A half of it, which reads like a word or a sector.
    Readable,
    /// It was done, and nobody heard of it.
    After,
}

impl Cut {
    pub(crate) const ALL: [Self; 4] = [Self::Before, Self::Poisoned, Self::Readable, Self::After];
}

impl Model {
    pub(crate) fn erased() -> Self {
        Self {
            bytes: vec![0xFF; BYTES],
            poisoned: vec![false; BYTES / WORD],
            operations: 0,
            cut: None,
            is_off: false,
        }
    }

    /// As a probe on the bench would.
    pub(crate) fn put(&mut self, address: u32, bytes: &[u8]) {
        let at = (address - FLASH) as usize;
        self.bytes[at..at + bytes.len()].copy_from_slice(bytes);
    }

    pub(crate) fn poison(&mut self, address: u32) {
        self.poisoned[(address - FLASH) as usize / WORD] = true;
    }

    pub(crate) fn flip(&mut self, address: u32, bit: u8) {
        self.bytes[(address - FLASH) as usize] ^= 1 << bit;
    }

    /// The supply comes back.
    pub(crate) fn restore(&mut self) {
        (self.is_off, self.cut) = (false, None);
    }

    /// How the next operation goes: none without a supply.
    fn begin(&mut self) -> Option<Cut> {
        if self.is_off {
            return None;
        }
        self.operations += 1;
        let cut = self.cut.filter(|(nth, _)| *nth == self.operations);
        self.is_off = cut.is_some();
        Some(cut.map_or(Cut::After, |(_, cut)| cut))
    }
}

impl BootFlash for Model {
    fn read(&mut self, address: u32) -> Option<[u8; WORD]> {
        let at = (address - FLASH) as usize;
        assert!(at.is_multiple_of(WORD), "{address:#x} is not aligned");
        let readable = !self.is_off && !self.poisoned[at / WORD];
        readable.then(|| self.bytes[at..at + WORD].try_into().expect("a word"))
    }

    fn write(&mut self, address: u32, word: &[u8; WORD]) -> bool {
        let Some(how) = self.begin() else {
            return false;
        };
        let at = (address - FLASH) as usize;
        assert!(at.is_multiple_of(WORD), "{address:#x} is not aligned");
        if how == Cut::Before {
            return false;
        }
        let place = &mut self.bytes[at..at + WORD];
        // A word that is not erased gets check bits that do not fit.
        self.poisoned[at / WORD] |= place.iter().any(|byte| *byte != 0xFF);
        let half = usize::from(how == Cut::After) * WORD / 2 + WORD / 2;
        let bytes = place.iter_mut().zip(word).take(half);
        bytes.for_each(|(place, byte)| *place &= byte);
        self.poisoned[at / WORD] |= how == Cut::Poisoned;
        how == Cut::After && !self.is_off
    }
}

impl SlotFlash for Model {
    fn erase(&mut self, sector: u32) -> bool {
        let Some(how) = self.begin() else {
            return false;
        };
        let at = (sector - FLASH) as usize;
        assert!(at.is_multiple_of(SECTOR as usize));
        for nth in 0..SECTOR as usize / WORD {
            let at = at + nth * WORD;
            // Half of the words are as they were, a quarter cannot be read.
            let is_done = how == Cut::After || how != Cut::Before && nth % 2 == 1;
            if is_done {
                self.bytes[at..at + WORD].fill(0xFF);
                self.poisoned[at / WORD] = how == Cut::Poisoned && nth % 4 == 1;
            }
        }
        how == Cut::After && !self.is_off
    }
}
