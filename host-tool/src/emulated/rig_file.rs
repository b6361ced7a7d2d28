//! Rig files of the emulated calibrator, with complaints as those of all other files.

use calib_files::{Error, Result, text};
use calib_twin::rig::{Rig, RigError};
use std::path::Path;

const HINT: &str = "twin/rigs/default.toml in the source tree holds every value";

/// Reads a rig file.
///
/// # Errors
/// [`Error::File`]; [`Error::Input`] with line or key.
pub fn load(path: &Path) -> Result<Rig> {
    parse(path, &text::read(path)?)
}

/// Reads a rig from `text`, the content of `path`.
///
/// # Errors
/// [`Error::Input`] with line or key.
pub fn parse(path: &Path, text: &str) -> Result<Rig> {
    let file = path.display().to_string();
    Rig::parse(text, &file).map_err(|error| match error {
        RigError::Malformed { source, .. } => text::malformed(path, text, &source, HINT),
        RigError::OutOfRange {
            parameter,
            value,
            range,
            ..
        } => Error::input(file, format!("{parameter} = {value} must be {range}"), HINT),
        other => Error::input(file, other.to_string(), HINT),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_twin::rig::STANDARD_RIG_TOML;

    #[test]
    fn a_complaint_names_the_file_once_and_the_place() {
        let twice = format!("{STANDARD_RIG_TOML}\n[exciter]\n");
        let line = format!("r.toml:{}: ", twice.lines().count());
        let heavy = STANDARD_RIG_TOML.replacen("moving_mass_kg = ", "moving_mass_kg = -", 1);
        for (text, begins) in [
            (twice.as_str(), line.as_str()),
            (&heavy, "r.toml: exciter.moving_mass_kg = -"),
            ("", "r.toml:1: "),
        ] {
            let error = parse(Path::new("r.toml"), text).expect_err(begins);
            let message = error.to_string();
            assert!(message.starts_with(begins), "{message}");
            assert_eq!(message.matches("r.toml").count(), 1, "{message}");
        }
    }
}
