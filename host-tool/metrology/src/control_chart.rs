//! Control chart of a check standard: whether its latest result belongs to those before it.
//!
//! Limits come from the results themselves, by their successive differences, which a slow drift does not
//! widen. There are few: the limits are those in which one more result is found in 99.73 % (Student's t),
//! wide for six results and close to three standard deviations for fifty. Runs show what stays within them.
//!
//! # Source
//! ISO/IEC 17025:2017, 7.7.1; rules for runs: ISO 7870-2:2023, the second and third of Nelson's tests; variance of
//! the estimate by successive differences: von Neumann et al., Ann. Math. Statist. 12 (1941), 153.

use crate::statistics::{mean, student_factor};
use schemars::JsonSchema;
use serde::Serialize;
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

/// Fewest results, the latest included.
pub const FEWEST: usize = 6;
/// Share of sound results within the limits: three standard deviations of a normal distribution.
const WITHIN: f64 = 0.9973;
/// Results in a row on one side of the mean: 2 in 2^9, 0.4 %, of sound series.
const ONE_SIDE: usize = 9;
/// Results in a row that all rise or all fall: 2 in 6!, 0.3 %, of sound series.
const TREND: usize = 6;

/// Latest results whose scatter is compared with that of at least as many before.
const LATEST: usize = 6;

/// Why the latest result does not belong to those before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Signal {
    /// It is outside of the limits.
    OutsideLimits,
    /// The last nine are on one side of the mean.
    OneSide,
    /// The last six rise, or fall, one by one.
    Trend,
    /// The last six scatter more than those before.
    Scatter,
}

impl Signal {
    /// For a person.
    pub fn text(self) -> &'static str {
        match self {
            Self::OutsideLimits => "the latest result is outside of the limits",
            Self::OneSide => "the last nine results are on one side of the mean",
            Self::Trend => "the last six results all rise, or all fall",
            Self::Scatter => "the last six results scatter more than those before",
        }
    }
}

/// The chart of a series, in the unit of its values.
#[derive(Clone, Debug, PartialEq)]
pub struct ControlChart {
    /// Mean of the results before the latest.
    pub mean: f64,
    /// Their standard deviation, by successive differences.
    pub standard_deviation: f64,
    /// Effective degrees of freedom of that.
    pub degrees_of_freedom: f64,
    /// Half the width of the limits around the mean.
    pub half_width: f64,
    /// Limit of the differences between successive results, which sound ones exceed in 0.92 %.
    pub range_limit: f64,
    /// Signals against the latest result; empty when it is in control.
    pub signals: Vec<Signal>,
}

/// Judges the last of these values, oldest first; none below [`FEWEST`].
///
/// # Accuracy
/// Of sound normal series of 12 and 30 results 0.2 to 0.5 % are outside of the limits, of 6 results 0.1 %, test
/// `sound_series_are_seldom_outside`.
pub fn control_chart(values: &[f64]) -> Option<ControlChart> {
    let (latest, before) = values.split_last()?;
    if values.len() < FEWEST {
        return None;
    }
    let n = before.len() as f64;
    let (variance, degrees_of_freedom) = by_differences(before);
    let standard_deviation = variance.sqrt();
    let centre = mean(before);
    let factor = student_factor(WITHIN, degrees_of_freedom);
    let half_width = factor * standard_deviation * (1.0 + 1.0 / n).sqrt();
    let signals = [
        ((latest - centre).abs() > half_width, Signal::OutsideLimits),
        (is_on_one_side(values, centre), Signal::OneSide),
        (is_a_trend(values), Signal::Trend),
        (scatter_more(values), Signal::Scatter),
    ];
    let signals = signals.into_iter().filter(|(there, _)| *there);
    Some(ControlChart {
        mean: centre,
        standard_deviation,
        degrees_of_freedom,
        half_width,
        range_limit: RANGE_LIMIT * mean_range(before),
        signals: signals.map(|(_, signal)| signal).collect(),
    })
}

/// Limit of a moving range of two, over their mean: 1 + 3 x 0.8525 / 1.128 (ISO 7870-2, D4).
const RANGE_LIMIT: f64 = 3.267;

/// Mean of the differences between successive values.
fn mean_range(values: &[f64]) -> f64 {
    let ranges: Vec<f64> = values
        .windows(2)
        .map(|pair| (pair[1] - pair[0]).abs())
        .collect();
    mean(&ranges)
}

/// Variance by successive differences, and its effective degrees of freedom.
fn by_differences(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let square = |pair: &[f64]| (pair[1] - pair[0]).powi(2);
    let squares: f64 = values.windows(2).map(square).sum();
    let degrees_of_freedom = 2.0 * (n - 1.0).powi(2) / (3.0 * n - 4.0);
    (squares / (2.0 * (n - 1.0)), degrees_of_freedom)
}

/// Whether the last six scatter more than those before, which chance does in 0.27 % (F test of both variances).
fn scatter_more(values: &[f64]) -> bool {
    let Some(from) = values
        .len()
        .checked_sub(LATEST)
        .filter(|from| *from >= LATEST)
    else {
        return false;
    };
    let (before, latest) = values.split_at(from);
    let [(before, of_before), (latest, of_latest)] = [before, latest].map(by_differences);
    match FisherSnedecor::new(of_latest, of_before) {
        Ok(distribution) => latest > before * distribution.inverse_cdf(WITHIN),
        // Neither has so few that there is none.
        Err(_) => false,
    }
}

/// The last so many values, if there are.
fn last(values: &[f64], count: usize) -> Option<&[f64]> {
    values.len().checked_sub(count).map(|from| &values[from..])
}

fn is_on_one_side(values: &[f64], centre: f64) -> bool {
    last(values, ONE_SIDE).is_some_and(|run| {
        run.iter().all(|value| *value > centre) || run.iter().all(|value| *value < centre)
    })
}

fn is_a_trend(values: &[f64]) -> bool {
    last(values, TREND).is_some_and(|run| {
        let mut steps = run.windows(2);
        steps.clone().all(|pair| pair[1] > pair[0]) || steps.all(|pair| pair[1] < pair[0])
    })
}

/// E_n of two results with their expanded uncertainties (k = 2): beyond 1 they do not agree
/// (ISO/IEC 17043:2023, B.4.1.3).
pub fn e_n(value: f64, expanded: f64, reference: f64, reference_expanded: f64) -> f64 {
    (value - reference) / expanded.hypot(reference_expanded)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;
    use rand_distr::{Distribution, StandardNormal};

    /// Share of series, each with its last value moved, that give a signal.
    fn share(length: usize, moved: f64, signal: Signal) -> f64 {
        const SERIES: usize = 40_000;
        let mut generator = ChaCha8Rng::seed_from_u64(length as u64);
        let found = (0..SERIES).filter(|_| {
            let value = |_| -> f64 { StandardNormal.sample(&mut generator) };
            let mut series: Vec<f64> = (0..length).map(value).collect();
            series[length - 1] += moved;
            let chart = control_chart(&series).expect("enough");
            chart.signals.contains(&signal)
        });
        found.count() as f64 / SERIES as f64
    }

    /// 0.27 % by definition; the effective degrees of freedom are an approximation, on the careful side for
    /// few results, and 40 000 series scatter by 0.026 %.
    #[test]
    fn sound_series_are_seldom_outside() {
        for (length, least) in [(6, 0.0005), (12, 0.002), (30, 0.002)] {
            let outside = share(length, 0.0, Signal::OutsideLimits);
            assert!((least..0.005).contains(&outside), "{length}: {outside}");
        }
        // 2 / 2^9 where the mean is known; that of the series itself follows it, which makes runs rarer.
        let one_side = share(30, 0.0, Signal::OneSide);
        assert!((0.0005..0.0045).contains(&one_side), "{one_side}");
        // 2 / 6! = 0.28 %.
        let trend = share(30, 0.0, Signal::Trend);
        assert!((trend - 2.0 / 720.0).abs() < 4.0 * 0.00026, "{trend}");
    }

    /// Share of series of 30, the last six of them with so many times the standard deviation, that scatter more.
    fn wider(times: f64) -> f64 {
        const SERIES: usize = 20_000;
        let mut generator = ChaCha8Rng::seed_from_u64(times.to_bits());
        let found = (0..SERIES).filter(|_| {
            let value = |index: usize| -> f64 {
                let normal: f64 = StandardNormal.sample(&mut generator);
                normal * if index < 24 { 1.0 } else { times }
            };
            let series: Vec<f64> = (0..30).map(value).collect();
            let chart = control_chart(&series).expect("enough");
            chart.signals.contains(&Signal::Scatter)
        });
        found.count() as f64 / SERIES as f64
    }

    /// Both variances are quadratic forms of normal values: the share where one exceeds the F quantile times the other is
    /// 0.260 % of sound and 77.63 % of fourfold scatter (Imhof, Biometrika 48 (1961), 419, in numpy by the eigenvalues of
    /// the differences). 20 000 series scatter by 0.036 and 0.29 %; four of these are allowed.
    #[test]
    fn scatter_that_grows_is_told_and_sound_scatter_seldom() {
        let sound = wider(1.0);
        assert!((sound - 0.002_60).abs() < 4.0 * 0.000_36, "{sound}");
        let grown = wider(4.0);
        assert!((grown - 0.7763).abs() < 4.0 * 0.0029, "{grown}");
        assert!(!scatter_more(&[
            0.0, 1.0, 0.0, 1.0, 0.0, 9.0, 0.0, 9.0, 0.0, 9.0, 0.0
        ]));
    }

    #[test]
    fn a_step_of_six_standard_deviations_is_found() {
        assert!(share(30, 6.0, Signal::OutsideLimits) > 0.95);
    }

    /// By hand: differences of 1, so s = sqrt(4 / 8); the mean of 0 1 0 1 0 is 0.4; 2 * 16 / 11 degrees.
    #[test]
    fn a_series_by_hand() {
        let chart = control_chart(&[0.0, 1.0, 0.0, 1.0, 0.0, 0.4]).expect("six");
        assert!((chart.standard_deviation - 0.5_f64.sqrt()).abs() < 1e-12);
        assert!((chart.mean - 0.4).abs() < 1e-12);
        // Ranges of 1.
        assert!((chart.range_limit - 3.267).abs() < 1e-12);
        assert!((chart.degrees_of_freedom - 32.0 / 11.0).abs() < 1e-12);
        assert!(chart.signals.is_empty());
        assert_eq!(control_chart(&[0.0; 5]), None);
        let rising = control_chart(&[5.0, 0.0, 5.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]).expect("nine");
        assert_eq!(rising.signals, [Signal::Trend]);
    }

    #[test]
    fn e_n_is_the_difference_over_both_uncertainties() {
        assert!((e_n(10.05, 0.03, 10.0, 0.04) - 1.0).abs() < 1e-9);
    }
}
