//! Puts the linker's memory map in reach, stamps the image with its origin, and
//! refuses one that is for no board or for two.
//!
//! `memory.x` lives at the top of the workspace, where everyone looks for it,
//! and cortex-m-rt's `link.x` includes it by name from the search path.

use std::{env, error::Error, fs, path::PathBuf};

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

    // `./run elf` says which commit it is: only there is it asked anew for each build.
    let commit = env::var("CALIB_GIT_HASH").unwrap_or_else(|_| "unknown".into());
    println!("cargo:rustc-env=CALIB_GIT_HASH={commit}");
    println!("cargo:rerun-if-env-changed=CALIB_GIT_HASH");
    Ok(())
}
