//! Effects that do no more than change values of the exciter, row by row.
//!
//! Beside a bent exciter such a change moves the harmonics too. The slopes against the
//! values of the exciter say how; no balance has to be solved.

use super::column::Column;
use super::fit::Fit;
use super::nuisance::Nuisance;
use super::problem::Problem;
use crate::effects::Active;
use crate::model::chain::Chain;
use crate::model::row::Row;

/// Change of the weighted prediction, from the slopes at a fit; `None` where the effect does
/// more, or changes a value that is taken as exact.
pub(super) fn by_values(
    problem: &Problem,
    fit: &Fit,
    added: &Active<'_>,
    slopes: &[Column],
) -> Option<Column> {
    let values = problem.exciter(&fit.theta)?;
    let rows = problem.rows.iter();
    let changes: Option<Vec<[f64; 6]>> = rows.map(|r| changes(&values, fit, r, added)).collect();
    let changes = changes?;
    let mut sum = vec![0.0; problem.len()];
    for value in 0..6 {
        if changes.iter().all(|c| c[value] == 0.0) {
            continue;
        }
        let mut free = problem.free.iter();
        let at = free.position(|f| f.kind == Nuisance::Exciter(value))?;
        let unit = problem.relative_unit(&problem.free[at], fit.theta[at]);
        for (slot, slope) in &slopes[at].parts {
            let data = problem.slots[*slot].clone();
            for (at, slope) in data.zip(slope) {
                sum[at] += slope * changes[problem.row_of[at]][value] / unit;
            }
        }
    }
    Some(Column::difference(
        problem,
        &vec![0.0; sum.len()],
        &sum,
        1.0,
    ))
}

/// Relative changes of the six values in a row.
fn changes(values: &[f64; 6], fit: &Fit, row: &Row, added: &Active<'_>) -> Option<[f64; 6]> {
    let mut before = Chain::default();
    fit.effects.iter().for_each(|e| e.chain(row, &mut before));
    let mut after = before.clone();
    added.chain(row, &mut after);
    let changes = [
        (after.mass_kg - before.mass_kg) / values[0],
        0.0,
        (after.damping_ns_per_m - before.damping_ns_per_m) / values[2],
        0.0,
        after.resistance / before.resistance - 1.0,
        0.0,
    ];
    before.mass_kg = after.mass_kg;
    before.damping_ns_per_m = after.damping_ns_per_m;
    before.resistance = after.resistance;
    (before == after).then_some(changes)
}
