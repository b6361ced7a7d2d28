//! The tool around a diagnosis: datasets of known cause, and of what a calibrator measures.
//!
//! - [`believed`]: which rig a simulation believes in, from whatever file states it.
//! - [`simulated`]: one dataset of known cause.
//! - [`confirm`]: the named effect in the emulated rig, under the shipping firmware.
//! - [`design`]: which points a diagnostic run has.
//! - [`recorded`]: a dataset from what a calibrator reports, less what is [`known`] of it.

pub mod believed;
mod compared;
pub mod confirm;
pub mod design;
pub mod known;
mod measured;
pub mod recorded;
pub mod simulated;
mod waveforms;
