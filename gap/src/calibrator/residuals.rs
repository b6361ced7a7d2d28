//! Data for the pictures of points: every difference, before and after.

use super::fit::Fit;
use super::holdout::held_out;
use super::problem::Problem;
use crate::pictures::{Conditions, Datum, Pictures, Residuals};

/// Differences that two fits of one problem leave.
pub(super) fn residuals(problem: &Problem, nominal: &Fit, best: &Fit) -> Pictures {
    let of = |fit: &Fit| problem.evaluate(&fit.effects, &fit.theta, &mut problem.memory());
    let (before, after) = (of(nominal), of(best));
    let mut data = Vec::with_capacity(problem.len());
    for (observable, range) in problem.measured_observables() {
        data.extend(range.map(|at| Datum {
            row: problem.row_of[at],
            observable,
            before: before.residual[at] / before.weight[at],
            after: after.residual[at] / after.weight[at],
            u: problem.uncertainty(at),
            u_after: 1.0 / after.weight[at],
        }));
    }
    Pictures::Points(Residuals {
        rows: conditions(problem),
        data,
    })
}

fn conditions(problem: &Problem) -> Vec<Conditions> {
    let held = held_out(problem);
    let rows = problem.rows.iter().zip(held);
    rows.map(|(row, held_out)| Conditions {
        frequency_hz: row.frequency_hz,
        level_ms2: row.level_ms2,
        run: row.run,
        time_s: row.time_s,
        warmer_k: row.warmer_k,
        rotation_deg: row.rotation.1.atan2(row.rotation.0).to_degrees().round(),
        tilt_deg: row.vertical.clamp(-1.0, 1.0).acos().to_degrees().round(),
        payload_kg: row.payload_kg,
        held_out,
    })
    .collect()
}
