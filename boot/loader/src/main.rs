//! The loader: what the part starts, and what starts the image.
//!
//! It takes no clock, no interrupt and no RAM of the firmware's but DTCM, and leaves the part as a reset
//! does, with two exceptions: the instruction cache is on, and so is the watchdog, so that a new image that
//! hangs before it has a watchdog of its own is one more start that is counted.
#![cfg_attr(target_os = "none", no_std)]
#![cfg_attr(target_os = "none", no_main)]

#[cfg(target_os = "none")]
mod part;

#[cfg(not(target_os = "none"))]
fn main() {
    println!(
        "calib-loader {} starts images on the board",
        env!("CARGO_PKG_VERSION")
    );
}
