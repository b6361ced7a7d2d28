//! From a dataset to an answer.
//!
//! ```text
//! problem    whitened data, nuisances, slots
//! screen     every start of every effect against the residual of a fit
//! fit        refinement of a set of effects
//! search     none, singles, pairs; posterior probabilities
//! structure  what is left: tests by class
//! significance  how surprising that is, calibrated by simulation
//! holdout    the share closed on rows that took no part
//! across     the same by whole levels and bands, each left out in turn
//! ```

pub(crate) mod across;
pub(crate) mod fit;
pub(crate) mod holdout;
pub(crate) mod normal;
pub(crate) mod problem;
pub(crate) mod screen;
pub(crate) mod search;
pub(crate) mod significance;
pub(crate) mod structure;
