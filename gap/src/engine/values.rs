//! Effects that do no more than change values of the exciter, row by row.
//!
//! Beside a bent exciter such a change moves the harmonics too. The slopes against the
//! values of the exciter say how; no balance has to be solved.

use super::column::Column;
use super::fit::Fit;
use super::nuisance::Nuisance;
use super::problem::Problem;
use crate::dataset::{ExciterParameter, ExciterParameters};
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
    let changes: Option<Vec<ExciterParameters<f64>>> =
        rows.map(|r| changes(&values, fit, r, added)).collect();
    let changes = changes?;
    let mut sum = vec![0.0; problem.len()];
    for parameter in ExciterParameter::ALL {
        if changes.iter().all(|c| c[parameter] == 0.0) {
            continue;
        }
        let mut free = problem.free.iter();
        let at = free.position(|f| f.kind == Nuisance::Exciter(parameter))?;
        let unit = problem.relative_unit(&problem.free[at], fit.theta[at]);
        for (observable, slope) in &slopes[at].parts {
            for (at, slope) in problem.data_of(*observable).zip(slope) {
                sum[at] += slope * changes[problem.row_of[at]][parameter] / unit;
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

/// Relative changes of the values in a row.
fn changes(
    values: &ExciterParameters<f64>,
    fit: &Fit,
    row: &Row,
    added: &Active<'_>,
) -> Option<ExciterParameters<f64>> {
    let mut before = Chain::default();
    fit.effects.iter().for_each(|e| e.chain(row, &mut before));
    let mut after = before.clone();
    added.chain(row, &mut after);
    let changes = ExciterParameters {
        moving_mass_kg: (after.mass_kg - before.mass_kg) / values.moving_mass_kg,
        stiffness_n_per_m: 0.0,
        damping_ns_per_m: (after.damping_ns_per_m - before.damping_ns_per_m)
            / values.damping_ns_per_m,
        force_factor_n_per_a: 0.0,
        coil_resistance_ohm: after.resistance / before.resistance - 1.0,
        coil_inductance_h: 0.0,
    };
    before.mass_kg = after.mass_kg;
    before.damping_ns_per_m = after.damping_ns_per_m;
    before.resistance = after.resistance;
    (before == after).then_some(changes)
}
