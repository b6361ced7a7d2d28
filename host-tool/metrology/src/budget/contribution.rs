//! Contribution of a component to a budget.

use schemars::JsonSchema;
use serde::Serialize;

/// A component with what it contributes.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(rename = "ComponentView")]
pub struct EvaluatedComponent {
    /// Name.
    pub label: String,
    /// Half-width or expanded uncertainty.
    pub value: f64,
    /// Distribution, as the budget file spells it.
    pub distribution: &'static str,
    /// Value over standard uncertainty.
    pub divisor: f64,
    /// Sensitivity coefficient.
    pub sensitivity_coefficient: f64,
    /// Degrees of freedom; none when infinite.
    #[schemars(with = "Option<f64>")]
    pub degrees_of_freedom: f64,
    /// Standard uncertainty.
    pub standard_uncertainty: f64,
    // `|c_i| u(x_i)`.
    /// Magnitude of the contribution.
    pub contribution: f64,
    // Covariances are halved between partners.
    /// Share of the combined variance, 1; negative when it compensates others.
    pub variance_share: f64,
}
