//! The law of propagation of uncertainty, and which component to improve.

use super::contribution::EvaluatedComponent;
use super::coverage::{self, CoverageBasis};
use super::{Budget, Coefficient, Unit};
use schemars::JsonSchema;
use serde::Serialize;

/// Gain from halving one component.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(rename = "ImprovementView")]
pub struct Improvement {
    /// Name of the component.
    pub label: String,
    /// Share of the combined variance, 1.
    pub variance_share: f64,
    // With the same coverage factor.
    /// Expanded uncertainty if this component alone were halved.
    pub expanded_uncertainty_if_halved: f64,
}

/// An evaluated budget.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Evaluation {
    /// Measurand.
    pub measurand: String,
    /// Unit of all values and uncertainties: `1` or `deg`.
    #[schemars(with = "String")]
    pub unit: Unit,
    /// Components in the order of the budget.
    pub components: Vec<EvaluatedComponent>,
    /// Combined standard uncertainty.
    pub combined_standard_uncertainty: f64,
    /// Effective degrees of freedom; none when infinite.
    #[schemars(with = "Option<f64>")]
    pub effective_degrees_of_freedom: f64,
    /// Coverage factor.
    pub coverage_factor: f64,
    /// Coverage probability the factor stands for.
    pub coverage_probability: f64,
    /// Basis of the factor.
    pub coverage_basis: CoverageBasis,
    /// Expanded uncertainty.
    pub expanded_uncertainty: f64,
    /// The three components most worth improving, the best first.
    pub improve_first: Vec<Improvement>,
    /// Assumptions and warnings.
    pub remarks: Vec<String>,
}

/// Evaluates a budget.
///
/// # Equation
/// `u^2 = sum (c_i u_i)^2 + 2 sum sum c_i c_j u_i u_j r_ij` and
/// `1/nu_eff = sum ((c_i u_i / u)^4 / nu_i)`, in relative form.
///
/// # Source
/// ISO 16063-21 (A.1); GUM 5.2.2, G.4.1.
pub fn evaluate(budget: &Budget) -> Evaluation {
    let signed: Vec<f64> = budget
        .components
        .iter()
        .map(|component| component.signed_contribution())
        .collect();
    let variances = variance_parts(budget, &signed);
    let combined = variances.iter().sum::<f64>().max(0.0).sqrt();
    let components = evaluated_components(budget, &signed, &variances, combined);
    let effective = effective_degrees_of_freedom(&components, combined);
    let effective = match budget.truncate_degrees_of_freedom && effective.is_finite() {
        true => effective.floor().max(1.0),
        false => effective,
    };
    let factor = coverage::choose(
        budget.coverage,
        &components,
        combined,
        effective,
        !budget.correlations.is_empty(),
    );
    let mut evaluation = Evaluation {
        measurand: budget.measurand.clone(),
        unit: budget.unit,
        improve_first: improvements(&signed, &components, combined, factor.value),
        components,
        combined_standard_uncertainty: combined,
        effective_degrees_of_freedom: effective,
        coverage_factor: factor.value,
        coverage_probability: factor.probability,
        coverage_basis: factor.basis,
        expanded_uncertainty: factor.value * combined,
        remarks: budget.remarks.clone(),
    };
    warn(budget, &mut evaluation);
    evaluation
}

/// Variance of each component plus half of its covariances, times two.
fn variance_parts(budget: &Budget, signed: &[f64]) -> Vec<f64> {
    let mut parts: Vec<f64> = signed.iter().map(|u| u * u).collect();
    for correlation in &budget.correlations {
        let (a, b) = (signed[correlation.a], signed[correlation.b]);
        let covariance = match correlation.coefficient {
            Coefficient::Known(r) => r * a * b,
            Coefficient::Unknown => (a * b).abs(),
        };
        parts[correlation.a] += covariance;
        parts[correlation.b] += covariance;
    }
    parts
}

fn evaluated_components(
    budget: &Budget,
    signed: &[f64],
    variances: &[f64],
    combined: f64,
) -> Vec<EvaluatedComponent> {
    let share = |variance: f64| match combined > 0.0 {
        true => variance / (combined * combined),
        false => 0.0,
    };
    budget
        .components
        .iter()
        .zip(signed.iter().zip(variances))
        .map(|(component, (contribution, variance))| EvaluatedComponent {
            label: component.label.clone(),
            value: component.value,
            distribution: component.distribution.name(),
            divisor: component.distribution.divisor(),
            sensitivity_coefficient: component.sensitivity_coefficient,
            degrees_of_freedom: component.degrees_of_freedom,
            standard_uncertainty: component.standard_uncertainty(),
            contribution: contribution.abs(),
            variance_share: share(*variance),
        })
        .collect()
}

fn effective_degrees_of_freedom(components: &[EvaluatedComponent], combined: f64) -> f64 {
    let sum: f64 = components
        .iter()
        .filter(|component| component.degrees_of_freedom.is_finite() && combined > 0.0)
        .map(|component| (component.contribution / combined).powi(4) / component.degrees_of_freedom)
        .sum();
    match sum > 0.0 {
        true => 1.0 / sum,
        false => f64::INFINITY,
    }
}

fn improvements(
    signed: &[f64],
    components: &[EvaluatedComponent],
    combined: f64,
    coverage_factor: f64,
) -> Vec<Improvement> {
    let mut order: Vec<usize> = (0..components.len()).collect();
    order.sort_by(|&a, &b| {
        components[b]
            .variance_share
            .total_cmp(&components[a].variance_share)
    });
    let halved = |index: usize| {
        // u^2 = own^2 + own * rest + ...; half of own leaves own^2/4 + own*rest/2.
        let own = signed[index].powi(2);
        let with_covariance = components[index].variance_share * combined * combined;
        let covariance = with_covariance - own;
        let variance = combined * combined - 0.75 * own - covariance;
        coverage_factor * variance.max(0.0).sqrt()
    };
    order
        .into_iter()
        .filter(|&index| components[index].variance_share > 0.0)
        .take(3)
        .map(|index| Improvement {
            label: components[index].label.clone(),
            variance_share: components[index].variance_share,
            expanded_uncertainty_if_halved: halved(index),
        })
        .collect()
}

fn warn(budget: &Budget, evaluation: &mut Evaluation) {
    let effective = evaluation.effective_degrees_of_freedom;
    let unknown = budget
        .correlations
        .iter()
        .any(|correlation| correlation.coefficient == Coefficient::Unknown);
    if unknown {
        evaluation.remarks.push(
            "correlation of unknown degree: the contributions add linearly, \
             an upper bound (ISO 16063-21 D.4)"
                .into(),
        );
    }
    if !budget.correlations.is_empty() && effective.is_finite() {
        evaluation.remarks.push(
            "effective degrees of freedom assume independent components \
             (GUM G.4.1); with correlations they are approximate"
                .into(),
        );
    }
    if evaluation.coverage_basis == CoverageBasis::Stated {
        warn_of_stated_factor(budget, evaluation);
    }
}

/// Tells when a stated factor does not reach the probability of its name.
fn warn_of_stated_factor(budget: &Budget, evaluation: &mut Evaluation) {
    let probability = evaluation.coverage_probability;
    let fitting = coverage::choose(
        super::CoverageRule::Probability(probability),
        &evaluation.components,
        evaluation.combined_standard_uncertainty,
        evaluation.effective_degrees_of_freedom,
        !budget.correlations.is_empty(),
    );
    if (fitting.value / evaluation.coverage_factor - 1.0).abs() > 0.1 {
        evaluation.remarks.push(format!(
            "the stated k = {} is that of a normal distribution; {} asks for \
             k = {:.2} at {:.2} %",
            evaluation.coverage_factor,
            match fitting.basis {
                CoverageBasis::StudentT => format!(
                    "Student's t with {:.1} degrees of freedom",
                    evaluation.effective_degrees_of_freedom
                ),
                _ => "the dominant component's shape".into(),
            },
            fitting.value,
            100.0 * probability,
        ));
    }
}
