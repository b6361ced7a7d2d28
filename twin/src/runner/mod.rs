//! Runs a firmware image on the emulated board.
//!
//! - [`Firmware`]: the image file.
//! - [`Emulator`]: a board with power, driven step by step in virtual time: deterministic, the same
//!   calls give the same run.
//! - [`VirtualSerial`]: the serial line as `Read` and `Write` with time-outs in virtual time, so that
//!   host software runs against the board in one process.
//! - [`Log`]: what the firmware logs over RTT.

mod core_thread;
mod emulator;
mod error;
mod firmware;
mod log;
mod memory;
mod serial;

pub use emulator::{Emulator, Gap};
pub use error::Error;
pub use firmware::Firmware;
pub use log::Log;
pub use serial::{SharedEmulator, VirtualSerial};
