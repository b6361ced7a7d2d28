//! Names the slot the image is linked for, stamps the image with its origin, and refuses one that is for no
//! board or for two.
//!
//! `memory.x` lies at the top of the workspace, where everyone looks for it, and where the linker runs.

use std::{env, error::Error};

fn main() -> Result<(), Box<dyn Error>> {
    let features = env::vars().map(|(name, _)| name);
    let boards =
        features.filter_map(|name| Some(name.strip_prefix("CARGO_FEATURE_BOARD_")?.to_owned()));
    let [board] = boards.collect::<Vec<String>>().try_into().map_err(|_| {
        "an image is for one folder of firmware/boards: --no-default-features --features board-NAME"
    })?;
    println!(
        "cargo:rustc-env=CALIB_BOARD={}",
        board.to_lowercase().replace('_', "-")
    );
    if env::var_os("CARGO_FEATURE_SLOT_B").is_some() {
        println!("cargo:rustc-link-arg-bins=--defsym=_slot_b=1");
    }
    println!("cargo:rerun-if-changed=../memory.x");
    println!("cargo:rerun-if-changed=build.rs");

    // `./run elf` says which commit it is: only there is it asked anew for each build.
    let commit = env::var("CALIB_GIT_HASH").unwrap_or_else(|_| "unknown".into());
    println!("cargo:rustc-env=CALIB_GIT_HASH={commit}");
    println!("cargo:rerun-if-env-changed=CALIB_GIT_HASH");
    Ok(())
}
