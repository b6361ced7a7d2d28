//! Firmware of the vibration calibrator.
//!
//! Tasks carry, the board wires, `calib-core` computes. Built for the host,
//! the same program prints what a host needs to know about the image.
#![cfg_attr(target_os = "none", no_std)]
#![cfg_attr(target_os = "none", no_main)]
// The tests on the target need the drivers, and no task.
#![cfg_attr(feature = "hitl", allow(dead_code, unused_imports))]

#[cfg(target_os = "none")]
mod board;
#[cfg(target_os = "none")]
mod fault;
#[cfg(target_os = "none")]
mod identity;
#[cfg(target_os = "none")]
mod instrument;
#[cfg(all(target_os = "none", feature = "hitl"))]
#[path = "../../hitl/on_target.rs"]
mod on_target;
#[cfg(target_os = "none")]
mod panic;
#[cfg(target_os = "none")]
mod retained;
#[cfg(target_os = "none")]
mod self_test;
#[cfg(target_os = "none")]
mod shared_archive;
#[cfg(target_os = "none")]
mod start;
#[cfg(target_os = "none")]
mod state;
#[cfg(target_os = "none")]
mod tasks;
#[cfg(target_os = "none")]
mod timing;
#[cfg(target_os = "none")]
mod update;

#[cfg(target_os = "none")]
use defmt_rtt as _;

#[cfg(target_os = "none")]
#[embassy_executor::main]
async fn main(spawner: embassy_executor::Spawner) {
    #[cfg(feature = "hitl")]
    {
        let _ = spawner;
        on_target::run().await;
    }
    #[cfg(not(feature = "hitl"))]
    start::start(spawner).await;
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!(
        "calib-firmware {} speaks protocol {}",
        env!("CARGO_PKG_VERSION"),
        calib_protocol::frame::PROTOCOL_VERSION
    );
}
