//! Changes of the prediction by effects that are linear responses: no exciter has to be computed.

use super::column::Column;
use super::problem::{Problem, wrapped};
use crate::effects::Active;
use crate::model::chain::Transfer;
use crate::observable::Observable;
use num_complex::Complex64;

/// Change of the weighted prediction when a linear response is added.
pub(super) fn response_added(problem: &Problem, added: &Active<'_>, weight: &[f64]) -> Column {
    change(problem, weight, |row| responses(problem, row, added))
}

/// The same when its parameters move.
pub(super) fn response_change(
    problem: &Problem,
    from: &Active<'_>,
    to: &Active<'_>,
    weight: &[f64],
) -> Column {
    change(problem, weight, |row| {
        let [before, after] = [from, to].map(|active| responses(problem, row, active));
        [after[0] / before[0], after[1] / before[1]]
    })
}

/// Factors on ratio and drive in a row.
fn responses(problem: &Problem, row: usize, active: &Active<'_>) -> [Complex64; 2] {
    let row = &problem.rows[row];
    let mut t = Transfer::default();
    active.transfer(row, row.frequency_hz, &mut t);
    [t.dut / t.reference, t.table * t.reference * t.drive]
}

/// Column of the logarithms of factors on ratio and drive.
fn change(problem: &Problem, weight: &[f64], factors: impl Fn(usize) -> [Complex64; 2]) -> Column {
    let factors: Vec<[Complex64; 2]> = (0..problem.rows.len()).map(factors).collect();
    let mut column = Column::default();
    let responses = [Observable::RATIO, Observable::DRIVE].into_iter();
    for (response, observables) in responses.enumerate() {
        for observable in observables {
            let value = |at: usize| {
                let factor = factors[problem.row_of[at]][response];
                if factor == Complex64::ONE {
                    0.0
                } else if observable.is_phase() {
                    wrapped(factor.arg()) * weight[at]
                } else {
                    0.5 * factor.norm_sqr().ln() * weight[at]
                }
            };
            let values: Vec<f64> = problem.data_of(observable).map(value).collect();
            if values.iter().any(|v| v.abs() > 1e-11) {
                column.parts.push((observable, values));
            }
        }
    }
    column
}
