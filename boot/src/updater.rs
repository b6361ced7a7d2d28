//! An update as the firmware carries it out: into the slot it does not run from.
//!
//! | step | flash | a cut leaves |
//! |---|---|---|
//! | begin | nothing; with a full journal: the other slot's last sector and the journal erased, the running slot confirmed | the running image, the only one that is whole |
//! | blocks | a sector erased as the first block of it comes, words | the running image: the other is not whole |
//! | finish | what is left to erase, the manifest, `Try` in the journal | the running image until `Try` is there, then either |
//! | confirm | `Confirm` in the journal | a trial that goes on |

use crate::SlotFlash;
use crate::journal::{Entry, Journal};
use crate::layout::{JOURNAL, MANIFEST_BYTES, SECTOR, SLOT_SECTORS, Slot, WORD};
use crate::manifest::{self, Manifest, ManifestError, PublicKey, Version};

/// Bytes of an image in one block.
pub const BLOCK_BYTES: usize = 1024;

/// Running firmware with which an update is compared.
#[derive(Clone, Copy, Debug)]
pub struct Running<'a> {
    /// Slot the firmware runs from.
    pub slot: Slot,
    /// Its version.
    pub version: Version,
    /// Name of its board.
    pub board: &'a str,
    /// The key its loader trusts.
    pub trusted: PublicKey,
}

/// Why an update is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpdateError {
    /// No manifest, or not signed with the trusted key.
    Signature,
    /// For another board, or linked for the slot that runs.
    NotForHere,
    /// Older than what runs, and nobody allowed that.
    Older,
    /// The running image was not confirmed: the other slot holds the one it may fall back to.
    Unconfirmed,
    /// No update was begun, or this block is not the next.
    Order,
    /// The image is not the one the manifest describes.
    Damaged,
    /// The flash did not do it.
    Flash,
}

impl From<ManifestError> for UpdateError {
    fn from(_: ManifestError) -> Self {
        Self::Signature
    }
}

/// An update under way, or none. All zero when there is none.
#[derive(Clone, Debug)]
pub struct Updater {
    manifest: [u8; MANIFEST_BYTES],
    /// Length of the image; 0 = no update was begun.
    length: u32,
    target: Slot,
    written: u32,
    erased: u32,
}

impl Default for Updater {
    fn default() -> Self {
        Self::NONE
    }
}

impl Updater {
    /// No update.
    pub const NONE: Self = Self {
        manifest: [0; MANIFEST_BYTES],
        length: 0,
        target: Slot::A,
        written: 0,
        erased: 0,
    };

    /// Begins an update with this manifest; `older_allowed` where a hand on the instrument allows one that
    /// is older than what runs. What was begun before is forgotten.
    ///
    /// # Errors
    /// See [`UpdateError`].
    pub fn begin(
        &mut self,
        flash: &mut impl SlotFlash,
        running: &Running<'_>,
        manifest: &[u8; MANIFEST_BYTES],
        older_allowed: bool,
    ) -> Result<(), UpdateError> {
        self.length = 0;
        let told = Manifest::verify(manifest, &running.trusted)?;
        if told.slot == running.slot || !told.is_for(running.board) {
            return Err(UpdateError::NotForHere);
        }
        if told.version < running.version && !older_allowed {
            return Err(UpdateError::Older);
        }
        let journal = Journal::read(flash);
        if journal.is_on_trial(running.slot) {
            return Err(UpdateError::Unconfirmed);
        }
        if journal.is_full() {
            renew_journal(flash, running.slot)?;
        }
        *self = Self {
            manifest: *manifest,
            length: told.length,
            target: told.slot,
            written: 0,
            erased: 0,
        };
        Ok(())
    }

    /// Writes the next bytes of the image. A block that was written is not written again.
    ///
    /// # Errors
    /// See [`UpdateError`].
    pub fn block(
        &mut self,
        flash: &mut impl SlotFlash,
        offset: u32,
        data: &[u8],
    ) -> Result<(), UpdateError> {
        let end = offset.saturating_add(data.len() as u32);
        if self.length == 0 || data.is_empty() || end > self.length || offset > self.written {
            return Err(UpdateError::Order);
        }
        // Only the last block may end within a word.
        let whole_words = (data.len()).is_multiple_of(WORD) || end == self.length;
        if !(offset as usize).is_multiple_of(WORD) || !whole_words {
            return Err(UpdateError::Order);
        }
        if end <= self.written {
            return Ok(());
        }
        if offset != self.written {
            return Err(UpdateError::Order);
        }
        for (at, bytes) in (offset..).step_by(WORD).zip(data.chunks(WORD)) {
            self.erase_up_to(flash, at / SECTOR + 1)?;
            write(flash, self.target.start() + at, bytes)?;
            self.written = at + bytes.len() as u32;
        }
        Ok(())
    }

    /// Ends an update: the next start tries the new image.
    ///
    /// # Errors
    /// See [`UpdateError`]; then nothing of it is ever started.
    pub fn finish(&mut self, flash: &mut impl SlotFlash) -> Result<(), UpdateError> {
        if self.length == 0 || self.written != self.length {
            return Err(UpdateError::Order);
        }
        let length = core::mem::take(&mut self.length);
        let told = Manifest::parse(&self.manifest)?;
        if manifest::digest(flash, self.target, length) != Some(told.sha256) {
            return Err(UpdateError::Damaged);
        }
        self.erase_up_to(flash, SLOT_SECTORS)?;
        let at = self.target.manifest();
        for (at, bytes) in (at..).step_by(WORD).zip(self.manifest.chunks(WORD)) {
            write(flash, at, bytes)?;
        }
        let mut journal = Journal::read(flash);
        match journal.note(flash, Entry::Try(self.target)) {
            true => Ok(()),
            false => Err(UpdateError::Flash),
        }
    }

    /// Bytes that were written, and of how many.
    pub fn progress(&self) -> (u32, u32) {
        (self.written, self.length)
    }

    fn erase_up_to(&mut self, flash: &mut impl SlotFlash, sectors: u32) -> Result<(), UpdateError> {
        while self.erased < sectors {
            erase(flash, self.target.start() + self.erased * SECTOR)?;
            self.erased += 1;
        }
        Ok(())
    }
}

/// Says that the image in `slot` is good, once.
///
/// # Errors
/// [`UpdateError::Flash`]: the journal took no entry.
pub fn confirm(flash: &mut impl SlotFlash, slot: Slot) -> Result<(), UpdateError> {
    let mut journal = Journal::read(flash);
    let is_needed = journal.is_on_trial(slot);
    match !is_needed || journal.note(flash, Entry::Confirm(slot)) {
        true => Ok(()),
        false => Err(UpdateError::Flash),
    }
}

/// Empties the journal. The other slot goes first: with one image that is whole, a journal that says
/// nothing, or half of what it did, is none the less clear.
fn renew_journal(flash: &mut impl SlotFlash, running: Slot) -> Result<(), UpdateError> {
    erase(flash, running.other().start() + (SLOT_SECTORS - 1) * SECTOR)?;
    erase(flash, JOURNAL)?;
    match Journal::read(flash).note(flash, Entry::Confirm(running)) {
        true => Ok(()),
        false => Err(UpdateError::Flash),
    }
}

fn erase(flash: &mut impl SlotFlash, sector: u32) -> Result<(), UpdateError> {
    match flash.erase(sector) {
        true => Ok(()),
        false => Err(UpdateError::Flash),
    }
}

/// Writes up to a word, the rest of it as erased.
fn write(flash: &mut impl SlotFlash, at: u32, bytes: &[u8]) -> Result<(), UpdateError> {
    let mut word = [0xFF; WORD];
    let places = word.iter_mut().zip(bytes);
    places.for_each(|(place, byte)| *place = *byte);
    match flash.write(at, &word) {
        true => Ok(()),
        false => Err(UpdateError::Flash),
    }
}

#[cfg(test)]
mod tests;
