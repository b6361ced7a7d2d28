//! The simulation of a point: nominal rig, plus any set of effects.
//!
//! Everything here works in the frequency domain, row by row; nothing is
//! integrated over time, so the simulator that is judged and the model that
//! judges it share parameters but no equations.
//!
//! ```text
//! row          a point, prepared; scatter: noise, and what leaks into its components
//! effect       what an effect does to a row, and when rows can show it (facts)
//! prediction   what a simulation starts from, and what it says; predict: how it gets there
//! chain        what effects do to a row; transfers: their linear responses
//! exciter      linear and bent; balance, friction: at a level; memory: of a row
//! held         the motion at which the reference shows the level that is held
//! channels     what both channels make of it; path: of a wave on its way
//! grid         a wave of many orders; shaped: bent; waveform: the same of a cosine;
//!              saturation: a cosine through a hyperbolic tangent
//! ```

pub(crate) mod balance;
pub(crate) mod chain;
mod channels;
pub(crate) mod effect;
pub(crate) mod exciter;
pub(crate) mod facts;
mod friction;
mod grid;
mod held;
pub(crate) mod memory;
mod path;
pub(crate) mod predict;
pub(crate) mod prediction;
pub(crate) mod row;
mod saturation;
pub(crate) mod scatter;
mod shaped;
mod transfers;
pub(crate) mod waveform;
