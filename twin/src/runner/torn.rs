//! State of the flash after an operation on it was cut.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rigless::emulator::{Error, Host};

use super::memory;
use crate::board::{
    CutOff, FlashWatch, Operation, SECTOR_BYTES, WORD_BYTES, torn_sector, torn_word,
};

/// Share of a sector's words whose check bits do not fit when its erase was cut, in 256, drawn from
/// these: all, half, or few, as of an erase that has hardly begun or is nearly done.
const POISONED: [u64; 4] = [256, 256, 128, 2];

/// State of the flash after a power cut or a reset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Torn {
    /// No operation was under way.
    Nothing,
    /// A word was half programmed.
    Word {
        /// Its address.
        address: u64,
        /// How far its programming was, from 0 to 1.
        progress: f64,
    },
    /// A sector was half erased.
    Sector {
        /// Its address.
        address: u64,
        /// How far its erase was, from 0 to 1.
        progress: f64,
    },
}

impl From<Option<CutOff>> for Torn {
    fn from(cut: Option<CutOff>) -> Self {
        let Some(CutOff {
            operation,
            progress,
            ..
        }) = cut
        else {
            return Self::Nothing;
        };
        match operation {
            Operation::Program { address, .. } => Self::Word { address, progress },
            Operation::Erase { address } => Self::Sector { address, progress },
        }
    }
}

/// Leaves in flash what an operation has done so far, with check bits that do not fit.
pub(super) fn leave(host: &mut dyn Host, flash: &FlashWatch, cut: CutOff) -> Result<(), Error> {
    let address = cut.operation.address();
    let mut random = ChaCha8Rng::seed_from_u64(cut.at.0 ^ address);
    match cut.operation {
        Operation::Program { data, .. } => {
            let mut old = [0; WORD_BYTES];
            old.copy_from_slice(&memory::read(host, address, WORD_BYTES)?);
            let torn = torn_word(old, data, cut.progress, || random.next_u64());
            memory::program(host, address, &torn)?;
            flash.poison([address]);
        }
        Operation::Erase { .. } => {
            let mut sector = memory::read(host, address, SECTOR_BYTES as usize)?;
            torn_sector(&mut sector, cut.progress, || random.next_u64());
            memory::program(host, address, &sector)?;
            let share = POISONED[random.next_u64() as usize % POISONED.len()];
            let words = (address..address + SECTOR_BYTES).step_by(WORD_BYTES);
            flash.poison(words.filter(|_| random.next_u64() % 256 < share));
        }
    }
    Ok(())
}
