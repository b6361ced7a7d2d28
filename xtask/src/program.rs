//! The image onto a board, through its ST-LINK, by probe-rs.
//!
//! Download, then reset, and gone. `probe-rs run` would stay attached and catch faults: the core halts
//! before its handler has silenced the exciter, which timer and DMA go on driving until the watchdog.

use crate::{elf, shell};
use anyhow::{Context, Result};
use std::process::Command;

const CHIP: [&str; 2] = ["--chip", "STM32H743ZITx"];

/// Builds the image of a board and puts it on the board that is plugged in.
pub(crate) fn run(board: Option<&str>) -> Result<()> {
    probe_rs("--version", &[])?;
    let image = elf::build_for(board)?;
    let image = image.to_str().context("a path without UTF-8")?;
    probe_rs("download", &[CHIP[0], CHIP[1], image])?;
    probe_rs("reset", &CHIP)
}

fn probe_rs(what: &str, arguments: &[&str]) -> Result<()> {
    let mut command = Command::new("probe-rs");
    let ran = shell::run(command.arg(what).args(arguments));
    ran.context(
        "`cargo install probe-rs-tools` installs probe-rs; the board's ST-LINK must be plugged in",
    )
}
