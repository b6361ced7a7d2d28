//! A small SCPI: the calibrator as other instruments are spoken to.
//!
//! Lines of ASCII ended by LF, as on every serial instrument; docs/scpi.md lists the commands. Configure a point or
//! a list, initiate, wait, fetch, or all of it in one question; records are read as blocks of bytes. Settings are the
//! business of the binary protocol on the same link.
//!
//! # Source
//! Command set and number forms of SCPI-99 and IEEE 488.2 as instruments of many
//! makers document them; the texts of the standards were not at hand.

mod console;
mod errors;
mod header;
mod inquiry;
mod lists;
mod measurement;
mod number;
mod session;
#[cfg(test)]
mod tests;

pub use console::Console;
pub use errors::ScpiError;
pub use session::{Answer, Session};

/// Where answers go: text, and bytes of a block.
pub trait Answering: core::fmt::Write {
    /// Writes bytes as they are.
    ///
    /// # Errors
    /// When there is no room for all of them; none is written then.
    fn write_bytes(&mut self, bytes: &[u8]) -> core::fmt::Result;
    /// Bytes there is still room for, beside the end of the line.
    fn room(&self) -> usize;
}

/// Longest line, in bytes.
const MAX_LINE: usize = 256;
