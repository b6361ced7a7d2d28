//! Model selection: what a cause costs, how probable each set is, and how often it leads.

use super::significance::stream;
use crate::thresholds;
use rand::RngExt;

/// Bootstrap samples.
const DRAWS: usize = 100;

/// Cost of a parameter that is fitted to so many data, in -2 ln of the posterior probability
/// (Schwarz 1978).
pub(crate) fn cost_of_parameter(data: f64) -> f64 {
    data.ln()
}

/// Cost of one more cause out of so many that are as probable.
pub(crate) fn cost_of_cause(names: f64) -> f64 {
    2.0 * (names / thresholds::PRIOR_OF_MORE).ln()
}

/// Probabilities of sets from their scores, -2 ln of the posterior probability up to a constant.
pub(crate) fn probabilities(scores: &[f64]) -> Vec<f64> {
    let best = scores.iter().copied().fold(f64::INFINITY, f64::min);
    let odds: Vec<f64> = scores.iter().map(|s| (-0.5 * (s - best)).exp()).collect();
    let total: f64 = odds.iter().sum();
    odds.iter().map(|o| o / total).collect()
}

/// Share of bootstrap samples in which each set leads, groups of data drawn again.
///
/// `by_group` has what each group adds to each set. The parameters stay as fitted (Kishino, Miyata
/// and Hasegawa 1990); `scores` turns the sums of the sets into what is compared.
pub(crate) fn bootstrap(by_group: &[Vec<f64>], scores: impl Fn(Vec<f64>) -> Vec<f64>) -> Vec<f64> {
    let count = by_group.iter().map(Vec::len).min().unwrap_or(0);
    let mut random = stream(1);
    let samples = (0..DRAWS).map(|_| {
        let mut sums = vec![0.0; by_group.len()];
        for _ in 0..count {
            let group = random.random_range(0..count);
            for (sum, groups) in sums.iter_mut().zip(by_group) {
                *sum += groups[group];
            }
        }
        scores(sums)
    });
    shares(by_group.len(), samples)
}

/// Share of the runs without which each set leads; none where there is one run.
pub(crate) fn without_each(
    run_of: &[usize],
    by_group: &[Vec<f64>],
    scores: impl Fn(Vec<f64>) -> Vec<f64>,
) -> Option<Vec<f64>> {
    let mut runs = run_of.to_vec();
    runs.sort_unstable();
    runs.dedup();
    let without = |run: &usize| {
        let sum = |groups: &Vec<f64>| {
            let kept = groups.iter().zip(run_of).filter(|(_, of)| *of != run);
            kept.map(|(value, _)| value).sum::<f64>()
        };
        scores(by_group.iter().map(sum).collect())
    };
    (runs.len() > 1).then(|| shares(by_group.len(), runs.iter().map(without)))
}

/// Share of the samples in which each set has the least score.
fn shares(sets: usize, samples: impl Iterator<Item = Vec<f64>>) -> Vec<f64> {
    let mut led = vec![0.0; sets];
    let mut count = 0.0;
    for scores in samples {
        let best = scores.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
        if let Some((index, _)) = best {
            led[index] += 1.0;
        }
        count += 1.0;
    }
    led.iter().map(|led| led / count).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first set is better by 30 in the last run alone, the second by 1 in each row
    /// of the two others: without the last run the second leads, by 4 of 4 rows.
    #[test]
    fn a_set_that_one_run_carries_does_not_lead_without_it() {
        let runs = [0, 0, 1, 1, 2];
        let sets = [
            vec![1.0, 1.0, 1.0, 1.0, 0.0],
            vec![0.0, 0.0, 0.0, 0.0, 30.0],
        ];
        let as_they_are = |sums| sums;
        let shares = without_each(&runs, &sets, as_they_are).expect("three runs");
        assert!((shares[0] - 2.0 / 3.0).abs() < 1e-12, "{shares:?}");
        assert!((shares[1] - 1.0 / 3.0).abs() < 1e-12, "{shares:?}");
        assert_eq!(without_each(&[4; 5], &sets, as_they_are), None);
        // Drawn again, the last row of five is missed with probability 0.8^5 = 0.328;
        // 100 draws scatter by 0.047.
        let share = bootstrap(&sets, as_they_are)[1];
        assert!((share - 0.328).abs() < 3.0 * 0.047, "{share}");
    }

    /// Scores 2 ln 3 apart: odds of 3 to 1.
    #[test]
    fn probabilities_are_those_of_the_odds() {
        let found = probabilities(&[5.0 + 2.0 * 3.0_f64.ln(), 5.0]);
        assert!((found[0] - 0.25).abs() < 1e-12, "{found:?}");
        assert!((found[1] - 0.75).abs() < 1e-12, "{found:?}");
    }
}
