//! The firmware image: built once, tested and shipped as it is.

use crate::shell::{cargo, root, run, target_dir};
use anyhow::{Context, Result};
use std::path::{Path, PathBuf};
use std::process::Command;

const TARGET: &str = "thumbv7em-none-eabihf";
const PROFILE: &str = "firmware";
const PACKAGE: &str = "calib-firmware";

/// Builds the image and returns its path.
pub(crate) fn build() -> Result<PathBuf> {
    eprintln!("building the firmware image ...");
    build_package(PACKAGE)
}

/// Builds a program for the board as the image is built, and returns its path.
pub(crate) fn build_package(package: &str) -> Result<PathBuf> {
    let mut command = if std::env::var("CALIB_ELF_TOOLCHAIN").as_deref() == Ok("debian") {
        debian_cargo()
    } else {
        cargo("build")
    };
    command.args([
        "--package",
        package,
        "--profile",
        PROFILE,
        "--target",
        TARGET,
    ]);
    run(&mut command)?;
    Ok(path(package))
}

/// Where a program for the board lies once it is built.
fn path(package: &str) -> PathBuf {
    target_dir().join(TARGET).join(PROFILE).join(package)
}

/// Debian's compiler has no library for the board: it builds core from source
/// and links with LLVM's own linker.
fn debian_cargo() -> Command {
    let mut command = Command::new("/usr/bin/cargo");
    command
        .current_dir(root())
        .args(["build", "--ignore-rust-version", "-Zbuild-std=core"])
        .env_remove("RUSTUP_TOOLCHAIN")
        .env("RUSTC", "/usr/bin/rustc")
        .env("RUSTC_BOOTSTRAP", "1")
        .env("CARGO_TARGET_THUMBV7EM_NONE_EABIHF_LINKER", "ld.lld");
    command
}

/// Prints what the image takes of flash and RAM, section by section.
pub(crate) fn print_size() -> Result<()> {
    let path = build()?;
    let bytes = std::fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let [text, data, bss] = totals(&path)?;
    println!("text {text}, data {data}, bss {bss} bytes\n");
    println!("{:<18} {:>10} {:>12}", "section", "bytes", "address");
    for section in sections(&bytes).context("the image is no 32-bit little-endian ELF file")? {
        println!(
            "{:<18} {:>10} {:>#12x}",
            section.name, section.size, section.address
        );
    }
    Ok(())
}

/// Bytes of the image at `path` as text (flash alone), data (flash and RAM) and
/// bss (RAM alone).
pub(crate) fn totals(path: &Path) -> Result<[u32; 3]> {
    let bytes = std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    let mut totals = [0; 3];
    for section in sections(&bytes).context("the image is no 32-bit little-endian ELF file")? {
        let kind = match (section.writable, section.stored) {
            (false, _) => 0,
            (true, true) => 1,
            (true, false) => 2,
        };
        totals[kind] += section.size;
    }
    Ok(totals)
}

struct Section {
    name: String,
    address: u32,
    size: u32,
    writable: bool,
    /// Its content is part of the image.
    stored: bool,
}

/// Sections that take memory on the board (flag ALLOC).
fn sections(elf: &[u8]) -> Option<Vec<Section>> {
    const WRITE: u32 = 1;
    const ALLOC: u32 = 2;
    const NOBITS: u32 = 8;
    let word = |at: usize| Some(u32::from_le_bytes(elf.get(at..at + 4)?.try_into().ok()?));
    let half = |at: usize| Some(u16::from_le_bytes(elf.get(at..at + 2)?.try_into().ok()?));
    if elf.get(..5)? != b"\x7fELF\x01" {
        return None;
    }
    let table = word(0x20)? as usize;
    let (entry, count, names) = (half(0x2e)?, half(0x30)?, half(0x32)?);
    let header = |index: u16| table + usize::from(entry) * usize::from(index);
    let strings = word(header(names) + 0x10)? as usize;
    let mut found = Vec::new();
    for index in 0..count {
        let at = header(index);
        let (flags, size) = (word(at + 8)?, word(at + 0x14)?);
        if flags & ALLOC != 0 && size != 0 {
            let start = strings + word(at)? as usize;
            let name = elf.get(start..)?.split(|byte| *byte == 0).next()?;
            let name = String::from_utf8_lossy(name).into_owned();
            found.push(Section {
                name,
                address: word(at + 0xc)?,
                size,
                writable: flags & WRITE != 0,
                stored: word(at + 4)? != NOBITS,
            });
        }
    }
    Some(found)
}
