//! Slopes of the weighted prediction against the nuisances, slot by slot.

use super::column::Column;
use super::evaluation::{Evaluation, Responses};
use super::nuisance::{Free, Nuisance};
use super::problem::Problem;
use crate::model::row::{CURRENT, DRIVE, NOISE, RATIO};
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
    let in_run = |run: usize, sign: f64| {
        move |row: usize| {
            if problem.rows[row].run == run {
                sign
            } else {
                0.0
            }
        }
    };
    let exciter = |observable: usize, i: usize| {
        move |row: usize| match &responses.exciter[row] {
            Some(slopes) => slopes[observable][i],
            None => Complex64::ZERO,
        }
    };
    let mut parts = match free.kind {
        Nuisance::RatioGain => vec![at.part(RATIO, |_| 1.0)],
        Nuisance::DriveGain => vec![at.part(DRIVE, |_| 1.0)],
        Nuisance::RunDut(run) => vec![at.part(RATIO, in_run(run, 1.0))],
        Nuisance::RunReference(run) => vec![
            at.part(RATIO, in_run(run, -1.0)),
            at.part(DRIVE, in_run(run, 1.0)),
        ],
        Nuisance::Exciter(i) => {
            let (drive, current) = (exciter(0, i), exciter(1, i));
            vec![
                at.part(DRIVE, |row| drive(row).re),
                at.part(DRIVE + 1, |row| drive(row).im),
                at.part(CURRENT, |row| current(row).re),
                at.part(CURRENT + 1, |row| current(row).im),
            ]
        }
        Nuisance::Noise(channel) => {
            vec![at.part(NOISE + channel, |row| responses.noise_share[row][channel])]
        }
    };
    parts.retain(|(slot, _)| !problem.slots[*slot].is_empty());
    Column { parts }
}

/// Where a column is filled.
struct Place<'a> {
    problem: &'a Problem,
    weight: &'a [f64],
    unit: f64,
}

impl Place<'_> {
    /// Values of a slot: slope of each row, times unit and weight.
    fn part(&self, slot: usize, slope: impl Fn(usize) -> f64) -> (usize, Vec<f64>) {
        let range = self.problem.slots[slot].clone();
        let data = self.weight[range.clone()].iter();
        let values = data.zip(&self.problem.row_of[range]);
        let weighted = values.map(|(w, row)| self.unit * slope(*row) * w);
        (slot, weighted.collect())
    }
}
