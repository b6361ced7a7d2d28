//! The simulation of a point: nominal rig, plus any set of effects.
//!
//! Everything here works in the frequency domain, row by row; nothing is
//! integrated over time, so the simulator that is judged and the model that
//! judges it share parameters but no equations.

pub(crate) mod balance;
pub(crate) mod chain;
mod channels;
mod drive;
pub(crate) mod exciter;
mod friction;
pub(crate) mod leakage;
pub(crate) mod memory;
pub(crate) mod predict;
pub(crate) mod row;
pub(crate) mod scatter;
mod wave;
pub(crate) mod waveform;
