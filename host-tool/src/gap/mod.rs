//! The tool around a diagnosis: datasets of known cause, sealed sets, scores.
//!
//! - [`believed`]: which rig a simulation believes in, from whatever file states it.
//! - [`simulated`]: one dataset of known cause.
//! - [`challenge`]: many of them in [`strata`], drawn by [`draw`], their [`truth`] sealed.
//! - [`score`]: what answers to a sealed set are worth.

pub mod believed;
pub mod challenge;
pub mod draw;
pub mod score;
pub mod simulated;
pub mod strata;
pub mod truth;
