//! Tail probabilities, and lack of fit: the p-value of the smallest of many dependent tests.

use super::column::{Blocks, Column};
use super::tangent::Tangent;

/// Draws of pure noise that calibrate the tests.
const DRAWS: usize = 60;
/// Seed of the draws: the same data get the same answer.
const SEED: u64 = 0x9e37_79b9_7f4a_7c15;

/// Probability that the smallest of the tests' p-values is as small as `here` in pure noise.
///
/// `noise` draws pure noise and gives the smallest p-value of the same tests.
/// m independent tests would have the distribution 1 - (1 - p)^m; the draws give
/// the m that fits them best (maximum likelihood), and with it tails that
/// counting could not reach.
fn of_smallest(here: f64, mut noise: impl FnMut(&mut Gauss) -> f64) -> f64 {
    let mut draw = Gauss::new(SEED);
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
    noise: impl Fn(&mut Gauss) -> Vec<f64>,
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

/// Upper tail of chi-square by the cube-root transformation of Wilson and Hilferty.
pub(crate) fn chi_square_tail(square: f64, degrees: f64) -> f64 {
    let spread = 2.0 / (9.0 * degrees);
    let z = ((square / degrees).cbrt() - 1.0 + spread) / spread.sqrt();
    0.5 * libm::erfc(z / std::f64::consts::SQRT_2)
}

/// Normal deviates from a seed: the sum of a table-free polar method.
pub(crate) struct Gauss {
    state: u64,
    spare: Option<f64>,
}

impl Gauss {
    pub(crate) fn new(seed: u64) -> Self {
        Self {
            state: seed,
            spare: None,
        }
    }

    pub(crate) fn uniform(&mut self) -> f64 {
        // splitmix64 (Steele, Lea, Flood 2014).
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(crate) fn next(&mut self) -> f64 {
        if let Some(value) = self.spare.take() {
            return value;
        }
        loop {
            let (x, y) = (2.0 * self.uniform() - 1.0, 2.0 * self.uniform() - 1.0);
            let s = x * x + y * y;
            if s > 0.0 && s < 1.0 {
                let factor = (-2.0 * s.ln() / s).sqrt();
                self.spare = Some(y * factor);
                return x * factor;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of m independent tests the smallest is below p with 1 - (1 - p)^m; 60 draws know m to 13 %,
    /// four of these deviations are allowed.
    #[test]
    fn the_smallest_of_many_tests_is_no_surprise() {
        for tests in [1, 10, 100] {
            let smallest = |draw: &mut Gauss| {
                let all = (0..tests).map(|_| draw.uniform());
                all.fold(1.0, f64::min)
            };
            let p = of_smallest(1e-4, smallest);
            let expected = 1e-4 * f64::from(tests);
            assert!((p / expected - 1.0).abs() < 0.52, "{tests}: {p}");
        }
    }

    /// Table of the normal distribution: 5 % lie beyond 1.960; of chi-square: beyond 18.31 with
    /// ten degrees of freedom. Wilson and Hilferty are good to 0.0005 there.
    #[test]
    fn tails_are_those_of_the_tables() {
        assert!((two_sided(1.960) - 0.05).abs() < 1e-4);
        assert!((chi_square_tail(18.307, 10.0) - 0.05).abs() < 5e-4);
    }
}
