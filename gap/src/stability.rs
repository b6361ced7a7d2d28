//! How often each set would be the best if rows or runs had been drawn again.

use crate::engine::fit::Workspace;
use crate::engine::problem::Problem;
use crate::engine::score::Scored;
use crate::engine::significance::Gauss;

const DRAWS: usize = 100;
/// Sets worth comparing.
const MOST_SETS: usize = 12;

/// How often a set leads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stability {
    /// Share of bootstrap samples of the rows.
    pub(crate) rows: f64,
    /// Share of the runs without any one of which it still leads; none where there is one run.
    pub(crate) runs: Option<f64>,
}

/// How often each set leads when rows are drawn again, and when each run is left out.
///
/// The parameters stay as fitted and the likelihood of each row is
/// resampled (Kishino, Miyata and Hasegawa 1990).
pub(crate) fn stability(
    problem: &Problem,
    sets: &[Scored],
    work: &mut Workspace,
) -> Vec<Stability> {
    let compared = &sets[..sets.len().min(MOST_SETS)];
    let by_row: Vec<Vec<f64>> = compared
        .iter()
        .map(|set| {
            let evaluation = problem.evaluate(&set.fit.effects, &set.fit.theta, &mut work.memory);
            let mut rows = vec![0.0; problem.rows.len()];
            for (at, residual) in evaluation.residual.iter().enumerate() {
                rows[problem.row_of[at]] += residual * residual
                    - 2.0 * (evaluation.weight[at] * problem.uncertainty(at)).ln();
            }
            rows
        })
        .collect();
    let rest: Vec<f64> = compared
        .iter()
        .zip(&by_row)
        .map(|(s, rows)| s.score - rows.iter().sum::<f64>())
        .collect();
    let runs: Vec<usize> = problem.rows.iter().map(|row| row.run).collect();
    let (rows, runs) = (
        resampled(&by_row, &rest),
        without_each(&runs, &by_row, &rest),
    );
    let of = |at: usize| Stability {
        rows: rows.get(at).copied().unwrap_or(0.0),
        runs: runs.as_ref().map(|r| r.get(at).copied().unwrap_or(0.0)),
    };
    (0..sets.len()).map(of).collect()
}

/// Share of bootstrap samples of rows in which each set has the least sum.
pub(crate) fn resampled(by_row: &[Vec<f64>], rest: &[f64]) -> Vec<f64> {
    let mut shares = vec![0.0; by_row.len()];
    let count = by_row.first().map_or(0, Vec::len);
    let mut random = Gauss::new(1);
    for _ in 0..DRAWS {
        let mut sums = rest.to_vec();
        for _ in 0..count {
            let row = ((random.uniform() * count as f64) as usize).min(count - 1);
            for (sum, rows) in sums.iter_mut().zip(by_row) {
                *sum += rows[row];
            }
        }
        if let Some(index) = least(&sums) {
            shares[index] += 1.0;
        }
    }
    shares.iter().map(|led| led / DRAWS as f64).collect()
}

/// Share of the runs without which each set has the least sum.
fn without_each(run_of: &[usize], by_row: &[Vec<f64>], rest: &[f64]) -> Option<Vec<f64>> {
    let mut runs = run_of.to_vec();
    runs.sort_unstable();
    runs.dedup();
    let mut shares = vec![0.0; by_row.len()];
    for run in &runs {
        let sum = |(rows, rest): (&Vec<f64>, &f64)| {
            let kept = rows.iter().zip(run_of).filter(|(_, of)| *of != run);
            rest + kept.map(|(value, _)| value).sum::<f64>()
        };
        let sums: Vec<f64> = by_row.iter().zip(rest).map(sum).collect();
        if let Some(index) = least(&sums) {
            shares[index] += 1.0;
        }
    }
    let count = runs.len() as f64;
    (runs.len() > 1).then(|| shares.iter().map(|led| led / count).collect())
}

fn least(sums: &[f64]) -> Option<usize> {
    let best = sums.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
    best.map(|(index, _)| index)
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
        let shares = without_each(&runs, &sets, &[0.0, 0.0]).expect("three runs");
        assert!((shares[0] - 2.0 / 3.0).abs() < 1e-12, "{shares:?}");
        assert!((shares[1] - 1.0 / 3.0).abs() < 1e-12, "{shares:?}");
        assert_eq!(without_each(&[4; 5], &sets, &[0.0, 0.0]), None);
        // Drawn again, the last row of five is missed with probability 0.8^5 = 0.328;
        // 100 draws scatter by 0.047.
        let share = resampled(&sets, &[0.0, 0.0])[1];
        assert!((share - 0.328).abs() < 3.0 * 0.047, "{share}");
    }
}
