//! Random numbers of the cases (xorshift64*, Marsaglia's polar method).

pub(crate) struct Random(u64, Option<f64>);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        let mut r = Self(
            seed.wrapping_mul(0x2545_F491_4F6C_DD1D) ^ 0x1234_5678_9abc_def1,
            None,
        );
        for _ in 0..10 {
            r.uniform();
        }
        r
    }
    pub(crate) fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 53) as f64
    }
    pub(crate) fn normal(&mut self) -> f64 {
        if let Some(v) = self.1.take() {
            return v;
        }
        let (r, a) = (
            (-2.0 * (1.0 - self.uniform()).ln()).sqrt(),
            std::f64::consts::TAU * self.uniform(),
        );
        self.1 = Some(r * a.sin());
        r * a.cos()
    }
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }
    pub(crate) fn log_between(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.uniform())
    }
    pub(crate) fn below(&mut self, n: usize) -> usize {
        ((self.uniform() * n as f64) as usize).min(n - 1)
    }
    pub(crate) fn sign(&mut self) -> f64 {
        if self.uniform() < 0.5 { -1.0 } else { 1.0 }
    }
}
