//! A share of cases, and how well it is known.

use schemars::JsonSchema;
use serde::Serialize;

/// A share of cases with its 95 % interval (Wilson).
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct Share {
    /// Cases that count.
    pub count: usize,
    /// Cases there are.
    pub of: usize,
    /// Their quotient.
    pub share: f64,
    /// Lower end of the 95 % interval.
    pub low: f64,
    /// Its upper end.
    pub high: f64,
}

impl Share {
    /// Wilson's interval: never outside of 0..1, and not of no width at its ends.
    pub(super) fn new(count: usize, of: usize) -> Self {
        let n = (of as f64).max(1.0);
        let share = count as f64 / n;
        let z = 1.959_963_985_f64;
        let middle = share + z * z / (2.0 * n);
        let half = z * (share * (1.0 - share) / n + z * z / (4.0 * n * n)).sqrt();
        let whole = 1.0 + z * z / n;
        Self {
            count,
            of,
            share,
            low: ((middle - half) / whole).max(0.0),
            high: ((middle + half) / whole).min(1.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_interval_is_wilsons() {
        // Wilson 1927; 8 of 10: 0.4902 .. 0.9433 (R: binom::binom.wilson).
        let share = Share::new(8, 10);
        assert!((share.low - 0.4902).abs() < 1e-4 && (share.high - 0.9433).abs() < 1e-4);
        assert!(Share::new(0, 300).low < f64::EPSILON);
        assert!(Share::new(0, 300).high > 0.01);
    }
}
