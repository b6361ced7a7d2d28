//! Contribution of a component to a budget.

/// A component with what it contributes.
#[derive(Clone, Debug)]
pub struct EvaluatedComponent {
    /// Name.
    pub label: String,
    /// Half-width or expanded uncertainty, as stated.
    pub value: f64,
    /// Distribution, as the budget file spells it.
    pub distribution: &'static str,
    /// Value over standard uncertainty.
    pub divisor: f64,
    /// Sensitivity coefficient.
    pub sensitivity_coefficient: f64,
    /// Degrees of freedom; may be infinite.
    pub degrees_of_freedom: f64,
    /// Standard uncertainty.
    pub standard_uncertainty: f64,
    /// `|c_i| u(x_i)`.
    pub contribution: f64,
    /// Share of the combined variance, covariances halved between partners;
    /// negative when a correlation makes the component compensate others.
    pub variance_share: f64,
}
