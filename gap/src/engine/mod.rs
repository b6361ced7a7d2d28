//! From a dataset to an answer.
//!
//! ```text
//! problem    whitened data by observable, comparison with the simulation
//! evaluate   compares simulation and measurement; evaluation: what comes of it
//! nuisance   what a fit moves that is no effect
//! remainder  harmonics above those that are reported, as noise; higher: where they would show
//! screen     every start of every effect against the residual of a fit
//! noise_sum  sums over the noise columns
//! atom       one start; values: of effects that just change values of the exciter
//! scatter    the same of effects that only scatter
//! column     a column of a Jacobian; normal: normal equations, tangent space
//! linear     slopes at a fit; nuisance_columns, response: of which no row is computed anew; aside: the others
//! slopes     slopes of earlier steps
//! fit        a set of effects as a search has it
//! refine     its refinement; step, polish
//! search     none, singles, pairs, within limits
//! proposal   which effects to add to which sets; race: their refinement; found: what came of it
//! score      how the sets found compare: posterior probabilities
//! settled    the best values beside those where a search stopped
//! structure  what is left: tests by class; battery: their shapes; open_data: scatter left open
//! significance  how surprising that is, calibrated by simulation
//! holdout    the share closed on rows that took no part; errors: there; gap: as the answer states it
//! across     the same by whole levels and bands, each left out in turn
//! ```

pub(crate) mod across;
mod aside;
pub(crate) mod atom;
pub(crate) mod battery;
pub(crate) mod column;
pub(crate) mod errors;
pub(crate) mod evaluate;
pub(crate) mod evaluation;
#[cfg(test)]
pub(crate) mod example;
pub(crate) mod fit;
pub(crate) mod found;
pub(crate) mod gap;
mod higher;
pub(crate) mod holdout;
pub(crate) mod limits;
pub(crate) mod linear;
mod noise_sum;
pub(crate) mod normal;
pub(crate) mod nuisance;
mod nuisance_columns;
mod open_data;
mod polish;
pub(crate) mod problem;
mod proposal;
mod race;
mod refine;
mod remainder;
mod response;
mod scatter;
pub(crate) mod score;
pub(crate) mod screen;
pub(crate) mod search;
pub(crate) mod settled;
pub(crate) mod significance;
mod slopes;
mod step;
pub(crate) mod structure;
mod values;
