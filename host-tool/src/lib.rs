//! The program `calib` as a library: verbs are thin, and tests reach what is below them.
//!
//! Every verb is one file of `src/cli/`; other programs have it answered by [`cli::answer`]. Errors name the
//! way out ([`Error`]).
#![forbid(unsafe_code)]

// Verbs name what is below them as a program of its own would.
extern crate self as calib_host;

pub mod about_sensor;
pub mod amendment;
pub mod assurance;
pub mod assurance_report;
pub mod cli;
pub mod clock;
pub mod config;
pub mod demo;
mod device;
pub mod doctor;
pub mod emulated;
mod error;
pub mod gap;
pub mod in_unit;
pub mod issuing;
pub mod judged;
pub mod number;
pub mod refusals;
pub mod self_check;
pub mod serve;
pub mod terminal;

pub use device::Device;
pub use error::{Error, Result};
