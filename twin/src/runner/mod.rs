//! Runs a firmware image on the emulated board.
//!
//! - [`Firmware`]: the image file.
//! - [`Emulator`]: a board with power, driven step by step in virtual time: deterministic, the same
//!   calls give the same run.
//! - [`run_paced`]: the same board at the pace of the wall, with [`Door`]s for programs in other
//!   processes: a TCP port ([`TcpDoor`]) and, where there are any, a pseudo terminal (`PtyDoor`).
//! - [`Execution`]: fast, or plainly: the same run either way.
//! - [`FlashAtCut`]: what a cut of the supply would leave, for another board to start with.
//! - [`Mark`], [`Passages`]: how many instructions a program takes from here to there.
//! - [`Log`]: what the firmware logs over RTT.

mod core_thread;
mod emulator;
mod error;
mod execution;
mod firmware;
mod flash_at_cut;
mod keep;
mod log;
mod memory;
mod paced;
mod passages;
mod power;
#[cfg(unix)]
mod pty_door;
mod tcp_door;
mod torn;

pub use emulator::{Emulator, Gap, SharedEmulator};
pub use error::Error;
pub use execution::Execution;
pub use firmware::Firmware;
pub use flash_at_cut::FlashAtCut;
pub use log::Log;
pub use paced::{Door, HostLine, Pace, run_paced};
pub use passages::{Mark, Passages};
#[cfg(unix)]
pub use pty_door::PtyDoor;
pub use tcp_door::TcpDoor;
pub use torn::Torn;
