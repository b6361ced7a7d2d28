//! The front end of `hardware/`, as ngspice computes it.
//!
//! Netlists and bill of materials are in that folder; here they are run, read and judged. The
//! twin's filters are Butterworth formulas; that the circuit is the same to its stated tolerance is
//! a test of this module.

pub mod images;
pub mod ngspice;
pub mod response;
pub mod spread;

#[cfg(test)]
mod bill;
#[cfg(test)]
mod tests;

use std::path::PathBuf;

/// The folder of netlists, bill of materials and response.
pub fn folder() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../hardware"))
}
