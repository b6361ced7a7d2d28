//! Propagation of distributions: GUM Supplement 1.
//!
//! Trials come in blocks of 10 000; each block has its own stream of random
//! numbers, so the result depends on the seed alone and not on the number of
//! cores. Blocks are added until twice the standard deviation of the block
//! averages of estimate, standard uncertainty and both interval ends is below
//! the numerical tolerance (GUM-S1 7.9.4).

mod adaptive;
mod draw;
mod elementary;
mod interval;
mod polar;
mod random;
mod tolerance;
mod validation;

pub use adaptive::{BLOCK, Options, Outcome, propagate};
pub use draw::{BATCH, Plan};
pub use interval::{Interval, coverage_intervals};
pub use polar::{Polar, polar};
pub use random::Lanes;
pub use tolerance::numerical_tolerance;
pub use validation::{Comparison, report, validate};
