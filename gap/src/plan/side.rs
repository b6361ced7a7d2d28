//! What two sets of effects say of the same data: differences, and slopes of the refitted one.

use super::parameters::of_run;
use crate::engine::column::Column;
use crate::engine::fit::{Fit, Workspace};
use crate::engine::linear::Linearised;
use crate::engine::normal::difference;
use crate::engine::problem::Problem;
use crate::observable::Observable;
use nalgebra::DVector;

/// One value of a point: observable, difference of the predictions, slopes of the refitted set.
pub(super) struct Datum {
    pub(super) observable: Observable,
    pub(super) difference: f64,
    pub(super) slopes: DVector<f64>,
}

/// Differences and slopes on one problem.
pub(super) struct Side<'a> {
    problem: &'a Problem,
    difference: Vec<f64>,
    columns: Vec<Column>,
}

impl<'a> Side<'a> {
    /// Of fits of the problem `of`, on the same or another one.
    pub(super) fn on(problem: &'a Problem, of: &Problem, [truth, rival]: [&Fit; 2]) -> Self {
        if std::ptr::eq(problem, of) {
            Self::new(problem, truth, rival)
        } else {
            let fits = [truth, rival].map(|fit| carried(fit, of, problem));
            Self::new(problem, &fits[0], &fits[1])
        }
    }

    fn new(problem: &'a Problem, truth: &Fit, rival: &Fit) -> Self {
        let mut work = Workspace::new(problem);
        let there = problem.evaluate(&truth.effects, &truth.theta, &mut problem.memory());
        let linear = Linearised::new(problem, rival, &mut work);
        Self {
            problem,
            difference: difference(problem, &linear.evaluation, &there),
            columns: linear.columns,
        }
    }

    /// Units of the refitted effects' parameters that make them change all points by one.
    pub(super) fn scales(&self, nuisances: usize) -> Vec<f64> {
        let effects = &self.columns[nuisances..];
        let unit = |column: &Column| {
            let norm = column.norm2().sqrt();
            if norm > 0.0 { 1.0 / norm } else { 1.0 }
        };
        effects.iter().map(unit).collect()
    }

    /// By row; `place[i]` is where column i belongs among `count` parameters.
    pub(super) fn rows(&self, place: &[usize], scales: &[f64], count: usize) -> Vec<Vec<Datum>> {
        let problem = self.problem;
        let nuisances = self.columns.len() - scales.len();
        let scale = |i: usize| {
            if i < nuisances {
                1.0
            } else {
                scales[i - nuisances]
            }
        };
        let mut rows: Vec<Vec<Datum>> = problem.rows.iter().map(|_| Vec::new()).collect();
        for (observable, data) in problem.measured_observables() {
            let first = data.start;
            for at in data {
                let mut slopes = DVector::zeros(count);
                for (i, (column, to)) in self.columns.iter().zip(place).enumerate() {
                    if let Some((_, values)) = column.parts.iter().find(|p| p.0 == observable) {
                        slopes[*to] = values[at - first] * scale(i);
                    }
                }
                let difference = self.difference[at];
                if difference.abs() > 1e-6 || slopes.iter().any(|s| *s != 0.0) {
                    rows[problem.row_of[at]].push(Datum {
                        observable,
                        difference,
                        slopes,
                    });
                }
            }
        }
        rows
    }
}

/// A fit of one problem as a fit of another with the same rig; gains of runs stay behind.
fn carried(fit: &Fit, from: &Problem, to: &Problem) -> Fit {
    let mut theta = to.translate(from, &fit.theta);
    for (value, free) in theta.iter_mut().zip(&to.free) {
        if of_run(free.kind) {
            *value = 0.0;
        }
    }
    Fit {
        effects: fit.effects.clone(),
        theta,
        objective: fit.objective,
    }
}
