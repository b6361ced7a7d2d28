//! How good the diagnosis is: sealed sets of known cause, and what answers to them are worth.
//!
//! - [`challenge`]: many datasets in [`strata`], drawn by [`draw`], their [`truth`] sealed; how large
//!   their gaps are is `visible`, from `differences` value by value.
//! - [`score`]: what answers to a sealed set are worth.
//!
//! Datasets come from `calib-twin`, answers from `calib-gap`: this is where the two meet.
#![forbid(unsafe_code)]

mod challenge;
mod differences;
pub mod draw;
pub mod score;
pub mod strata;
pub mod truth;
mod visible;

pub use challenge::{Design, Sealed, challenge};
