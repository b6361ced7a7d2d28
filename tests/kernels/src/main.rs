//! Correlations side by side on the Cortex-M7, for `./run bench target`.
//!
//! Each kernel takes the same buffer of 500 sample pairs, as the digitiser hands
//! them over, and returns to [`kernel_done`]. The bench counts the instructions
//! from the arrival at a kernel to the arrival there. Built with the profile of
//! the image that ships.
//!
//! | kernel | what |
//! |---|---|
//! | `kernel_fold` | the shipping correlation: [`Correlator::push`] |
//! | `kernel_estimate` | its evaluation, once per block of 8 folds of 625 pairs |
//! | `kernel_lock_in` | lock-in of crate `idsp`: oscillator, mixer, low-pass |
//! | `kernel_table` | multiply-accumulate in f32 with a table of sines |
//! | `kernel_sines` and its likes | cosine and sine alone: ours, `libm`, `micromath` |
//!
//! [`Correlator::push`]: calib_core::correlation::Correlator::push
//! [`kernel_done`]: board::kernel_done
#![cfg_attr(target_os = "none", no_std)]
#![cfg_attr(target_os = "none", no_main)]

#[cfg(target_os = "none")]
mod board;
#[cfg(target_os = "none")]
#[path = "../../../firmware/src/board/itcm.rs"]
mod itcm;
#[cfg(target_os = "none")]
mod lock_in;
#[cfg(target_os = "none")]
mod shipping;
#[cfg(target_os = "none")]
mod sines;
#[cfg(target_os = "none")]
mod table;

/// Sample pairs of a buffer: 10 ms.
#[cfg(target_os = "none")]
const PAIRS: usize = 500;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("a program for the Cortex-M7: see `./run bench target`");
}
