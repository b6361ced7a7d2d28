//! Coverage factor and expanded uncertainty.

use super::catalogue::Row;
use super::combine::{Budget, BudgetError, Combined};
use super::component::Component;
use super::student::student_quantile;
use crate::settings::Distribution;

/// Probability that belongs to `k = 2` of a normal distribution.
pub const PROBABILITY_K2: f32 = 0.954_499_7;

/// Effective degrees of freedom from which `k = 2` is kept: Student's factor
/// for 95.45 % is 2.05 there.
const NORMAL_FROM: f32 = 50.0;

/// Rest of the budget, relative to what dominates it, up to which the
/// dominating distribution decides. EA-4/02 S9.14 writes 0.3, one digit, and
/// its S11 applies it to a rest of 0.34.
const DOMINANCE_REL: f32 = 0.35;

/// How the coverage factor is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CoverageRule {
    /// This factor, whatever the budget.
    Fixed(f32),
    /// The factor for this coverage probability, by the shape of the budget:
    /// Student's t for few effective degrees of freedom, rectangle or
    /// trapezoid where one or two rectangular components dominate, normal
    /// else. [`PROBABILITY_K2`] gives exactly 2 for a normal result.
    Probability(f32),
}

/// Shape of the distribution the factor was taken from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Normal, or as asked.
    Normal,
    /// Student's t with these (whole) degrees of freedom.
    Student(f32),
    /// One rectangular component dominates.
    Rectangular,
    /// Two rectangular components dominate; `edge` is the flat part over the
    /// base.
    Trapezoidal {
        /// Flat part over base, 0 for a triangle, 1 for a rectangle.
        edge: f32,
    },
}

/// Coverage factor and where it came from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coverage {
    /// Factor k.
    pub factor: f32,
    /// Shape it was taken from.
    pub shape: Shape,
}

/// The whole result of a budget, in the unit of its contributions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expanded {
    /// Combined standard uncertainty.
    pub standard_uncertainty: f32,
    /// Effective degrees of freedom; may be infinite.
    pub effective_degrees_of_freedom: f32,
    /// Coverage factor and shape.
    pub coverage: Coverage,
    /// Expanded uncertainty.
    pub expanded_uncertainty: f32,
}

impl Expanded {
    /// The result as a component of another budget: a working reference that
    /// was calibrated by the reference (A.2.1, Note 1), or row 1 of Tables A.3
    /// and A.4.
    pub fn as_component(&self, row: Row) -> Component<'static> {
        let normal = Distribution::Normal {
            coverage_factor: 1.0,
        };
        Component::new(row, self.standard_uncertainty, normal)
            .with_degrees_of_freedom(self.effective_degrees_of_freedom)
    }
}

impl Budget<'_> {
    /// Combines the components and expands the result.
    ///
    /// # Errors
    /// Those of [`Budget::combine`].
    pub fn expand(&self, rule: CoverageRule) -> Result<Expanded, BudgetError> {
        let combined = self.combine()?;
        let coverage = match rule {
            CoverageRule::Fixed(factor) => Coverage {
                factor,
                shape: Shape::Normal,
            },
            CoverageRule::Probability(probability) => self.coverage(combined, probability),
        };
        Ok(Expanded {
            standard_uncertainty: combined.standard_uncertainty,
            effective_degrees_of_freedom: combined.effective_degrees_of_freedom,
            coverage,
            expanded_uncertainty: coverage.factor * combined.standard_uncertainty,
        })
    }

    fn coverage(&self, combined: Combined, probability: f32) -> Coverage {
        if let Some(shape) = self.dominated(combined.standard_uncertainty) {
            let edge = match shape {
                Shape::Trapezoidal { edge } => edge,
                _ => 1.0,
            };
            let factor = trapezoid_factor(probability, edge);
            return Coverage { factor, shape };
        }
        student_or_normal(combined.effective_degrees_of_freedom, probability)
    }

    /// The shape when one or two rectangular components leave no more than
    /// 0.35 of themselves to all the others.
    fn dominated(&self, standard_uncertainty: f32) -> Option<Shape> {
        if self.has_correlations() {
            return None;
        }
        let [first, second] = self.largest_rectangular();
        let total = standard_uncertainty * standard_uncertainty;
        let rest_small = |part: f32| total - part <= DOMINANCE_REL * DOMINANCE_REL * part;
        if first <= 0.0 {
            None
        } else if rest_small(first * first) {
            Some(Shape::Rectangular)
        } else if rest_small(first * first + second * second) {
            let edge = (first - second) / (first + second);
            Some(Shape::Trapezoidal { edge })
        } else {
            None
        }
    }

    /// The two largest contributions of rectangular components.
    fn largest_rectangular(&self) -> [f32; 2] {
        let rectangular = |c: &&Component<'_>| c.distribution == Distribution::Rectangular;
        let mut largest = [0.0_f32; 2];
        for component in self.components().iter().filter(rectangular) {
            let size = component.contribution().abs();
            if size > largest[0] {
                largest = [size, largest[0]];
            } else if size > largest[1] {
                largest[1] = size;
            }
        }
        largest
    }
}

/// Student's factor for the next lower whole number of degrees of freedom
/// (GUM G.4.1), or the normal one from 50 on.
fn student_or_normal(degrees_of_freedom: f32, probability: f32) -> Coverage {
    let tail = 1.0 - probability;
    if degrees_of_freedom >= NORMAL_FROM {
        let normal = student_quantile(tail, f32::INFINITY);
        let factor = if probability == PROBABILITY_K2 {
            Some(2.0)
        } else {
            normal
        };
        return Coverage {
            factor: factor.unwrap_or(2.0),
            shape: Shape::Normal,
        };
    }
    let whole = libm::floorf(degrees_of_freedom).max(1.0);
    Coverage {
        factor: student_quantile(tail, whole).unwrap_or(2.0),
        shape: Shape::Student(whole),
    }
}

/// Coverage factor of a symmetric trapezoid with flat part `edge` of its base.
///
/// # Equation
/// With half-base `a`, `u = a sqrt((1 + edge^2) / 6)` and
/// `k u = a (1 - sqrt((1 - p)(1 - edge^2)))` while that lies on the slope, else
/// `k u = a p (1 + edge) / 2` on the flat part. `edge = 1` is the rectangle
/// (`k = sqrt(3) p`), `edge = 0` the triangle.
///
/// # Source
/// EA-4/02 M:2022, S9 and S10.
pub fn trapezoid_factor(probability: f32, edge: f32) -> f32 {
    let spread = libm::sqrtf((1.0 + edge * edge) / 6.0);
    let slope = 1.0 - libm::sqrtf((1.0 - probability) * (1.0 - edge * edge));
    let flat = 0.5 * probability * (1.0 + edge);
    // Probability of the flat part alone.
    let on_slope = probability > 2.0 * edge / (1.0 + edge);
    let quantile = if on_slope { slope } else { flat };
    quantile / spread
}
