//! Probabilities of false acceptance and false rejection.
//!
//! Two questions: for one result, how probable is it that the true value lies
//! on the other side of the limit ([`inside`]); and for a population of
//! sensors, how often does a rule accept a bad one or reject a good one
//! ([`global`], JCGM 106:2012 clause 9).

use super::limits::Limits;
use statrs::function::erf::{erf, erfc_inv};
use std::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2};

/// Distribution function of the standard normal distribution.
fn normal(z: f64) -> f64 {
    0.5 * (1.0 + erf(z * FRAC_1_SQRT_2))
}

/// Probability that a normally distributed quantity lies inside the limits.
pub fn inside(limits: Limits, mean: f64, standard_deviation: f64) -> f64 {
    let at = |limit: f64| normal((limit - mean) / standard_deviation);
    (at(limits.upper) - at(limits.lower)).clamp(0.0, 1.0)
}

/// Risks over a population of items, and the share that is accepted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlobalRisk {
    /// Probability that an item is bad and accepted.
    pub false_accept: f64,
    /// Probability that an item is good and rejected.
    pub false_reject: f64,
    /// Probability that an item is accepted.
    pub accepted: f64,
}

impl GlobalRisk {
    /// Probability that an accepted item is bad.
    pub fn conditional_false_accept(self) -> f64 {
        self.false_accept / self.accepted
    }
}

/// Spread of items around nominal, relative to a tolerance of +-1, of which
/// this share is good.
pub fn spread_of_items(in_tolerance: f64) -> f64 {
    1.0 / (SQRT_2 * erfc_inv(1.0 - in_tolerance))
}

/// Risks for items that scatter normally around nominal with standard
/// deviation `items`, measured with a normal error of standard deviation
/// `measurement`; both are relative to a tolerance of +-1. Results are accepted
/// inside +-`acceptance` (1 = simple acceptance).
///
/// With a test uncertainty ratio TUR (tolerance over U, k = 2), `measurement` is
/// `0.5 / TUR`.
///
/// # Accuracy
/// 1e-9 (Simpson's rule, 4000 steps); test
/// `published_risks_for_a_ratio_of_four`.
pub fn global(items: f64, measurement: f64, acceptance: f64) -> GlobalRisk {
    let limits = Limits {
        lower: -acceptance,
        upper: acceptance,
    };
    let density = |x: f64| (-0.5 * (x / items).powi(2)).exp() / (items * (2.0 * PI).sqrt());
    let accepted_at = |x: f64| density(x) * inside(limits, x, measurement);
    let rejected_at = |x: f64| density(x) * (1.0 - inside(limits, x, measurement));
    // Beyond ten standard deviations of either nothing is left.
    let far = 1.0 + 10.0 * items.max(measurement);
    let false_accept = 2.0 * simpson(accepted_at, 1.0, far);
    GlobalRisk {
        false_accept,
        false_reject: 2.0 * simpson(rejected_at, 0.0, 1.0),
        accepted: 2.0 * simpson(accepted_at, 0.0, 1.0) + false_accept,
    }
}

fn simpson(of: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    const STEPS: u32 = 4000;
    let width = (to - from) / f64::from(STEPS);
    let weighted = |index: u32| {
        let weight = match index {
            0 | STEPS => 1.0,
            i if i % 2 == 1 => 4.0,
            _ => 2.0,
        };
        weight * of(from + f64::from(index) * width)
    };
    (0..=STEPS).map(weighted).sum::<f64>() * width / 3.0
}

/// Acceptance limits of published guard bands, relative to the tolerance.
pub mod guard_band {
    /// Root of the sum of squares: `sqrt(1 - 1/TUR^2)`.
    pub fn root_sum_square(test_uncertainty_ratio: f64) -> f64 {
        (1.0 - test_uncertainty_ratio.powi(-2)).max(0.0).sqrt()
    }

    /// Tolerance less expanded uncertainty: `1 - 1/TUR`.
    pub fn expanded(test_uncertainty_ratio: f64) -> f64 {
        1.0 - 1.0 / test_uncertainty_ratio
    }

    /// Dobbert: `1 - M / TUR`, `M = 1.04 - exp(0.38 ln TUR - 0.54)`; at most
    /// 2 % false acceptance whatever the items are. No band is needed when M
    /// is negative.
    pub fn dobbert(test_uncertainty_ratio: f64) -> f64 {
        let m = 1.04 - (0.38 * test_uncertainty_ratio.ln() - 0.54).exp();
        1.0 - m.max(0.0) / test_uncertainty_ratio
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Suncal's tests (sandialabs/suncal d44c2cc, test_risk.py), "TUR 4":
    /// in-tolerance probability, false acceptance %, conditional %. Four is
    /// there the ratio of the standard deviations of items and measurement.
    const PUBLISHED: [(f64, f64, f64); 6] = [
        (0.60, 4.838_603_26, 8.260_081_99),
        (0.70, 3.922_341_09, 5.723_220_42),
        (0.80, 2.855_830_37, 3.632_271_45),
        (0.90, 1.599_953_12, 1.798_804_30),
        (0.95, 0.871_009_25, 0.923_896_64),
        (0.99, 0.199_916_84, 0.202_438_66),
    ];

    #[test]
    fn published_risks_for_a_ratio_of_four() {
        for (in_tolerance, false_accept, conditional) in PUBLISHED {
            let items = spread_of_items(in_tolerance);
            let risk = global(items, items / 4.0, 1.0);
            // Theirs is a trapezoidal sum over some thousand places: its error
            // is a millionth of a percent, ours a thousandth of that (an
            // integration with 20 000 places gives 0.871 010 19 at 0.95).
            let close = |ours: f64, theirs: f64| (100.0 * ours - theirs).abs() < 2.0e-6;
            assert!(
                close(risk.false_accept, false_accept),
                "{in_tolerance}: {risk:?}"
            );
            assert!(
                close(risk.conditional_false_accept(), conditional),
                "{in_tolerance}"
            );
        }
    }

    #[test]
    fn deavers_case_of_two_standard_deviations() {
        // SL = 2: the tolerance is two standard deviations of the items.
        // Published: 0.8 % and 1.5 %.
        let risk = global(0.5, 0.5 / 4.0, 1.0);
        assert_eq!(
            format!("{:.3} {:.3}", risk.false_accept, risk.false_reject),
            "0.008 0.015"
        );
    }

    #[test]
    fn guard_bands_are_those_published() {
        assert!((guard_band::root_sum_square(4.0) - 0.968_245_836_6).abs() < 1e-9);
        assert!((guard_band::expanded(4.0) - 0.75).abs() < 1e-12);
        // M(4) = 1.04 - exp(0.38 x 1.386294 - 0.54) = 1.04 - 0.986879 = 0.053121.
        assert!((guard_band::dobbert(4.0) - (1.0 - 0.053_121 / 4.0)).abs() < 1e-6);
    }

    #[test]
    fn dobberts_band_keeps_false_acceptance_below_two_percent() {
        for ratio in [1.5, 2.0, 3.0, 4.0, 6.0] {
            for in_tolerance in [0.5, 0.7, 0.85, 0.95] {
                let items = spread_of_items(in_tolerance);
                let risk = global(items, 0.5 / ratio, guard_band::dobbert(ratio));
                // The fit itself holds 2 % to its second digit.
                assert!(
                    risk.false_accept < 0.0205,
                    "{ratio} {in_tolerance}: {risk:?}"
                );
            }
        }
    }

    #[test]
    fn a_narrower_acceptance_accepts_fewer_bad_and_rejects_more_good() {
        let items = spread_of_items(0.8);
        let wide = global(items, 0.5 / 3.0, 1.0);
        let narrow = global(items, 0.5 / 3.0, 0.8);
        assert!(narrow.false_accept < wide.false_accept);
        assert!(narrow.false_reject > wide.false_reject);
    }
}
