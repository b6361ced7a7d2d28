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
    let mut parts = match free.kind {
        Nuisance::RatioGain => vec![at.part(RATIO, |_| 1.0)],
        Nuisance::DriveGain => vec![at.part(DRIVE, |_| 1.0)],
        Nuisance::RunDut(run) => vec![at.in_run(RATIO, run, 1.0)],
        Nuisance::RunReference(run) => {
            vec![at.in_run(RATIO, run, -1.0), at.in_run(DRIVE, run, 1.0)]
        }
        Nuisance::Exciter(i) => {
            let slope = |observable: usize| {
                move |row: usize| match &responses.exciter[row] {
                    Some(slopes) => slopes[observable][i],
                    None => Complex64::ZERO,
                }
            };
            let [drive, current] = [at.both(DRIVE, slope(0)), at.both(CURRENT, slope(1))];
            drive.into_iter().chain(current).collect()
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

/// Values of a slot.
type Part = (usize, Vec<f64>);

impl Place<'_> {
    /// Slope of each row, times unit and weight.
    fn part(&self, slot: usize, slope: impl Fn(usize) -> f64) -> Part {
        let range = self.problem.slots[slot].clone();
        let data = self.weight[range.clone()].iter();
        let values = data.zip(&self.problem.row_of[range]);
        let weighted = values.map(|(w, row)| self.unit * slope(*row) * w);
        (slot, weighted.collect())
    }

    /// The same slope in all rows of a run.
    fn in_run(&self, slot: usize, run: usize, slope: f64) -> Part {
        self.part(slot, |row| {
            if self.problem.rows[row].run == run {
                slope
            } else {
                0.0
            }
        })
    }

    /// Both parts of a complex slope.
    fn both(&self, slot: usize, slope: impl Fn(usize) -> Complex64) -> [Part; 2] {
        [
            self.part(slot, |row| slope(row).re),
            self.part(slot + 1, |row| slope(row).im),
        ]
    }
}
