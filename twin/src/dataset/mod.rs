//! Gap datasets of known cause: what a calibrator with effects would have measured.
//!
//! A dataset is a folder with `rig.toml` (what the simulation believes) and `points.csv` or
//! `record.csv` (what was measured). Nothing in it tells the cause. The measured side comes from
//! [`crate::steady`], which integrates the exciter in time.

mod calibrator;
mod design;
mod nominal;
mod observe;
mod point;
mod record;
mod truth;
mod unlocked;

use std::path::Path;

pub use self::calibrator::{Generated, Options, generate};
pub use self::design::{Setting, standard_design};
pub use self::nominal::{
    Digitiser, Environment, Exciter, Nominal, NominalError, Quantity, Repeatability, Transducer,
};
pub use self::observe::Uncertainties;
pub use self::point::{Columns, Harmonic, Point, points_csv};
pub use self::record::{NominalOscillator, Record, RecordOptions};

/// Writes a dataset of points to the folder `directory`, which is made if it does not exist.
///
/// # Errors
/// Error of the file system.
pub fn write(directory: &Path, nominal: &Nominal, points: &[Point]) -> std::io::Result<()> {
    std::fs::create_dir_all(directory)?;
    let rig = nominal.to_toml().map_err(std::io::Error::other)?;
    std::fs::write(directory.join("rig.toml"), rig)?;
    std::fs::write(directory.join("points.csv"), points_csv(points))
}

#[cfg(test)]
mod tests;
