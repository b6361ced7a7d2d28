//! A certificate of the reference read as it was given out: a digital calibration certificate, or a CSV with U at
//! each frequency.
//!
//! | file | idea |
//! |---|---|
//! | `certified` | what one states, checked, and as the settings hold it |
//! | `dcc` | PTB's DCC 3.x: whose it is, and its lists |
//! | `dsi` | units of D-SI as factors and exponents |
//! | `table` | CSV with a column each, and remarks that say whose it is |
//! | `compare` | beside what is in force |
//!
//! Nothing is guessed: what has no unit, no U, no coverage factor or no place in the order is named with its line.

mod certified;
mod compare;
mod dcc;
mod dsi;
mod table;

pub use certified::{Certified, CertifiedPoint, Reading};
pub use compare::{Compared, compare};

use crate::input::Source;
use calib_files::Result;
use std::path::Path;

/// Reads a certificate; what begins with `<` is a DCC.
///
/// # Errors
/// [`Error::Input`] with file and line: malformed, more than one object, a unit, U or coverage factor that is
/// missing or cannot be, frequencies that do not rise.
pub fn read(path: &Path, reading: &Reading) -> Result<Certified> {
    let source = Source::read(path)?;
    match source.text.trim_start().starts_with('<') {
        true => dcc::read(&source, reading),
        false => table::read(source, reading),
    }
}

#[cfg(test)]
mod tests;
