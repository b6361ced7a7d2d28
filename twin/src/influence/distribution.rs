//! Distributions of the influence quantities of a budget, and drawing from them.

use std::f64::consts::TAU;

use rand::RngExt;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution as _, StandardNormal};

/// Probability distribution a budget assumes for a bound `b` it states.
///
/// # Source
/// ISO 16063-21:2003, A.1.3 and Table D.1 with its note 3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// `b` is an expanded uncertainty with this coverage factor: `u = b / k`.
    Normal {
        /// Coverage factor k.
        coverage_factor: f64,
    },
    /// Even between `-b` and `b`: `u = b / sqrt(3)`.
    Rectangular,
    /// Triangular between `-b` and `b`: `u = b / sqrt(6)`.
    Triangular,
    /// A sine of amplitude `b` at a random time: `u = b / sqrt(2)`.
    UShaped,
    /// Transverse sensitivity times transverse acceleration times the cosine of the angle between
    /// them, each factor evenly distributed in its bounds: `u = b / sqrt(18)`.
    Transverse,
}

impl Distribution {
    /// A value for the bound `bound`.
    pub(super) fn draw(self, bound: f64, random: &mut ChaCha12Rng) -> f64 {
        let mut even = || random.random_range(-1.0..=1.0);
        bound
            * match self {
                Self::Rectangular => even(),
                Self::Triangular => (even() + even()) / 2.0,
                Self::UShaped => random.random_range(0.0..TAU).sin(),
                Self::Transverse => {
                    let (sensitivity, acceleration) = (even(), even());
                    sensitivity * acceleration * random.random_range(0.0..TAU).cos()
                }
                Self::Normal { coverage_factor } => {
                    let unit: f64 = StandardNormal.sample(random);
                    unit / coverage_factor
                }
            }
    }
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;

    use super::*;

    #[test]
    fn every_distribution_has_the_standard_uncertainty_of_the_budget() {
        let mut random = ChaCha12Rng::seed_from_u64(5);
        let count = 200_000;
        for (distribution, divisor) in [
            (
                Distribution::Normal {
                    coverage_factor: 2.0,
                },
                2.0,
            ),
            (Distribution::Rectangular, 3.0_f64.sqrt()),
            (Distribution::Triangular, 6.0_f64.sqrt()),
            (Distribution::UShaped, 2.0_f64.sqrt()),
            (Distribution::Transverse, 18.0_f64.sqrt()),
        ] {
            let draws: Vec<f64> = (0..count)
                .map(|_| distribution.draw(0.3, &mut random))
                .collect();
            let mean = draws.iter().sum::<f64>() / f64::from(count);
            let square = draws.iter().map(|draw| draw * draw).sum::<f64>() / f64::from(count);
            let standard = 0.3 / divisor;
            // Standard error of the mean 0.22 %; of the deviation at most 0.32 % (kurtosis of the
            // product below 9: sqrt(8/4/n)); five of each.
            assert!(mean.abs() < 0.012 * standard, "{distribution:?} {mean}");
            assert!(
                (square.sqrt() / standard - 1.0).abs() < 0.017,
                "{distribution:?}"
            );
        }
    }
}
