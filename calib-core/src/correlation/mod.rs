//! Fixed-block sine correlation of paired samples.
//!
//! | step | where | cost |
//! |---|---|---|
//! | every pair is added to an integer fold | [`fold`] | per sample |
//! | the fold is correlated with exact sines | [`estimate`] | per block |
//! | one block follows another | [`correlator`] | per buffer |
//!
//! A block holds whole periods of a [`Tone`](crate::tone::Tone). All samples at
//! the same place of the period are summed in 32-bit integers, exactly; the
//! sines are applied once to the at most 12 000 sums. No rounding happens
//! before that, so a block of 10 s is as accurate as one of 10 ms. Two places
//! as far from the middle of the fold share their sines ([`mirror`]).
//!
//! # Why there is no leakage
//! Over `N = m * period` samples every component at `h * cycles / period` of
//! the sample rate, and the mean, is orthogonal to every other: the sum over a
//! period of `exp(j 2 pi k n / period)` is zero for every whole `k` that is no
//! multiple of `period`. Derived with its limits in `docs/metrology/measurement.md`.

pub mod block;
pub mod correlator;
pub mod estimate;
pub mod fold;
mod mirror;
mod outline;
mod sums;
#[cfg(test)]
mod tests;

pub use block::Block;
pub use correlator::Correlator;
pub use estimate::{ChannelEstimate, PairEstimate};
pub use fold::{Energy, FoldMemory, SQUARE_STRIDE};
pub use outline::{OUTLINE, Outline};
