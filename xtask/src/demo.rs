//! The demo: one command from a clean clone to a certificate.

use crate::shell::{cargo, target_dir};
use crate::{elf, shell};
use anyhow::Result;
use std::path::PathBuf;
use std::process::Command;

/// Builds the host tool, with the features the whole workspace asks of shared crates: what the
/// demo compiles, tests and benches need not compile again.
pub(crate) fn build_tool() -> Result<()> {
    eprintln!("building the host tool ...");
    shell::run(cargo("build").args(["--release", "--workspace", "--bin", "calib"]))
}

/// Where the host tool lies once it is built.
pub(crate) fn tool() -> PathBuf {
    target_dir().join("release").join("calib")
}

/// Builds image and tool, and returns the path of the image.
pub(crate) fn build_all() -> Result<PathBuf> {
    shell::beside(elf::build, build_tool)
}

/// Builds what is needed and runs `calib demo`.
pub(crate) fn run(arguments: &[String]) -> Result<()> {
    let image = build_all()?;
    let mut command = Command::new(tool());
    command
        .current_dir(shell::root())
        .env("CALIB_FIRMWARE_ELF", image);
    command.arg("demo").args(arguments);
    shell::run(&mut command)
}
