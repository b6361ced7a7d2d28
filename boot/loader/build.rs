//! Has the loader linked for where the part starts (`memory.x`), with the key that it is to trust.
//!
//! `CALIB_TRUSTED_KEY` is a public key as 64 hexadecimal digits; without it, the development key.

use std::{env, error::Error, fs};

const VARIABLE: &str = "CALIB_TRUSTED_KEY";

fn main() -> Result<(), Box<dyn Error>> {
    if env::var("CARGO_CFG_TARGET_OS")? == "none" {
        println!("cargo:rustc-link-arg-bins=--defsym=_loader=1");
    }
    println!("cargo:rerun-if-changed=../../memory.x");
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=../keys/DEVELOPMENT.pub");
    println!("cargo:rerun-if-env-changed={VARIABLE}");
    let key = match env::var(VARIABLE) {
        Ok(key) => key,
        Err(_) => fs::read_to_string("../keys/DEVELOPMENT.pub")?,
    };
    println!("cargo:rustc-env={VARIABLE}={}", key.trim());
    Ok(())
}
