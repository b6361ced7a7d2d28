//! Puts the linker's memory map in reach, stamps the image with its origin, and
//! refuses one that is for no board or for two.
//!
//! `memory.x` lives at the top of the workspace, where everyone looks for it,
//! and cortex-m-rt's `link.x` includes it by name from the search path.

use std::{env, error::Error, fs, path::PathBuf, process::Command};

fn main() -> Result<(), Box<dyn Error>> {
    let boards = env::vars().filter(|(name, _)| name.starts_with("CARGO_FEATURE_BOARD_"));
    if boards.count() != 1 {
        let choose = "--no-default-features --features board-NAME";
        return Err(format!("an image is for one folder of firmware/boards: {choose}").into());
    }
    let workspace = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?).join("..");
    let out = PathBuf::from(env::var("OUT_DIR")?);
    fs::copy(workspace.join("memory.x"), out.join("memory.x"))?;
    println!("cargo:rustc-link-search={}", out.display());
    println!("cargo:rerun-if-changed=../memory.x");
    println!("cargo:rerun-if-changed=build.rs");

    println!("cargo:rustc-env=CALIB_GIT_HASH={}", git_hash());
    println!("cargo:rerun-if-env-changed=CALIB_GIT_HASH");
    // A commit moves HEAD's log; a tree without git simply has no such file.
    let head_log = workspace.join(".git/logs/HEAD");
    if head_log.exists() {
        println!("cargo:rerun-if-changed={}", head_log.display());
    }
    Ok(())
}

/// Short hash, `-dirty` when tracked files differ; "unknown" without git.
fn git_hash() -> String {
    if let Ok(given) = env::var("CALIB_GIT_HASH") {
        return given;
    }
    Command::new("git")
        .args([
            "describe",
            "--always",
            "--dirty",
            "--abbrev=12",
            "--exclude=*",
        ])
        .output()
        .ok()
        .filter(|output| output.status.success())
        .and_then(|output| String::from_utf8(output.stdout).ok())
        .map_or_else(|| "unknown".into(), |hash| hash.trim().to_owned())
}
