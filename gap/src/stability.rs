//! How often each set would be the best if the rows had been drawn again.

use crate::engine::fit::Workspace;
use crate::engine::problem::Problem;
use crate::engine::search::Scored;
use crate::engine::significance::Gauss;

const DRAWS: usize = 100;
/// Sets worth comparing.
const MOST_SETS: usize = 12;

/// Share of bootstrap samples of rows in which each set leads.
///
/// The parameters stay as fitted and the likelihood of each row is
/// resampled (Kishino, Miyata and Hasegawa 1990).
pub(crate) fn bootstrap(problem: &Problem, sets: &[Scored], work: &mut Workspace) -> Vec<f64> {
    let mut shares = vec![0.0; sets.len()];
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
    let mut random = Gauss::new(1);
    for _ in 0..DRAWS {
        let mut sums = rest.clone();
        for _ in 0..problem.rows.len() {
            let row = ((random.uniform() * problem.rows.len() as f64) as usize)
                .min(problem.rows.len() - 1);
            for (sum, rows) in sums.iter_mut().zip(&by_row) {
                *sum += rows[row];
            }
        }
        let best = sums.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
        if let Some((index, _)) = best {
            shares[index] += 1.0 / DRAWS as f64;
        }
    }
    shares
}
