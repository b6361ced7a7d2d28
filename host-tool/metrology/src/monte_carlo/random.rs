//! Random numbers many at a time, the same on every machine.
//!
//! xoshiro256++ (Blackman and Vigna 2021) in independent lanes: the loops over
//! lanes have no branches and no dependence, so the compiler turns them into
//! vector instructions. Every lane is seeded from ChaCha8 by seed and stream
//! number; blocks of trials can be drawn in any order and on any number of
//! cores with one result.

use super::elementary::{cos_sin_turn, ln};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Numbers drawn together: enough that the loop over them stays a loop.
pub(super) const LANES: usize = 64;

/// Values below 2^52 in the mantissa of a number in 1 to 2.
const ONE_TO_TWO: u64 = 0x3FF0_0000_0000_0000;

/// Generators side by side.
#[derive(Clone, Debug)]
pub struct Lanes {
    state: [[u64; LANES]; 4],
}

impl Lanes {
    /// The generators of one stream of a seed.
    pub fn new(seed: u64, stream: u64) -> Self {
        let mut source = ChaCha8Rng::seed_from_u64(seed);
        source.set_stream(stream);
        let mut state = [[0; LANES]; 4];
        for word in state.iter_mut().flatten() {
            *word = source.next_u64();
        }
        Self { state }
    }

    #[inline(always)]
    fn next_into(&mut self, out: &mut [u64; LANES]) {
        let [s0, s1, s2, s3] = &mut self.state;
        for lane in 0..LANES {
            let (a, b, c, d) = (s0[lane], s1[lane], s2[lane], s3[lane]);
            out[lane] = a.wrapping_add(d).rotate_left(23).wrapping_add(a);
            let (c, d) = (c ^ a, d ^ b);
            s1[lane] = b ^ c;
            s0[lane] = a ^ d;
            s2[lane] = c ^ (b << 17);
            s3[lane] = d.rotate_left(45);
        }
    }

    /// Uniform in [0, 1), 52 bits.
    #[inline(always)]
    pub(super) fn uniform_into(&mut self, out: &mut [f64; LANES]) {
        let mut bits = [0; LANES];
        self.next_into(&mut bits);
        for lane in 0..LANES {
            out[lane] = f64::from_bits((bits[lane] >> 12) | ONE_TO_TWO) - 1.0;
        }
    }

    /// Two sets of independent standard normal numbers (Box and Muller 1958).
    ///
    /// # Accuracy
    /// Exact in distribution up to the 52 bits of the radius: nothing beyond
    /// 8.4 standard deviations. Test `normal_numbers_have_normal_moments`.
    #[inline(always)]
    pub(super) fn normal_into(&mut self, first: &mut [f64; LANES], second: &mut [f64; LANES]) {
        self.uniform_into(first);
        self.uniform_into(second);
        for lane in 0..LANES {
            let length = (-2.0 * ln(1.0 - first[lane])).sqrt();
            let (cos, sin) = cos_sin_turn(second[lane]);
            first[lane] = length * cos;
            second[lane] = length * sin;
        }
    }

    /// Fills a slice with numbers uniform in [0, 1).
    pub fn fill_uniform(&mut self, out: &mut [f64]) {
        let mut numbers = [0.0; LANES];
        for chunk in out.chunks_mut(LANES) {
            self.uniform_into(&mut numbers);
            let count = chunk.len();
            chunk.copy_from_slice(&numbers[..count]);
        }
    }

    /// Fills a slice with standard normal numbers.
    #[inline(always)]
    pub fn fill_normal(&mut self, out: &mut [f64]) {
        let (mut first, mut second) = ([0.0; LANES], [0.0; LANES]);
        for chunk in out.chunks_mut(2 * LANES) {
            self.normal_into(&mut first, &mut second);
            let cut = chunk.len().min(LANES);
            chunk[..cut].copy_from_slice(&first[..cut]);
            let rest = chunk.len() - cut;
            chunk[cut..].copy_from_slice(&second[..rest]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn next(lanes: &mut Lanes) -> [u64; LANES] {
        let mut out = [0; LANES];
        lanes.next_into(&mut out);
        out
    }

    #[test]
    fn the_generator_is_xoshiro256plusplus() {
        // First outputs for the state 1, 2, 3, 4 of the reference code
        // (prng.di.unimi.it/xoshiro256plusplus.c).
        let mut lanes = Lanes {
            state: [[1; LANES], [2; LANES], [3; LANES], [4; LANES]],
        };
        let first: Vec<u64> = (0..4).map(|_| next(&mut lanes)[5]).collect();
        assert_eq!(
            first,
            [
                41_943_041,
                58_720_359,
                3_588_806_011_781_223,
                3_591_011_842_654_386
            ]
        );
    }

    #[test]
    fn streams_differ_and_repeat() {
        assert_eq!(next(&mut Lanes::new(7, 3)), next(&mut Lanes::new(7, 3)));
        assert_ne!(next(&mut Lanes::new(7, 3)), next(&mut Lanes::new(7, 4)));
        assert_ne!(next(&mut Lanes::new(8, 3)), next(&mut Lanes::new(7, 3)));
    }

    #[test]
    fn normal_numbers_have_normal_moments() {
        let mut lanes = Lanes::new(1, 0);
        let mut values = vec![0.0; 1_000_000];
        lanes.fill_normal(&mut values);
        let n = values.len() as f64;
        let moment = |power: i32| values.iter().map(|x| x.powi(power)).sum::<f64>() / n;
        // Five standard errors: variances 1, 2, 15, 96 of x, x^2, x^3, x^4.
        for (power, expected, variance) in
            [(1, 0.0, 1.0), (2, 1.0, 2.0), (3, 0.0, 15.0), (4, 3.0, 96.0)]
        {
            let limit = 5.0 * (variance / n as f64).sqrt();
            let got = moment(power);
            assert!((got - expected).abs() < limit, "moment {power}: {got}");
        }
        // Tail beyond three standard deviations, 0.27 %.
        let tail = values.iter().filter(|x| x.abs() > 3.0).count() as f64 / n;
        assert!(
            (tail - 0.002_699_8).abs() < 5.0 * (0.0027 / n).sqrt(),
            "{tail}"
        );
    }
}
