//! An evaluated budget for programs: relative values are fractions, phases degrees.
//!
//! A budget is relative or of a phase, so its keys name no unit; `unit` does.

use super::budget::{CoverageBasis, EvaluatedComponent, Evaluation, Unit};
use super::monte_carlo::{Comparison, Interval};
use schemars::JsonSchema;
use serde::Serialize;

/// An evaluated budget.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct EvaluationView {
    /// Measurand.
    measurand: String,
    /// Unit of all values and uncertainties: `1` or `deg`.
    unit: &'static str,
    /// Components in the order of the budget.
    components: Vec<ComponentView>,
    /// Combined standard uncertainty.
    combined_standard_uncertainty: f64,
    /// Effective degrees of freedom; none when infinite.
    effective_degrees_of_freedom: Option<f64>,
    /// Coverage factor.
    coverage_factor: f64,
    /// Coverage probability the factor stands for.
    coverage_probability: f64,
    /// Basis of the factor.
    coverage_basis: CoverageBasis,
    /// Expanded uncertainty.
    expanded_uncertainty: f64,
    /// The three components most worth improving, the best first.
    improve_first: Vec<ImprovementView>,
    /// Assumptions and warnings.
    remarks: Vec<String>,
    /// Propagated distributions beside the budget, where they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    monte_carlo: Option<PropagatedView>,
}

/// A component with what it contributes.
#[derive(Clone, Debug, Serialize, JsonSchema)]
struct ComponentView {
    /// Name.
    label: String,
    /// Half-width or expanded uncertainty.
    value: f64,
    /// Distribution, as the budget file spells it.
    distribution: &'static str,
    /// Value over standard uncertainty.
    divisor: f64,
    /// Sensitivity coefficient.
    sensitivity_coefficient: f64,
    /// Degrees of freedom; none when infinite.
    degrees_of_freedom: Option<f64>,
    /// Standard uncertainty.
    standard_uncertainty: f64,
    /// Magnitude of the contribution.
    contribution: f64,
    /// Share of the combined variance, 1; negative when it compensates others.
    variance_share: f64,
}

/// Gain from halving one component.
#[derive(Clone, Debug, Serialize, JsonSchema)]
struct ImprovementView {
    /// Name of the component.
    label: String,
    /// Share of the combined variance, 1.
    variance_share: f64,
    /// Expanded uncertainty if this component alone were halved.
    expanded_uncertainty_if_halved: f64,
}

/// Propagated distributions (GUM-S1) and the comparison with the budget.
#[derive(Clone, Debug, Serialize, JsonSchema)]
struct PropagatedView {
    /// Trials drawn.
    trials: usize,
    /// Seed of the random numbers.
    seed: u64,
    /// The results are stable to the numerical tolerance.
    stable: bool,
    /// Numerical tolerance of the results.
    numerical_tolerance: f64,
    /// Mean.
    estimate: f64,
    /// Standard uncertainty.
    standard_uncertainty: f64,
    /// Coverage probability of the intervals.
    coverage_probability: f64,
    /// Probabilistically symmetric interval.
    symmetric_interval: Interval,
    /// Shortest interval.
    shortest_interval: Interval,
    /// Tolerance of the comparison (GUM-S1 7.9.2).
    tolerance: f64,
    /// Distance of the lower interval ends.
    d_low: f64,
    /// Distance of the upper interval ends.
    d_high: f64,
    /// Both distances within the tolerance.
    first_order_valid: bool,
    /// Why not, and which interval to report.
    statement: String,
}

impl EvaluationView {
    /// The budget and, where they were drawn, the propagated distributions.
    pub fn new(evaluation: &Evaluation, monte_carlo: Option<&Comparison>) -> Self {
        let (unit, scale) = match evaluation.unit {
            Unit::Percent => ("1", 0.01),
            Unit::Degree => ("deg", 1.0),
        };
        let improve_first = evaluation.improve_first.iter();
        Self {
            measurand: evaluation.measurand.clone(),
            unit,
            components: evaluation
                .components
                .iter()
                .map(|component| ComponentView::new(component, scale))
                .collect(),
            combined_standard_uncertainty: scale * evaluation.combined_standard_uncertainty,
            effective_degrees_of_freedom: finite(evaluation.effective_degrees_of_freedom),
            coverage_factor: evaluation.coverage_factor,
            coverage_probability: evaluation.coverage_probability,
            coverage_basis: evaluation.coverage_basis,
            expanded_uncertainty: scale * evaluation.expanded_uncertainty,
            improve_first: improve_first
                .map(|improvement| ImprovementView {
                    label: improvement.label.clone(),
                    variance_share: improvement.variance_share_percent / 100.0,
                    expanded_uncertainty_if_halved: scale
                        * improvement.expanded_uncertainty_if_halved,
                })
                .collect(),
            remarks: evaluation.remarks.clone(),
            monte_carlo: monte_carlo.map(|comparison| PropagatedView::new(comparison, scale)),
        }
    }
}

impl ComponentView {
    fn new(component: &EvaluatedComponent, scale: f64) -> Self {
        Self {
            label: component.label.clone(),
            value: scale * component.value,
            distribution: component.distribution,
            divisor: component.divisor,
            sensitivity_coefficient: component.sensitivity_coefficient,
            degrees_of_freedom: finite(component.degrees_of_freedom),
            standard_uncertainty: scale * component.standard_uncertainty,
            contribution: scale * component.contribution,
            variance_share: component.variance_share,
        }
    }
}

impl PropagatedView {
    fn new(comparison: &Comparison, scale: f64) -> Self {
        let outcome = &comparison.outcome;
        let interval = |interval: Interval| Interval {
            low: scale * interval.low,
            high: scale * interval.high,
        };
        Self {
            trials: outcome.trials,
            seed: outcome.seed,
            stable: outcome.stable,
            numerical_tolerance: scale * outcome.numerical_tolerance,
            estimate: scale * outcome.estimate,
            standard_uncertainty: scale * outcome.standard_uncertainty,
            coverage_probability: outcome.coverage_probability,
            symmetric_interval: interval(outcome.symmetric_interval),
            shortest_interval: interval(outcome.shortest_interval),
            tolerance: scale * comparison.tolerance,
            d_low: scale * comparison.d_low,
            d_high: scale * comparison.d_high,
            first_order_valid: comparison.first_order_valid,
            statement: comparison.statement.clone(),
        }
    }
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}
