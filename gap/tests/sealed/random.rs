//! Random numbers of the cases (xorshift64*, Box and Muller's normal numbers).

use std::f64::consts::TAU;

const MULTIPLIER: u64 = 0x2545_F491_4F6C_DD1D;

/// State, and the second of two normal numbers.
pub(crate) struct Random(u64, Option<f64>);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        let state = seed.wrapping_mul(MULTIPLIER) ^ 0x1234_5678_9ABC_DEF1;
        let mut random = Self(state, None);
        for _ in 0..10 {
            random.uniform();
        }
        random
    }

    /// 0 to 1, without 1.
    pub(crate) fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(MULTIPLIER) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Mean 0, standard deviation 1.
    pub(crate) fn normal(&mut self) -> f64 {
        if let Some(second) = self.1.take() {
            return second;
        }
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        let (sin, cos) = (TAU * self.uniform()).sin_cos();
        self.1 = Some(radius * sin);
        radius * cos
    }

    /// 1 with a relative standard deviation.
    pub(crate) fn gain(&mut self, u_rel: f64) -> f64 {
        1.0 + u_rel * self.normal()
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// Uniform in the logarithm.
    pub(crate) fn log_between(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.uniform())
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        ((self.uniform() * n as f64) as usize).min(n - 1)
    }

    /// 1 or -1.
    pub(crate) fn sign(&mut self) -> f64 {
        if self.uniform() < 0.5 { -1.0 } else { 1.0 }
    }
}
