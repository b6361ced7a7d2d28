//! The tool for Windows: one program with the image inside, built here and used under wine.

use crate::packages;
use crate::shell::{VERSION, cargo, empty, root, run, tar_of, target_dir};
use anyhow::{Context, Result, bail};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const TARGET: &str = "x86_64-pc-windows-gnu";
pub(crate) const COMPILER: &str = "x86_64-w64-mingw32-gcc";
const STRIP: &str = "x86_64-w64-mingw32-strip";

/// Builds the folder a user unpacks, and returns it; `None`, after saying so, on a person's computer without the
/// compiler.
pub(crate) fn build(image: &Path) -> Result<Option<PathBuf>> {
    if packages::find(COMPILER).is_none() {
        if std::env::var_os("CI").is_none() {
            eprintln!(
                "no {COMPILER}: no program for Windows (apt-get install gcc-mingw-w64-x86-64)"
            );
            return Ok(None);
        }
        packages::install(&["gcc-mingw-w64-x86-64"])?;
    }
    library()?;
    eprintln!("building the host tool for Windows ...");
    let mut build = cargo("build");
    build.args(["--release", "--workspace", "--bin", "calib"]);
    run(build
        .args(["--target", TARGET])
        .env("CALIB_EMBED_IMAGE", image))?;
    lay_out(&target_dir().join(TARGET).join("release/calib.exe")).map(Some)
}

/// Rust's own library for Windows.
fn library() -> Result<()> {
    let toolchain = std::env::var("RUSTUP_TOOLCHAIN").unwrap_or_else(|_| "stable".into());
    let mut add = Command::new("rustup");
    add.args(["target", "add", TARGET, "--toolchain", &toolchain]);
    run(&mut add).context("Rust has no library for Windows here")
}

fn lay_out(program: &Path) -> Result<PathBuf> {
    let folder = target_dir().join(format!("calib-{VERSION}-x86_64-windows"));
    empty(&folder)?;
    let stripped = folder.join("calib.exe");
    run(Command::new(STRIP).arg("-o").arg(&stripped).arg(program))?;
    for text in ["CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"] {
        let from = root().join(text);
        fs::copy(&from, folder.join(text)).with_context(|| from.display().to_string())?;
    }
    Ok(folder)
}

/// The folder as one file. Explorer opens it, and packs it a third smaller than a ZIP archive.
pub(crate) fn archive(folder: &Path, dist: &Path) -> Result<PathBuf> {
    let (Some(parent), Some(name)) = (folder.parent(), folder.file_name()) else {
        bail!("{} is no folder", folder.display());
    };
    let file = dist.join(format!("{}.tar.xz", name.display()));
    run(tar_of(&file).arg("-C").arg(parent).arg(name))?;
    Ok(file)
}
