//! The host side of the calibrator: link, sessions, records, certificates.
//!
//! The command line tool `calib` is a thin layer over this library; every verb
//! is one file of `src/cli/`. Errors name the way out ([`error::Error`]).
#![forbid(unsafe_code)]

mod address;
pub mod bench;
pub mod capture;
pub mod certificate;
pub mod chain;
pub mod decision;
pub mod demo;
pub mod doctor;
pub mod emulated;
pub mod error;
pub mod file;
pub mod gap;
pub mod link;
pub mod metrology;
pub mod serve;
pub mod session;
pub mod teds;
pub mod terminal;
pub mod text_file;
pub mod verdict_text;

pub use address::Address;
pub use error::{Error, Result};
