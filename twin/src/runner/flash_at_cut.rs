//! The flash as a cut of the supply would leave it, taken from a board that goes on.

use rigless::emulator::{Error as EmulatorError, Host};

use super::memory::BANK_BYTES;
use super::{Emulator, Error, Torn, memory, torn};
use crate::board::{CODE_FLASH, CheckBits, CutOff, RECORD_FLASH};

/// Bytes a flash is compared by, and put back by.
const PIECE: usize = 8;

/// Content of the flash, its words that cannot be read, and the operation a cut of the supply at
/// that instant tears: all that such a cut leaves of a board. Test `a_flash_at_a_cut_is_what_the_cut_leaves`.
#[derive(Debug, Clone)]
pub struct FlashAtCut {
    /// Of the bank the code is in.
    code: Vec<u8>,
    /// Of the record flash.
    content: Vec<u8>,
    check_bits: CheckBits,
    cut: Option<CutOff>,
}

impl FlashAtCut {
    /// Damage the cut does.
    #[must_use]
    pub fn torn(&self) -> Torn {
        self.cut.into()
    }
}

impl Emulator {
    /// The flash as the supply would leave it if it failed now. The board goes on.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn flash_at_cut(&mut self) -> Result<FlashAtCut, Error> {
        let content = self.record_flash()?;
        let code = self.read_memory(CODE_FLASH, BANK_BYTES)?;
        let check_bits = self.pins.flash.check_bits();
        let cut = self
            .core
            .act(|session, _, stop| session.board().part.flash_under_way(stop.at))?;
        Ok(FlashAtCut {
            code,
            content,
            check_bits,
            cut,
        })
    }

    /// Puts the flash of another board's cut into this one, which has no power: it comes up as the other
    /// would have.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn fit_flash(&mut self, flash: &FlashAtCut) -> Result<(), Error> {
        let (code, content, cut) = (flash.code.clone(), flash.content.clone(), flash.cut);
        let watch = self.pins.flash.clone();
        watch.set_check_bits(flash.check_bits.clone());
        self.core
            .act(move |_, host, _| {
                replace(host, CODE_FLASH, &code)?;
                replace(host, RECORD_FLASH, &content)?;
                cut.map_or(Ok(()), |cut| torn::leave(host, &watch, cut))
            })?
            .map_err(|error| Error::Ended(error.to_string()))
    }
}

/// Makes the flash from `first` on what `content` says, where it is not.
fn replace(host: &mut dyn Host, first: u64, content: &[u8]) -> Result<(), EmulatorError> {
    let before = memory::read(host, first, content.len())?;
    let pieces = before.chunks(PIECE).zip(content.chunks(PIECE));
    for (address, (old, new)) in (first..).step_by(PIECE).zip(pieces) {
        if old != new {
            memory::program(host, address, new)?;
        }
    }
    Ok(())
}
