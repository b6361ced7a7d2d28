//! Firmware in the loop: the shipping image on the emulated board, asked by the
//! host tool's own client, judged by the twin's oracle.
//!
//! Everything but [`live`] runs in virtual time on one thread, so a scenario gives
//! the same result on every machine.

pub mod boardless;
pub mod browser;
pub mod capture;
pub mod coverage;
pub mod front_end;
pub mod hostile;
pub mod judge;
pub mod keyboard;
pub mod live;
#[cfg(test)]
mod lone;
pub mod reality;
pub mod rigged;
pub mod self_check;
pub mod served;
pub mod siege;
pub mod supply;
pub mod turns;
pub mod two_slots;
pub mod witness;
