//! The estimator: what any model needs to be fitted, compared with others and judged.
//!
//! ```text
//! column        columns of a Jacobian, sparse by block of data
//! tangent       normal equations, and what a fit takes over of data and of other columns
//! descent       least squares over whatever can be fitted
//! selection     what a cause costs, probabilities of sets, how often each leads when drawn again
//! significance  tail probabilities; lack of fit, its null distribution simulated
//! gap           distance between simulation and measurement, before and after
//! verdict       the outcomes, and what data that took no part say against a set
//! ```
//!
//! `calibrator` and `oscillator` are its two models.

pub(crate) mod column;
pub(crate) mod descent;
pub(crate) mod gap;
pub(crate) mod selection;
pub(crate) mod significance;
pub(crate) mod tangent;
pub(crate) mod verdict;
