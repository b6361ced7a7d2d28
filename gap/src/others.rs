//! Causes outside the library: how probable one is beside what was found.
//!
//! A set that leaves more than noise may be the cause in another form, or a substitute of a cause that
//! has no name here. How often it is which follows from sealed sets of both kinds; see
//! [`thresholds::Outside`].

use crate::answer::{Cause, Verdict};
use crate::estimation::gap::Gap;
use crate::thresholds::{self, Outside};

/// Gives causes outside the library their share of the probability, and takes it from those listed.
/// A cause whose size may be zero, or with a value at its bound, gives up more.
pub(crate) fn share_with_others(
    causes: &mut [Cause],
    verdict: Verdict,
    p_value: f64,
    gap: &Gap,
    outside: &Outside,
) -> f64 {
    if matches!(verdict, Verdict::NoGap | Verdict::Data) {
        return 0.0;
    }
    let other = probability(p_value, gap, outside);
    let mut given_up = 0.0;
    for cause in causes {
        let doubts = cause.cautions.len() as i32;
        let kept = cause.probability * thresholds::DOUBTED.powi(doubts);
        given_up += cause.probability - kept;
        cause.probability = kept * (1.0 - other);
    }
    (other + (1.0 - other) * given_up).min(1.0)
}

/// Probability of a cause outside the library by what the best set leaves.
fn probability(p_value: f64, gap: &Gap, outside: &Outside) -> f64 {
    let left = p_value < thresholds::UNEXPLAINED_P_VALUE;
    let decades =
        -p_value.max(thresholds::LEAST_P_VALUE).log10() + thresholds::UNEXPLAINED_P_VALUE.log10();
    let open = 1.0 - gap.size.closed.unwrap_or(0.0).clamp(0.0, 1.0);
    let log_odds = if left {
        outside.left
            + outside.by_decade * decades
            + outside.by_open * (open.max(outside.least_open) / 0.1).ln()
    } else {
        outside.base
    };
    1.0 / (1.0 + (-log_odds).exp())
}
