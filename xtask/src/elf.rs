//! The firmware image: built once, tested and shipped as it is.

use crate::shell::{cargo, root, run, target_dir};
use anyhow::{Context, Result};
use object::elf::{SHF_ALLOC, SHF_WRITE};
use object::{Object, ObjectSection, SectionFlags};
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
    for section in sections(&bytes).context("the image is no ELF file")? {
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
    for section in sections(&bytes).context("the image is no ELF file")? {
        let kind = match (section.writable, section.stored) {
            (false, _) => 0,
            (true, true) => 1,
            (true, false) => 2,
        };
        totals[kind] += section.size;
    }
    Ok(totals)
}

struct Section<'a> {
    name: &'a str,
    address: u32,
    size: u32,
    writable: bool,
    /// Its content is part of the image.
    stored: bool,
}

/// Sections that take memory on the board.
fn sections(elf: &[u8]) -> object::Result<Vec<Section<'_>>> {
    let file = object::File::parse(elf)?;
    let mut found = Vec::new();
    for section in file.sections() {
        let SectionFlags::Elf { sh_flags } = section.flags() else {
            continue;
        };
        if sh_flags & u64::from(SHF_ALLOC) != 0 && section.size() != 0 {
            found.push(Section {
                name: section.name()?,
                address: section.address() as u32,
                size: section.size() as u32,
                writable: sh_flags & u64::from(SHF_WRITE) != 0,
                stored: section.file_range().is_some(),
            });
        }
    }
    Ok(found)
}
