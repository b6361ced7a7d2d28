//! The firmware images, one for each board: built once, tested and shipped as they are.

use crate::origin::{self, Place};
use crate::shell::{cargo_for_board, root, run, target_dir};
use anyhow::{Context, Result, bail};
use object::elf::{SHF_ALLOC, SHF_WRITE};
use object::{Object, ObjectSection, SectionFlags};
use std::path::{Path, PathBuf};
use std::process::Command;

pub(crate) const TARGET: &str = "thumbv7em-none-eabihf";
const PROFILE: &str = "firmware";
pub(crate) const PACKAGE: &str = "calib-firmware";
const LOADER: &str = "calib-loader";
/// The board of the image without a name.
pub(crate) const DEFAULT_BOARD: &str = "nucleo-h743zi2";

/// Builds the image of the default board and returns its path.
pub(crate) fn build() -> Result<PathBuf> {
    eprintln!("building the firmware image ...");
    build_package(PACKAGE, &[])
}

/// Builds the image of a board, by default as [`build`] does, and returns its path.
pub(crate) fn build_for(board: Option<&str>) -> Result<PathBuf> {
    match board {
        None | Some(DEFAULT_BOARD) => build(),
        Some(board) => {
            let kept = build_other(board)?;
            // Cargo puts every image in one place, where the default one belongs.
            build()?;
            Ok(kept)
        }
    }
}

/// Builds the images of all boards, the default one last, and returns their paths in that order.
pub(crate) fn build_all() -> Result<Vec<PathBuf>> {
    let boards = boards()?.into_iter();
    let others = boards.filter(|board| board != DEFAULT_BOARD);
    let mut images: Vec<PathBuf> = others
        .map(|board| build_other(&board))
        .collect::<Result<_>>()?;
    // Builds the default one last.
    build_on_target_tests()?;
    images.push(path(PACKAGE));
    Ok(images)
}

/// Names of the boards: the folders of `firmware/boards`.
fn boards() -> Result<Vec<String>> {
    let folders = std::fs::read_dir(root().join("firmware/boards"))?;
    let names = folders.map(|folder| Ok(folder?.file_name().to_string_lossy().into_owned()));
    let mut names: Vec<String> = names.collect::<Result<_>>()?;
    names.sort();
    Ok(names)
}

/// Builds the image of a board and copies it to where the next does not replace it.
fn build_other(board: &str) -> Result<PathBuf> {
    let boards = boards()?;
    if !boards.iter().any(|name| name == board) {
        bail!("no board `{board}`: there are {}", boards.join(", "));
    }
    eprintln!("building the firmware image for {board} ...");
    let features = format!("board-{board}");
    let image = build_package(PACKAGE, &["--no-default-features", "--features", &features])?;
    keep(&image, "boards", board)
}

/// Builds the image of a board as it is linked for slot B, and returns its path.
pub(crate) fn build_for_slot_b(board: Option<&str>) -> Result<PathBuf> {
    let board = board.unwrap_or(DEFAULT_BOARD);
    eprintln!("building the firmware image for slot B of {board} ...");
    let features = format!("board-{board},slot-b");
    let image = build_package(PACKAGE, &["--no-default-features", "--features", &features])?;
    let kept = keep(&image, "slot-b", board)?;
    // Cargo puts every image in one place, where the default one belongs.
    build()?;
    Ok(kept)
}

/// Builds the loader that trusts a key, 64 hexadecimal digits, and returns its path.
pub(crate) fn build_loader(key: &str) -> Result<PathBuf> {
    eprintln!("building the loader ...");
    run(build_at(&Place::here()?, LOADER).env("CALIB_TRUSTED_KEY", key))?;
    Ok(path(LOADER))
}

/// Copies an image to where the next does not replace it.
fn keep(image: &Path, folder: &str, name: &str) -> Result<PathBuf> {
    let folder = image.with_file_name(folder);
    std::fs::create_dir_all(&folder)?;
    let kept = folder.join(name);
    std::fs::copy(image, &kept).with_context(|| format!("cannot write {}", kept.display()))?;
    Ok(kept)
}

/// Builds the tests on the target, for the default board, and returns their path.
pub(crate) fn build_on_target_tests() -> Result<PathBuf> {
    eprintln!("building the tests on the target ...");
    let image = build_package(PACKAGE, &["--features", "hitl"])?;
    let kept = keep(&image, "hitl", "calib-hitl")?;
    // Cargo puts every image in one place, where the shipping one belongs.
    build()?;
    Ok(kept)
}

/// Builds a program for the board as the image is built, and returns its path.
pub(crate) fn build_package(package: &str, features: &[&str]) -> Result<PathBuf> {
    let mut build = build_at(&Place::here()?, package);
    run(build.args(features))?;
    Ok(path(package))
}

/// Builds the image of the default board at another place and returns its path.
pub(crate) fn build_elsewhere(place: &Place) -> Result<PathBuf> {
    run(&mut build_at(place, PACKAGE))?;
    Ok(place.target.join(TARGET).join(PROFILE).join(PACKAGE))
}

/// Cargo, told to build for the board what lies at `place`.
fn build_at(place: &Place, package: &str) -> Command {
    let mut command = cargo_for_board("build");
    command
        .current_dir(&place.workspace)
        .env("CARGO_HOME", &place.cargo_home)
        .env("CARGO_TARGET_DIR", &place.target)
        .env("CALIB_GIT_HASH", origin::git_hash())
        .args(["--package", package, "--profile", PROFILE])
        .args(["--target", TARGET, "--config"])
        .arg(place.flags(TARGET));
    command
}

/// Where a program for the board lies once it is built.
fn path(package: &str) -> PathBuf {
    target_dir().join(TARGET).join(PROFILE).join(package)
}

/// Prints what the image takes of flash and RAM, section by section.
pub(crate) fn print_size(board: Option<&str>) -> Result<()> {
    let path = build_for(board)?;
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
