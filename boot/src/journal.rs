//! Which slot starts: a journal of flash words, each programmed once.
//!
//! | word | written by | says |
//! |---|---|---|
//! | `Try` | the firmware, at the end of an update | a slot holds a new image |
//! | `Start` | the loader, before it starts that image | one more start of a new image |
//! | `Confirm` | the firmware, when a host has spoken to it | this slot is good |
//!
//! A word is 16 bytes and their complement. Programming only clears bits, so no word that was cut reads as
//! another; and most of those cannot be read at all. Words that are none of these are passed over.

use crate::BootFlash;
use crate::layout::{JOURNAL, SECTOR, Slot, WORD};

/// Starts of a new image without a confirmation, after which the old one starts.
pub const TRIES: u8 = 3;
/// Words of the journal.
pub const WORDS: u32 = SECTOR / WORD as u32;
/// Words one update takes at most, with as many that were cut.
const WORDS_OF_AN_UPDATE: u32 = 16;
/// How often an entry is written before it is given up: one word may be worn or was cut unseen.
const ATTEMPTS: u32 = 4;

const MAGIC: &[u8; 4] = b"boot";
const ERASED: [u8; WORD] = [0xFF; WORD];

/// A word of the journal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entry {
    /// The slot holds a new image, which is to be tried.
    Try(Slot),
    /// The new image of the slot is about to be started.
    Start(Slot),
    /// The image of the slot is good.
    Confirm(Slot),
}

impl Entry {
    fn to_word(self) -> [u8; WORD] {
        let (kind, slot) = match self {
            Self::Try(slot) => (1, slot),
            Self::Start(slot) => (2, slot),
            Self::Confirm(slot) => (3, slot),
        };
        let [a, b, c, d] = *MAGIC;
        let content = [a, b, c, d, kind, slot as u8, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
        let mut all = content
            .iter()
            .copied()
            .chain(content.iter().map(|byte| !byte));
        core::array::from_fn(|_| all.next().unwrap_or(0))
    }

    fn of_word(word: &[u8; WORD]) -> Option<Self> {
        let &[_, _, _, _, kind, slot, ..] = word;
        let slot = Slot::of(slot)?;
        let entry = match kind {
            1 => Self::Try(slot),
            2 => Self::Start(slot),
            3 => Self::Confirm(slot),
            _ => return None,
        };
        (entry.to_word() == *word).then_some(entry)
    }
}

/// A new image, and how often it was started.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Trial {
    /// Where it is.
    pub slot: Slot,
    /// Starts so far.
    pub starts: u8,
}

/// State by the journal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Journal {
    /// The slot that was confirmed last.
    pub confirmed: Option<Slot>,
    /// A new image that was not confirmed.
    pub trial: Option<Trial>,
    /// Words up to the last that is not erased.
    used: u32,
}

impl Journal {
    /// Reads it.
    pub fn read(flash: &mut impl BootFlash) -> Self {
        let mut journal = Self::default();
        for nth in 0..WORDS {
            let word = flash.read(address(nth));
            if word == Some(ERASED) {
                continue;
            }
            journal.used = nth + 1;
            if let Some(entry) = word.and_then(|word| Entry::of_word(&word)) {
                journal.take(entry);
            }
        }
        journal
    }

    /// Writes an entry, and again behind it where it cannot be read back; whether it is there.
    pub fn note(&mut self, flash: &mut impl BootFlash, entry: Entry) -> bool {
        let word = entry.to_word();
        for _ in 0..ATTEMPTS {
            if self.used >= WORDS {
                return false;
            }
            let at = address(self.used);
            self.used += 1;
            // What counts is what the next start reads.
            let _ = flash.write(at, &word);
            if flash.read(at) == Some(word) {
                self.take(entry);
                return true;
            }
        }
        false
    }

    /// Whether there is no room for another update.
    pub fn is_full(&self) -> bool {
        self.used + WORDS_OF_AN_UPDATE > WORDS
    }

    /// Whether the image of this slot is on trial.
    pub fn is_on_trial(&self, slot: Slot) -> bool {
        self.trial.is_some_and(|trial| trial.slot == slot)
    }

    fn take(&mut self, entry: Entry) {
        match entry {
            Entry::Try(slot) => self.trial = Some(Trial { slot, starts: 0 }),
            Entry::Start(slot) => {
                let starts = self.trial.map_or(0, |trial| trial.starts);
                let starts = starts.saturating_add(1);
                self.trial = Some(Trial { slot, starts });
            }
            Entry::Confirm(slot) => {
                self.confirmed = Some(slot);
                self.trial = None;
            }
        }
    }
}

fn address(nth: u32) -> u32 {
    JOURNAL + nth * WORD as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;

    #[test]
    fn it_says_what_was_noted() {
        let mut flash = Model::erased();
        let mut journal = Journal::read(&mut flash);
        assert_eq!(journal, Journal::default());
        for entry in [
            Entry::Try(Slot::B),
            Entry::Start(Slot::B),
            Entry::Start(Slot::B),
        ] {
            assert!(journal.note(&mut flash, entry));
        }
        let trial = Trial {
            slot: Slot::B,
            starts: 2,
        };
        assert_eq!(journal.trial, Some(trial));
        assert_eq!(Journal::read(&mut flash), journal);
        assert!(journal.note(&mut flash, Entry::Confirm(Slot::B)));
        assert_eq!((journal.confirmed, journal.trial), (Some(Slot::B), None));
        assert_eq!(Journal::read(&mut flash), journal);
    }

    /// Programming only clears bits: whatever subset of them a cut leaves, it is the entry or none.
    #[test]
    fn no_cut_makes_another_entry() {
        let entries = [Entry::Try, Entry::Start, Entry::Confirm];
        let entries = entries.into_iter().flat_map(|of| Slot::ALL.map(of));
        for entry in entries {
            let word = entry.to_word();
            for bit in 0..WORD * 8 {
                let mut torn = word;
                // One bit not yet cleared, where it was to be.
                torn[bit / 8] |= 1 << (bit % 8);
                if torn != word {
                    assert_eq!(Entry::of_word(&torn), None, "{entry:?}, bit {bit}");
                }
            }
        }
    }

    #[test]
    fn words_that_cannot_be_read_are_passed_over() {
        let mut flash = Model::erased();
        let mut journal = Journal::read(&mut flash);
        assert!(journal.note(&mut flash, Entry::Confirm(Slot::B)));
        flash.poison(address(1));
        let mut journal = Journal::read(&mut flash);
        assert_eq!(journal.confirmed, Some(Slot::B));
        assert!(journal.note(&mut flash, Entry::Try(Slot::A)));
        assert!(Journal::read(&mut flash).is_on_trial(Slot::A));
    }

    #[test]
    fn a_full_journal_takes_nothing() {
        let mut flash = Model::erased();
        let mut journal = Journal::read(&mut flash);
        for _ in 0..WORDS {
            assert!(journal.note(&mut flash, Entry::Start(Slot::A)));
        }
        assert!(journal.is_full() && !journal.note(&mut flash, Entry::Confirm(Slot::A)));
    }
}
