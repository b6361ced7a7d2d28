//! The tool around a diagnosis: datasets of known cause, sealed sets, scores.
//!
//! - [`believed`]: which rig a simulation believes in, from whatever file states it.
//! - [`simulated`]: one dataset of known cause.
//! - [`challenge`]: many of them in [`strata`], drawn by [`draw`], their [`truth`] sealed; how large
//!   their gaps are is [`visible`], from [`differences`] value by value.
//! - [`confirm`]: the named effect in the emulated rig, under the shipping firmware.
//! - [`design`]: which points a diagnostic run has.
//! - [`recorded`]: a dataset from what a calibrator reports, less what is [`known`] of it.
//! - [`score`]: what answers to a sealed set are worth.

pub mod believed;
pub mod challenge;
mod compared;
pub mod confirm;
pub mod design;
mod differences;
pub mod draw;
pub mod known;
mod measured;
pub mod recorded;
pub mod score;
pub mod simulated;
pub mod strata;
pub mod truth;
mod visible;
mod waveforms;
