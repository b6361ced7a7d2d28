//! The image onto a board, through its ST-LINK, by probe-rs.
//!
//! Download, then reset, and gone. `probe-rs run` would stay attached and catch faults: the core halts
//! before its handler has silenced the exciter, which timer and DMA go on driving until the watchdog.

use crate::option_writes::{CURRENT, is_set, writes};
use crate::{elf, shell};
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

const CHIP: [&str; 2] = ["--chip", "STM32H743ZITx"];
/// Option bytes are written in less than this: the data sheet has no figure, a sector takes 2.2 s.
const OPTIONS_WRITTEN: Duration = Duration::from_secs(3);

/// Builds the image of a board and puts it on the board that is plugged in. Says so if its brown-out
/// level is not set.
pub(crate) fn run(board: Option<&str>) -> Result<()> {
    probe_rs("--version", &[])?;
    let image = elf::build_for(board)?;
    download(&image)?;
    if !is_set(option_bytes()?) {
        eprintln!(
            "its brown-out reset is not at level 3: `./run brown-out` sets it, once for each board"
        );
    }
    Ok(())
}

/// The run of tests on the board that is plugged in: it ends with their result.
pub(crate) fn tests(image: &Path) -> Command {
    let mut command = Command::new("probe-rs");
    command.arg("run").args(CHIP).arg(image);
    command
}

/// Puts an image on the board that is plugged in, and starts it.
fn download(image: &Path) -> Result<()> {
    let image = image.to_str().context("a path without UTF-8")?;
    probe_rs("download", &[CHIP[0], CHIP[1], image])?;
    probe_rs("reset", &CHIP)
}

/// Puts a loader on the board that is plugged in, and what it is to start at these addresses.
pub(crate) fn commission(loader: &Path, parts: &[(PathBuf, u32)]) -> Result<()> {
    probe_rs("--version", &[])?;
    for (part, address) in parts {
        let (part, address) = (part.to_str(), format!("{address:#x}"));
        let part = part.context("a path without UTF-8")?;
        let place = ["--binary-format", "bin", "--base-address", &address];
        probe_rs("download", &[&CHIP[..], &place[..], &[part]].concat())?;
    }
    download(loader)
}

/// Gives the board that is plugged in its brown-out level, if it has another.
pub(crate) fn brown_out() -> Result<()> {
    probe_rs("--version", &[])?;
    let before = option_bytes()?;
    if is_set(before) {
        println!("brown-out level 3 is set: option bytes {before:#010x}");
        return Ok(());
    }
    for (address, word) in writes(before) {
        write_word(address, word)?;
    }
    std::thread::sleep(OPTIONS_WRITTEN);
    probe_rs("reset", &CHIP)?;
    let after = option_bytes()?;
    if !is_set(after) {
        bail!(
            "the option bytes are {after:#010x} still: use STM32CubeProgrammer (docs/hardware.md, Brown-out level)"
        );
    }
    println!("brown-out level 3 is set: option bytes {before:#010x}, now {after:#010x}");
    Ok(())
}

fn option_bytes() -> Result<u32> {
    let address = format!("{CURRENT:#x}");
    let read = Command::new("probe-rs")
        .args(["read", CHIP[0], CHIP[1], "b32", &address, "1"])
        .stderr(Stdio::inherit())
        .output()
        .context("cannot start probe-rs")?;
    let text = String::from_utf8_lossy(&read.stdout);
    u32::from_str_radix(text.trim(), 16)
        .with_context(|| format!("probe-rs read no option bytes, but `{}`", text.trim()))
}

fn write_word(address: u32, word: u32) -> Result<()> {
    let (address, word) = (format!("{address:#x}"), format!("{word:#x}"));
    probe_rs("write", &[CHIP[0], CHIP[1], "b32", &address, &word])
}

fn probe_rs(what: &str, arguments: &[&str]) -> Result<()> {
    let mut command = Command::new("probe-rs");
    let ran = shell::run(command.arg(what).args(arguments));
    ran.context(
        "`cargo install probe-rs-tools` installs probe-rs; the board's ST-LINK must be plugged in",
    )
}
