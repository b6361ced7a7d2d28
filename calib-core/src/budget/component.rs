//! One line of a budget.

use super::catalogue::Row;
use crate::settings::Distribution;
use core::f32::consts::SQRT_2;

/// An uncertainty component, as a line of Table D.1 of ISO 16063-21.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Component<'a> {
    /// Row of Tables A.1 to A.4 it belongs to.
    pub row: Row,
    /// Name in words.
    pub label: &'a str,
    /// Half-width, or expanded uncertainty for `Normal`, in the unit of the
    /// input quantity; relative in a relative budget.
    pub value: f32,
    /// Probability distribution of the value.
    pub distribution: Distribution,
    /// Partial derivative of the measurand by the input quantity.
    pub sensitivity_coefficient: f32,
    /// Degrees of freedom of the standard uncertainty; `f32::INFINITY` when
    /// its distribution is taken as exactly known.
    pub degrees_of_freedom: f32,
}

impl<'a> Component<'a> {
    /// A component with coefficient 1 and infinite degrees of freedom, labelled
    /// as its row.
    pub fn new(row: Row, value: f32, distribution: Distribution) -> Component<'static> {
        Component {
            row,
            label: row.source(),
            value,
            distribution,
            sensitivity_coefficient: 1.0,
            degrees_of_freedom: f32::INFINITY,
        }
    }

    /// Replaces the label.
    pub fn labelled(self, label: &str) -> Component<'_> {
        Component {
            label,
            row: self.row,
            value: self.value,
            distribution: self.distribution,
            sensitivity_coefficient: self.sensitivity_coefficient,
            degrees_of_freedom: self.degrees_of_freedom,
        }
    }

    /// Sets the degrees of freedom, for type A evaluations.
    pub fn with_degrees_of_freedom(self, degrees_of_freedom: f32) -> Self {
        Self {
            degrees_of_freedom,
            ..self
        }
    }

    /// Sets the sensitivity coefficient.
    pub fn with_sensitivity_coefficient(self, sensitivity_coefficient: f32) -> Self {
        Self {
            sensitivity_coefficient,
            ..self
        }
    }

    /// Standard uncertainty of the input quantity.
    pub fn standard_uncertainty(&self) -> f32 {
        self.value / self.distribution.divisor()
    }

    /// Contribution to the measurand, with its sign:
    /// sensitivity coefficient times standard uncertainty.
    pub fn contribution(&self) -> f32 {
        self.sensitivity_coefficient * self.standard_uncertainty()
    }
}

impl Distribution {
    /// Value over standard uncertainty: the reciprocal of the factor `x_i` of Table D.1.
    ///
    /// | distribution | divisor | variance of |
    /// |---|---|---|
    /// | normal | k | - |
    /// | rectangular | sqrt 3 | uniform in +-1 |
    /// | triangular | sqrt 6 | sum of two equal uniforms |
    /// | U-shaped | sqrt 2 | cosine of a uniform angle (A.1.3) |
    /// | special | as given | - |
    pub fn divisor(self) -> f32 {
        match self {
            Self::Normal { coverage_factor } => coverage_factor,
            // sqrt(3) and sqrt(6) to the nearest f32.
            Self::Rectangular => 1.732_050_8,
            Self::Triangular => 2.449_489_8,
            Self::UShaped => SQRT_2,
            Self::Special { divisor } => divisor,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn divisors_are_the_reciprocal_standard_deviations_of_their_distributions() {
        // Second moments by midpoint sums of each density over +-1, f64.
        let moment = |density: fn(f64) -> f64| {
            let n = 2_000_000;
            let (mut mass, mut second) = (0.0, 0.0);
            for i in 0..n {
                let x = (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
                mass += density(x);
                second += density(x) * x * x;
            }
            (second / mass).sqrt()
        };
        let cases = [
            (Distribution::Rectangular, moment(|_| 1.0), 1.0e-7),
            (Distribution::Triangular, moment(|x| 1.0 - x.abs()), 1.0e-7),
            // The arcsine density is singular at its ends: the sum converges
            // with sqrt(step), 1e-3 here.
            (
                Distribution::UShaped,
                moment(|x| 1.0 / (1.0 - x * x).sqrt()),
                1.0e-3,
            ),
        ];
        for (distribution, expected, tolerance) in cases {
            let divisor = f64::from(distribution.divisor());
            assert!(
                (divisor * expected - 1.0).abs() < tolerance,
                "{distribution:?}"
            );
        }
        let normal = Distribution::Normal {
            coverage_factor: 2.5,
        };
        assert_eq!(normal.divisor(), 2.5);
    }
}
