//! From a dataset to an answer.
//!
//! ```text
//! problem    whitened data, slots, comparison with the simulation
//! nuisance   what a fit moves that is no effect
//! remainder  harmonics above those that are reported, as noise
//! screen     every start of every effect against the residual of a fit
//! noise_sum  sums over the noise columns
//! scatter    the same of effects that only scatter
//! fit        refinement of a set of effects
//! search     none, singles, pairs
//! score      how the sets found compare: posterior probabilities
//! structure  what is left: tests by class
//! significance  how surprising that is, calibrated by simulation
//! holdout    the share closed on rows that took no part
//! across     the same by whole levels and bands, each left out in turn
//! ```

pub(crate) mod across;
pub(crate) mod fit;
pub(crate) mod holdout;
mod noise_sum;
pub(crate) mod normal;
pub(crate) mod nuisance;
pub(crate) mod problem;
mod remainder;
mod scatter;
pub(crate) mod score;
pub(crate) mod screen;
pub(crate) mod search;
pub(crate) mod significance;
pub(crate) mod structure;
