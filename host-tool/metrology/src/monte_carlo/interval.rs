//! Coverage intervals of sampled values.

use schemars::JsonSchema;
use serde::Serialize;

/// A coverage interval, in the unit of the values.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Interval {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// Probabilistically symmetric and shortest coverage interval.
///
/// `values` are reordered; only the tails are sorted. At least
/// `2 / (1 - probability)` values are needed, and all must be finite.
///
/// # Source
/// GUM-S1 (JCGM 101:2008) 7.7.1 to 7.7.4.
pub fn coverage_intervals(values: &mut [f64], probability: f64) -> (Interval, Interval) {
    let count = values.len();
    let covered = ((probability * count as f64).round() as usize).clamp(1, count - 1);
    // Positions 0 .. tail may be lower ends, covered .. count upper ends.
    let tail = count - covered;
    sort_ends(values, tail);
    let symmetric = tail.div_ceil(2).min(tail - 1);
    let at = |low: usize| Interval {
        low: values[low],
        high: values[low + covered],
    };
    let mut shortest = 0;
    for low in 1..tail {
        let (best, this) = (at(shortest), at(low));
        if this.high - this.low < best.high - best.low {
            shortest = low;
        }
    }
    (at(symmetric), at(shortest))
}

/// Sorts the lowest and the highest `tail` values into their places.
fn sort_ends(values: &mut [f64], tail: usize) {
    let count = values.len();
    if 2 * tail >= count {
        values.sort_unstable_by(f64::total_cmp);
        return;
    }
    values.select_nth_unstable_by(count - tail, f64::total_cmp);
    values[count - tail..].sort_unstable_by(f64::total_cmp);
    values[..count - tail].select_nth_unstable_by(tail, f64::total_cmp);
    values[..tail].sort_unstable_by(f64::total_cmp);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_of_known_values() {
        // 0..1000 shuffled: every interval of 950 steps is 950 wide.
        let mut values: Vec<f64> = (0..1000).map(|n| f64::from(n * 7919 % 1000)).collect();
        let (symmetric, shortest) = coverage_intervals(&mut values, 0.95);
        assert_eq!((symmetric.low, symmetric.high), (25.0, 975.0));
        assert_eq!(shortest.high - shortest.low, 950.0);
    }

    #[test]
    fn the_shortest_interval_of_an_exponential_begins_at_zero() {
        // Quantiles of exp(1): x = -ln(1 - (n + 0.5) / N).
        let count = 20_000;
        let mut values: Vec<f64> = (0..count)
            .map(|n| -(1.0 - (f64::from(n) + 0.5) / f64::from(count)).ln())
            .collect();
        values.reverse();
        let (symmetric, shortest) = coverage_intervals(&mut values, 0.95);
        assert!(shortest.low < 1.0e-4);
        // One rank is 1/N in probability, 1/(N (1-p)) = 1e-3 in x here.
        assert!((shortest.high - 20.0_f64.ln()).abs() < 2.0e-3);
        assert!((symmetric.low + 0.975_f64.ln()).abs() < 1.0e-3);
    }
}
