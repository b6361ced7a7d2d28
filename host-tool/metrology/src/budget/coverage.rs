//! The coverage factor: k = 2, Student's t, or a dominant rectangular shape.
//!
//! A few rectangular contributions that dominate make the output rectangular
//! or trapezoidal rather than normal; a type A contribution with few
//! observations makes it a t-distribution. k = 2 holds for neither.
//!
//! # Source
//! ISO 16063-21 A.1.5 and A.2.1 Note 2; GUM G.3, G.4; EA-4/02 S9.14, S10.13.

use super::contribution::EvaluatedComponent;
use crate::statistics;
use schemars::JsonSchema;
use serde::Serialize;

/// Coverage the author of the budget asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CoverageRule {
    /// This factor, whatever the shape.
    Factor(f64),
    /// The factor that gives this probability for the shape found.
    Probability(f64),
    /// k = 2 where the output is normal, else the factor of 95.45 %.
    Default,
}

/// Basis of the coverage factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CoverageBasis {
    /// Stated in the budget.
    Stated,
    /// k = 2, the output being close to normal (A.1.5).
    Normal,
    /// Student's t at the effective degrees of freedom (GUM G.4).
    StudentT,
    /// One rectangular contribution dominates.
    Rectangular,
    /// Two rectangular contributions dominate together.
    Trapezoidal,
    /// One u-shaped contribution dominates.
    UShaped,
    /// One triangular contribution dominates.
    Triangular,
}

/// Coverage factor with its basis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoverageFactor {
    /// Factor k.
    pub value: f64,
    /// Probability it stands for; for a stated factor that of a normal law.
    pub probability: f64,
    /// Basis.
    pub basis: CoverageBasis,
}

/// Contributions whose rest is at most this share of them dominate. EA-4/02
/// writes 0.3, one digit, and applies it to S11 where the share is 0.34.
const DOMINANCE: f64 = 0.35;
/// Effective degrees of freedom from which k = 2 stands (A.2.1 Note 2).
const NORMAL_DEGREES_OF_FREEDOM: f64 = 10.0;
/// Probability of k = 2 in a normal distribution.
const TWO_SIGMA: f64 = 0.954_499_736_103_642;

/// Chooses the factor for a combined standard uncertainty.
pub(super) fn choose(
    rule: CoverageRule,
    components: &[EvaluatedComponent],
    combined: f64,
    degrees_of_freedom: f64,
    correlated: bool,
) -> CoverageFactor {
    let shape = match correlated {
        true => None,
        false => dominant_shape(components, combined),
    };
    let at = |probability: f64| match shape {
        Some(shape) => shape.factor(probability),
        None => CoverageFactor {
            value: statistics::student_factor(probability, degrees_of_freedom),
            probability,
            basis: CoverageBasis::StudentT,
        },
    };
    match rule {
        CoverageRule::Factor(value) => CoverageFactor {
            value,
            probability: statistics::normal_probability(value),
            basis: CoverageBasis::Stated,
        },
        CoverageRule::Probability(probability) => at(probability),
        CoverageRule::Default if shape.is_none() && is_normal(degrees_of_freedom) => {
            CoverageFactor {
                value: 2.0,
                probability: TWO_SIGMA,
                basis: CoverageBasis::Normal,
            }
        }
        CoverageRule::Default => at(TWO_SIGMA),
    }
}

fn is_normal(degrees_of_freedom: f64) -> bool {
    degrees_of_freedom > NORMAL_DEGREES_OF_FREEDOM
}

/// Shape of an output that its largest contributions dominate.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    Rectangular,
    Triangular,
    UShaped,
    /// Difference over sum of the two half-widths.
    Trapezoidal {
        beta: f64,
    },
}

impl Shape {
    fn factor(self, probability: f64) -> CoverageFactor {
        let p = probability;
        let (value, basis) = match self {
            Self::Rectangular => (p * 3.0_f64.sqrt(), CoverageBasis::Rectangular),
            Self::Triangular => (trapezoidal_factor(p, 0.0), CoverageBasis::Triangular),
            // The arcsine law holds p within a sin(pi p / 2).
            Self::UShaped => (
                2.0_f64.sqrt() * (std::f64::consts::FRAC_PI_2 * p).sin(),
                CoverageBasis::UShaped,
            ),
            Self::Trapezoidal { beta } => (trapezoidal_factor(p, beta), CoverageBasis::Trapezoidal),
        };
        CoverageFactor {
            value,
            probability,
            basis,
        }
    }
}

/// Coverage factor of a symmetric trapezoidal distribution.
///
/// # Equation
/// Two rectangular laws of half-widths `a1 > a2` give a trapezoid of
/// half-base `a = a1 + a2` and half-top `beta a`, `beta = (a1 - a2)/(a1 + a2)`,
/// with u = a sqrt((1 + beta^2)/6). While the interval ends on the slopes,
/// `k = (1 - sqrt((1 - p)(1 - beta^2))) / sqrt((1 + beta^2)/6)`; before that,
/// below the flat top, `k = p (1 + beta) / 2 / sqrt((1 + beta^2)/6)`.
///
/// # Source
/// EA-4/02 S10.13, derived above; beta = 0 is triangular, 1 rectangular.
pub fn trapezoidal_factor(probability: f64, beta: f64) -> f64 {
    let scale = ((1.0 + beta * beta) / 6.0).sqrt();
    let on_top = 2.0 * beta / (1.0 + beta);
    match probability <= on_top {
        true => probability * (1.0 + beta) / 2.0 / scale,
        false => (1.0 - ((1.0 - probability) * (1.0 - beta * beta)).sqrt()) / scale,
    }
}

fn dominant_shape(components: &[EvaluatedComponent], combined: f64) -> Option<Shape> {
    let mut order: Vec<&EvaluatedComponent> = components.iter().collect();
    order.sort_by(|a, b| b.contribution.total_cmp(&a.contribution));
    let first = *order.first()?;
    if dominates(first.contribution.powi(2), combined) {
        return match first.distribution {
            "rectangular" => Some(Shape::Rectangular),
            "triangular" => Some(Shape::Triangular),
            "u_shaped" => Some(Shape::UShaped),
            _ => None,
        };
    }
    let second = *order.get(1)?;
    let both = first.contribution.powi(2) + second.contribution.powi(2);
    let rectangular = first.distribution == "rectangular" && second.distribution == "rectangular";
    (rectangular && dominates(both, combined)).then(|| Shape::Trapezoidal {
        beta: (first.contribution - second.contribution)
            / (first.contribution + second.contribution),
    })
}

fn dominates(variance: f64, combined: f64) -> bool {
    let rest = (combined * combined - variance).max(0.0);
    rest.sqrt() <= DOMINANCE * variance.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_trapezoid_ends_in_the_rectangle_and_the_triangle() {
        let rectangle = 0.95 * 3.0_f64.sqrt();
        assert!((trapezoidal_factor(0.95, 1.0) - rectangle).abs() < 1.0e-12);
        // Triangular law: 1 - p = (1 - x/a)^2 and u = a / sqrt(6).
        let triangle = (1.0 - 0.05_f64.sqrt()) * 6.0_f64.sqrt();
        assert!((trapezoidal_factor(0.95, 0.0) - triangle).abs() < 1.0e-12);
        // Continuous where the interval leaves the flat top.
        let beta: f64 = 0.6;
        let corner = 2.0 * beta / (1.0 + beta);
        let step = trapezoidal_factor(corner + 1e-9, beta) - trapezoidal_factor(corner, beta);
        assert!(step.abs() < 1.0e-8);
    }
}
