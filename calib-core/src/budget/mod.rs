//! The uncertainty budget of ISO 16063-21, Annex A, by the rules of the GUM.
//!
//! | file | what |
//! |---|---|
//! | [`component`] | one line: value, distribution, sensitivity coefficient, degrees of freedom |
//! | [`catalogue`] | the rows of Tables A.1 to A.4 |
//! | [`combine`] | combined standard uncertainty and effective degrees of freedom |
//! | [`coverage`] | coverage factor and expanded uncertainty |
//! | [`student`] | quantiles of Student's t and of the normal distribution |
//! | [`point`] | the budget of one measured point |
//!
//! Values may be relative, in volts or in radians: a budget only needs that
//! all its contributions are in the unit of the measurand.

pub mod catalogue;
pub mod combine;
pub mod component;
pub mod coverage;
pub mod point;
pub mod student;
#[cfg(test)]
mod tests;

pub use catalogue::{Row, Table};
pub use combine::{Budget, BudgetError, Combined, MAX_COMPONENTS};
pub use component::Component;
pub use coverage::{Coverage, CoverageRule, Expanded, PROBABILITY_K2, Shape};
pub use point::{PointBudget, point_budget};
