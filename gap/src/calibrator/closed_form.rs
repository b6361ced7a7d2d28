//! Changes of the prediction for which no exciter has to be computed: by nuisances, by effects that are linear
//! responses, and by effects that change no more than values of the exciter, row by row.
//!
//! Beside a bent exciter such a value moves the harmonics too. The slopes against the values of the
//! exciter say how; no balance has to be solved.

use super::evaluation::{Evaluation, Responses};
use super::fit::Fit;
use super::nuisance::{Free, Nuisance};
use super::problem::{Column, Problem, wrapped};
use crate::dataset::{ExciterParameter, ExciterParameters};
use crate::model::chain::{Chain, Transfer};
use crate::model::effect::Active;
use crate::model::exciter::{ExciterSlopes, Slopes};
use crate::model::row::Row;
use crate::observable::{Complex, Observable};
use num_complex::Complex64;

/// Change of the weighted prediction when a linear response is added.
pub(super) fn response_added(problem: &Problem, added: &Active<'_>, weight: &[f64]) -> Column {
    change(problem, weight, |row| responses(problem, row, added))
}

/// Change of the responses when its parameters move.
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
        stiffness_n_per_m: after.stiffness / before.stiffness - 1.0,
        damping_ns_per_m: (after.damping_ns_per_m - before.damping_ns_per_m)
            / values.damping_ns_per_m,
        force_factor_n_per_a: after.force_factor / before.force_factor - 1.0,
        coil_resistance_ohm: after.resistance / before.resistance - 1.0,
        coil_inductance_h: after.inductance / before.inductance - 1.0,
    };
    before.mass_kg = after.mass_kg;
    before.damping_ns_per_m = after.damping_ns_per_m;
    before.stiffness = after.stiffness;
    before.force_factor = after.force_factor;
    before.inductance = after.inductance;
    before.resistance = after.resistance;
    (before == after).then_some(changes)
}

/// One column for each nuisance of a problem.
pub(super) fn nuisance_columns(
    problem: &Problem,
    evaluation: &Evaluation,
    responses: &Responses,
    theta: &[f64],
) -> Vec<Column> {
    let all = problem.free.iter().zip(theta);
    all.map(|(free, &value)| {
        let unit = problem.relative_unit(free, value);
        column(problem, evaluation, responses, free, unit)
    })
    .collect()
}

fn column(
    problem: &Problem,
    evaluation: &Evaluation,
    responses: &Responses,
    free: &Free,
    unit: f64,
) -> Column {
    let at = Place {
        problem,
        weight: &evaluation.weight,
        unit,
    };
    let mut parts = match free.kind {
        Nuisance::RatioGain => vec![at.part(Observable::Ratio, |_| 1.0)],
        Nuisance::DriveGain => vec![at.part(Observable::Drive, |_| 1.0)],
        Nuisance::RunDut(run) => vec![at.in_run(Observable::Ratio, run, 1.0)],
        Nuisance::RunReference(run) => {
            vec![
                at.in_run(Observable::Ratio, run, -1.0),
                at.in_run(Observable::Drive, run, 1.0),
            ]
        }
        Nuisance::Exciter(parameter) => {
            let slope = |of: fn(&ExciterSlopes) -> &Slopes| {
                move |row: usize| match &responses.exciter[row] {
                    Some(slopes) => of(slopes)[parameter],
                    None => Complex64::ZERO,
                }
            };
            let drive = at.both(Observable::DRIVE, slope(|s| &s.drive));
            let current = at.both(Observable::CURRENT, slope(|s| &s.current));
            drive.into_iter().chain(current).collect()
        }
        Nuisance::Noise(channel) => {
            vec![at.part(Observable::noise(channel), |row| {
                responses.noise_share[row][channel as usize]
            })]
        }
    };
    parts.retain(|(observable, _)| !problem.data_of(*observable).is_empty());
    Column { parts }
}

/// Values for the data of one observable.
type Part = (Observable, Vec<f64>);

/// Where a column is filled.
struct Place<'a> {
    problem: &'a Problem,
    weight: &'a [f64],
    unit: f64,
}

impl Place<'_> {
    /// Slope of each row, times unit and weight.
    fn part(&self, observable: Observable, slope: impl Fn(usize) -> f64) -> Part {
        let range = self.problem.data_of(observable);
        let data = self.weight[range.clone()].iter();
        let values = data.zip(&self.problem.row_of[range]);
        let weighted = values.map(|(w, row)| self.unit * slope(*row) * w);
        (observable, weighted.collect())
    }

    /// One slope in all rows of a run.
    fn in_run(&self, observable: Observable, run: usize, slope: f64) -> Part {
        self.part(observable, |row| {
            if self.problem.rows[row].run == run {
                slope
            } else {
                0.0
            }
        })
    }

    /// Both parts of a complex slope.
    fn both(&self, [real, imaginary]: Complex, slope: impl Fn(usize) -> Complex64) -> [Part; 2] {
        [
            self.part(real, |row| slope(row).re),
            self.part(imaginary, |row| slope(row).im),
        ]
    }
}
