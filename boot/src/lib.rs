//! Start of an image: two slots, the proof that an image is whole and whose it is, and which slot
//! is tried.
//!
//! | who | uses |
//! |---|---|
//! | the loader (`boot/loader`) | [`choice::choose`] |
//! | the firmware | [`updater::Updater`], [`journal::Journal`] |
//! | the host tool and the build | [`file`], [`manifest::sign`] |
//!
//! ```text
//! sector 0        loader, with the public key it trusts
//! sectors 1 to 3  slot A: image, and its manifest in the last 256 bytes
//! sectors 4 to 6  slot B: the same, linked for there
//! sector 7        journal: trials, starts and confirmations, a flash word each
//! ```
//!
//! The image that runs is never touched: an update goes to the other slot, is tried, and the old one
//! starts again unless the new one is confirmed.
//!
//! All that is read may have been torn by a supply that failed, so it is read by [`BootFlash::read`] alone.
#![cfg_attr(not(test), no_std)]

pub mod choice;
pub mod file;
pub mod journal;
pub mod layout;
pub mod manifest;
#[cfg(target_os = "none")]
pub mod part;
pub mod trusted;
pub mod updater;

#[cfg(test)]
mod model;

use layout::WORD;

/// Flash of the part as far as starting needs it. Addresses are multiples of [`WORD`].
pub trait BootFlash {
    /// The word at an address; none where its check bits do not fit. Never faults.
    fn read(&mut self, address: u32) -> Option<[u8; WORD]>;

    /// Programs a word that is erased; whether the flash says that it did.
    fn write(&mut self, address: u32, word: &[u8; WORD]) -> bool;
}

/// Flash whose sectors can be erased.
pub trait SlotFlash: BootFlash {
    /// Erases the sector that begins at an address; whether the flash says that it did.
    fn erase(&mut self, sector: u32) -> bool;
}
