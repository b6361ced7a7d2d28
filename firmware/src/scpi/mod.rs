//! A small SCPI: the calibrator as other instruments are spoken to.
//!
//! Lines of ASCII ended by LF, as on every serial instrument; docs/scpi.md lists the commands. One point at a
//! time: configure, initiate, wait, fetch, or all of it in one question. Lists, settings and records are the
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

/// Longest line, in bytes.
const MAX_LINE: usize = 256;
