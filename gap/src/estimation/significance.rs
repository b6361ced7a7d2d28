//! Tail probabilities, and lack of fit: the p-value of the smallest of many dependent tests.

use super::column::{Blocks, Column};
use super::tangent::Tangent;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use statrs::function::gamma::checked_gamma_ur;

/// Draws of pure noise that calibrate the tests.
const DRAWS: usize = 60;
/// Seed of the draws.
const SEED: u64 = 1;

/// Probability that the smallest of the tests' p-values is as small as `here` in pure noise.
///
/// `noise` draws pure noise and gives the smallest p-value of the same tests.
/// m independent tests would have the distribution 1 - (1 - p)^m; the draws give
/// the m that fits them best (maximum likelihood), and with it tails that
/// counting could not reach.
fn of_smallest(here: f64, mut noise: impl FnMut(&mut ChaCha8Rng) -> f64) -> f64 {
    let mut draw = stream(SEED);
    let exceed: f64 = (0..DRAWS)
        .map(|_| -(1.0 - noise(&mut draw)).max(1e-300).ln())
        .sum();
    let tests = DRAWS as f64 / exceed.max(1e-9);
    -libm::expm1(tests * libm::log1p(-here.min(1.0 - 1e-15)))
}

/// Lack of fit: the probability that noise leaves as small a p-value `here` as the data do, once a
/// fit has taken over its part of it.
///
/// `noise` draws data without structure; `smallest` gives the smallest p-value of all tests of what
/// is left of them, of the values the parameters take, and of the data before that.
pub(crate) fn lack_of_fit<B: Copy + PartialEq>(
    here: f64,
    tangent: &Tangent<B>,
    of: &impl Blocks<Block = B>,
    noise: impl Fn(&mut ChaCha8Rng) -> Vec<f64>,
    smallest: impl Fn(&[f64], &[f64], &[f64]) -> f64,
) -> f64 {
    of_smallest(here, |draw| {
        let noise = noise(draw);
        let (left, values) = tangent.reduce(of, &noise);
        smallest(&left, values.as_slice(), &noise)
    })
}

/// Length of a shape without what a fit takes over of it.
///
/// The residual of a fit has the covariance I - T G^-1 T': its product with the shape, over this
/// length, is a standard normal deviate.
pub(crate) fn length_beside<B: Copy + PartialEq>(tangent: &Tangent<B>, shape: &Column<B>) -> f64 {
    let load = tangent.load(shape);
    (shape.norm2() - load.dot(&load)).max(1e-12).sqrt()
}

/// Probability of a larger deviate of either sign.
pub(crate) fn two_sided(z: f64) -> f64 {
    libm::erfc(z.abs() / std::f64::consts::SQRT_2)
}

/// Upper tail of chi-square: the regularised incomplete gamma function.
///
/// `square` is at least 0 and `degrees` above 0; 1.0 where they are not, which is no evidence.
pub(crate) fn chi_square_tail(square: f64, degrees: f64) -> f64 {
    checked_gamma_ur(0.5 * degrees, 0.5 * square).unwrap_or(1.0)
}

/// A stream of random numbers: the same data get the same answer.
pub(crate) fn stream(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

/// Standard normal deviates.
pub(crate) fn normal_deviates(random: &mut ChaCha8Rng, count: usize) -> Vec<f64> {
    StandardNormal.sample_iter(random).take(count).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_distr::StandardUniform;

    /// Of m independent tests the smallest is below p with 1 - (1 - p)^m; 60 draws know m to 13 %,
    /// four of these deviations are allowed.
    #[test]
    fn the_smallest_of_many_tests_is_no_surprise() {
        for tests in [1, 10, 100] {
            let smallest = |draw: &mut ChaCha8Rng| {
                let all = (0..tests).map(|_| StandardUniform.sample(draw));
                all.fold(1.0, f64::min)
            };
            let p = of_smallest(1e-4, smallest);
            let expected = 1e-4 * f64::from(tests);
            assert!((p / expected - 1.0).abs() < 0.52, "{tests}: {p}");
        }
    }

    /// Table of the normal distribution: 5 % lie beyond 1.960; of chi-square: beyond 18.31 with
    /// ten degrees of freedom, where the table rounds to 1e-3; of one, beyond the square of 6 sigma with
    /// the two-sided tail of the normal distribution.
    #[test]
    fn tails_are_those_of_the_tables() {
        assert!((two_sided(1.960) - 0.05).abs() < 1e-4);
        assert!((chi_square_tail(18.307, 10.0) - 0.05).abs() < 1e-5);
        let far = two_sided(6.0);
        assert!((chi_square_tail(36.0, 1.0) / far - 1.0).abs() < 1e-9);
    }
}
