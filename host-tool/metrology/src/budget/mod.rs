//! Uncertainty budgets: components in, expanded uncertainty out.
//!
//! ```text
//! FILE.toml -> BudgetFile -> Budget -> evaluate -> Evaluation -> report, chart
//!                                  \-> monte_carlo (GUM Supplement 1)
//! ```
//!
//! # Source
//! ISO 16063-21:2003 Annex A and D; GUM 5 and Annex G; EA-4/02 for the
//! coverage factors of dominant rectangular contributions.

mod chart;
mod component;
mod contribution;
mod correlation;
mod coverage;
mod evaluate;
mod file;
mod report;
mod template;
pub mod type_a;

pub use chart::contribution_chart;
pub use component::{Component, Distribution};
pub use contribution::EvaluatedComponent;
pub use correlation::{Coefficient, Correlation, first_negative_eigenvalue};
pub use coverage::{CoverageBasis, CoverageFactor, CoverageRule, trapezoidal_factor};
pub use evaluate::{Evaluation, Improvement, evaluate};
pub use file::{load, parse};
pub use report::report;
pub use template::{Template, TemplateRow, template};

use serde::Serialize;

/// Kind of a budget's numbers: relative in percent, or angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Unit {
    /// Relative to the measurand, percent (magnitude; Tables A.1 and A.3); fractions for programs.
    #[serde(rename = "1")]
    Percent,
    /// Degrees of phase (Tables A.2 and A.4).
    #[serde(rename = "deg")]
    Degree,
}

impl Unit {
    /// How it is written behind a number.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Percent => "%",
            Self::Degree => "deg",
        }
    }
}

/// How the components act on the measurand when distributions are propagated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {
    /// `y = product of (1 + e_i)^c_i`, the model of ISO 16063-21 D.4.
    Product,
    /// `y = sum of c_i e_i`.
    Sum,
}

/// A complete budget, checked: every number finite and in range, correlation
/// matrix positive semidefinite.
#[derive(Clone, Debug)]
pub struct Budget {
    /// Measurand, in the author's words.
    pub measurand: String,
    /// Unit of every value.
    pub unit: Unit,
    /// Model for the propagation of distributions.
    pub model: Model,
    /// How the coverage factor is found.
    pub coverage: CoverageRule,
    /// Whether effective degrees of freedom are truncated to an integer
    /// before Student's t is taken (EA-4/02 Annex E) or used as they are
    /// (interpolation, GUM G.4.1).
    pub truncate_degrees_of_freedom: bool,
    /// Components, at least one of them not zero.
    pub components: Vec<Component>,
    /// Correlations between components.
    pub correlations: Vec<Correlation>,
    /// Assumptions made while reading, for the reader of the report.
    pub remarks: Vec<String>,
}
