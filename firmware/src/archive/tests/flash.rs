//! A strict NOR flash: what the real one forbids is an error here, and the
//! power can fail in the middle of any word or erase.
//!
//! A word whose programming was cut is *poisoned*: its check bits do not fit, and
//! no read of it gives bytes. So are all words of a sector whose erase was cut, or
//! any of them: both are tried. Only an erase that came to its end heals.

use calib_firmware::archive::CheckedFlash;
use embedded_storage_async::nor_flash::{
    ErrorType, NorFlash, NorFlashError, NorFlashErrorKind, ReadNorFlash,
};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::cell::RefCell;
use std::rc::Rc;

/// Bytes that are programmed at once; they can be programmed once only, since
/// the check bits of a flash word cannot be changed (RM0433 Rev 8, 4.3.9).
pub(super) const WORD: usize = 32;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FlashError {
    /// The power failed in this operation, or before.
    PowerCut,
    /// A word was programmed twice without an erase between.
    Rewritten(u32),
    /// The check bits of a word that was read do not fit.
    Poisoned(u32),
    /// Address or length is no multiple of a word or sector.
    Alignment,
    /// Outside of the flash.
    Range,
}

impl NorFlashError for FlashError {
    fn kind(&self) -> NorFlashErrorKind {
        NorFlashErrorKind::Other
    }
}

pub(super) struct Cells {
    pub(super) bytes: Vec<u8>,
    /// Whether each word was programmed since it was erased.
    programmed: Vec<bool>,
    /// Whether the check bits of each word do not fit.
    poisoned: Vec<bool>,
    /// Words and sectors torn, and reads of poisoned words, so far.
    pub(super) torn_words: u64,
    pub(super) torn_sectors: u64,
    pub(super) poisoned_reads: u64,
    /// Erases of each sector.
    pub(super) erases: Vec<u32>,
    /// Words and erases so far.
    pub(super) operations: u64,
    /// The operation in which the power fails.
    pub(super) cut_at: Option<u64>,
    random: ChaCha8Rng,
}

/// The flash; copies are the same flash.
#[derive(Clone)]
pub(super) struct MockFlash<const SECTOR: usize>(pub(super) Rc<RefCell<Cells>>);

impl<const SECTOR: usize> MockFlash<SECTOR> {
    pub(super) fn erased(sectors: usize) -> Self {
        Self(Rc::new(RefCell::new(Cells {
            bytes: vec![0xFF; sectors * SECTOR],
            programmed: vec![false; sectors * SECTOR / WORD],
            poisoned: vec![false; sectors * SECTOR / WORD],
            torn_words: 0,
            torn_sectors: 0,
            poisoned_reads: 0,
            erases: vec![0; sectors],
            operations: 0,
            cut_at: None,
            random: ChaCha8Rng::seed_from_u64(1),
        })))
    }

    /// Copies the content into a flash of its own.
    pub(super) fn duplicate(&self, seed: u64) -> Self {
        let cells = self.0.borrow();
        Self(Rc::new(RefCell::new(Cells {
            bytes: cells.bytes.clone(),
            programmed: cells.programmed.clone(),
            poisoned: cells.poisoned.clone(),
            torn_words: cells.torn_words,
            torn_sectors: cells.torn_sectors,
            poisoned_reads: cells.poisoned_reads,
            erases: cells.erases.clone(),
            operations: cells.operations,
            cut_at: None,
            random: ChaCha8Rng::seed_from_u64(seed),
        })))
    }
}

impl Cells {
    /// Sets each bit of a range with a probability of `share` in 256.
    pub(super) fn tear(&mut self, range: std::ops::Range<usize>, share: u8) {
        for at in range {
            let drawn = self.random.next_u64().to_le_bytes();
            for (bit, drawn) in drawn.iter().enumerate() {
                self.bytes[at] |= u8::from(*drawn < share) << bit;
            }
        }
    }

    /// Poisons each word of a range with a probability of `share` in 256.
    pub(super) fn poison(&mut self, range: std::ops::Range<usize>, share: u64) {
        for word in range.start / WORD..range.end.div_ceil(WORD) {
            self.poisoned[word] |= self.random.next_u64() % 256 < share;
        }
    }

    /// Puts whole words where they are, as a cut-off erase may leave them.
    pub(super) fn put(&mut self, at: usize, bytes: &[u8]) {
        self.bytes[at..at + bytes.len()].copy_from_slice(bytes);
        for word in at / WORD..(at + bytes.len()).div_ceil(WORD) {
            self.programmed[word] = true;
        }
    }

    /// Counts an operation; true when the power fails in it.
    fn fails(&mut self) -> Result<bool, FlashError> {
        self.operations += 1;
        match self.cut_at {
            Some(cut) if self.operations > cut => Err(FlashError::PowerCut),
            Some(cut) => Ok(self.operations == cut),
            None => Ok(false),
        }
    }

    fn program(&mut self, word: usize, bytes: &[u8]) -> Result<(), FlashError> {
        let fails = self.fails()?;
        if self.programmed[word] || self.poisoned[word] {
            return Err(FlashError::Rewritten((word * WORD) as u32));
        }
        self.programmed[word] = true;
        for (at, byte) in bytes.iter().enumerate() {
            // Torn: every bit that was to become 0 has or has not.
            let missing = if fails {
                self.random.next_u64() as u8
            } else {
                0
            };
            self.bytes[word * WORD + at] &= byte | missing;
        }
        if fails {
            self.torn_words += 1;
            self.poisoned[word] = true;
            Err(FlashError::PowerCut)
        } else {
            Ok(())
        }
    }

    fn erase(&mut self, sector: usize, size: usize) -> Result<(), FlashError> {
        let fails = self.fails()?;
        self.erases[sector] += 1;
        let words = sector * size / WORD..(sector + 1) * size / WORD;
        let middle = words.start + self.random.next_u64() as usize % words.len();
        let torn = if fails {
            Some(self.random.next_u64() % 5)
        } else {
            None
        };
        for word in words.clone() {
            // Torn: nothing yet, all, the beginning, the end, or any bit.
            let erased = match torn {
                None | Some(1) => true,
                Some(2) => word < middle,
                Some(3) => word >= middle,
                _ => false,
            };
            for at in word * WORD..(word + 1) * WORD {
                let any = if torn == Some(4) {
                    self.random.next_u64() as u8
                } else {
                    0
                };
                self.bytes[at] |= if erased { 0xFF } else { any };
            }
            self.programmed[word] &= !erased;
        }
        if fails {
            self.torn_sectors += 1;
            // All of its words, half of them, or few: an erase that has hardly begun or is nearly
            // done leaves most check bits fitting.
            let share = [256, 256, 128, 2][self.random.next_u64() as usize % 4];
            self.poison(words.start * WORD..words.end * WORD, share);
        } else {
            self.poisoned[words].fill(false);
        }
        if fails {
            Err(FlashError::PowerCut)
        } else {
            Ok(())
        }
    }
}

impl<const SECTOR: usize> ErrorType for MockFlash<SECTOR> {
    type Error = FlashError;
}

impl<const SECTOR: usize> ReadNorFlash for MockFlash<SECTOR> {
    const READ_SIZE: usize = 1;

    async fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), FlashError> {
        let mut cells = self.0.borrow_mut();
        let range = offset as usize..offset as usize + bytes.len();
        let found = cells.bytes.get(range.clone()).ok_or(FlashError::Range)?;
        bytes.copy_from_slice(found);
        let mut words = range.start / WORD..range.end.div_ceil(WORD);
        if let Some(word) = words.find(|word| cells.poisoned[*word]) {
            cells.poisoned_reads += 1;
            return Err(FlashError::Poisoned((word * WORD) as u32));
        }
        Ok(())
    }

    fn capacity(&self) -> usize {
        self.0.borrow().bytes.len()
    }
}

impl<const SECTOR: usize> CheckedFlash for MockFlash<SECTOR> {
    fn is_poisoned(error: &FlashError) -> bool {
        matches!(error, FlashError::Poisoned(_))
    }
}

impl<const SECTOR: usize> NorFlash for MockFlash<SECTOR> {
    const WRITE_SIZE: usize = WORD;
    const ERASE_SIZE: usize = SECTOR;

    async fn erase(&mut self, from: u32, to: u32) -> Result<(), FlashError> {
        let (from, to) = (from as usize, to as usize);
        if !from.is_multiple_of(SECTOR) || !to.is_multiple_of(SECTOR) {
            return Err(FlashError::Alignment);
        }
        let mut cells = self.0.borrow_mut();
        (from / SECTOR..to / SECTOR).try_for_each(|sector| cells.erase(sector, SECTOR))
    }

    async fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), FlashError> {
        let offset = offset as usize;
        if !offset.is_multiple_of(WORD) || !bytes.len().is_multiple_of(WORD) {
            return Err(FlashError::Alignment);
        }
        let mut cells = self.0.borrow_mut();
        for (number, word) in bytes.chunks(WORD).enumerate() {
            cells.program(offset / WORD + number, word)?;
        }
        Ok(())
    }
}
