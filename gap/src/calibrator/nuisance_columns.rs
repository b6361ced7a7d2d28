//! Slopes of the weighted prediction against the nuisances.

use super::evaluation::{Evaluation, Responses};
use super::nuisance::{Free, Nuisance};
use super::problem::{Column, Problem};
use crate::model::exciter::{ExciterSlopes, Slopes};
use crate::observable::{Complex, Observable};
use num_complex::Complex64;

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
