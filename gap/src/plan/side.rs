//! Predictions of two sets of effects for the same data: differences, and slopes of the refitted values.

use crate::calibrator::evaluation::difference;
use crate::calibrator::fit::{Fit, Workspace};
use crate::calibrator::linear::Linearised;
use crate::calibrator::nuisance::Nuisance;
use crate::calibrator::problem::{Column, Problem};
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

/// Where the columns of both problems belong: shared nuisances once, runs apart.
pub(super) struct Parameters {
    /// How many there are.
    pub(super) count: usize,
    /// Place of each column of the points that may be measured.
    pub(super) of_new: Vec<usize>,
    /// Place of each column of the data there are.
    pub(super) of_old: Vec<usize>,
}

impl Parameters {
    pub(super) fn new(new: &Problem, old: Option<&Problem>, effects: usize) -> Self {
        let shared = new.free.len();
        let mut count = shared;
        let mut of_old = Vec::new();
        for free in old.map_or(&[][..], |o| &o.free) {
            let same = new.free.iter().position(|f| f.kind == free.kind);
            of_old.push(match same.filter(|_| !of_run(free.kind)) {
                Some(at) => at,
                None => {
                    count += 1;
                    count - 1
                }
            });
        }
        let mut of_new: Vec<usize> = (0..shared).collect();
        of_new.extend(count..count + effects);
        of_old.extend(count..count + effects);
        Self {
            count: count + effects,
            of_new,
            of_old,
        }
    }

    /// Nuisance values of a fit of the problem `of`.
    pub(super) fn values(
        &self,
        of: &Problem,
        old: Option<&Problem>,
        theta: &[f64],
    ) -> DVector<f64> {
        let mut values = DVector::zeros(self.count);
        let is_old = old.is_some_and(|old| std::ptr::eq(old, of));
        let place = if is_old { &self.of_old } else { &self.of_new };
        for (value, at) in theta.iter().zip(place) {
            values[*at] = *value;
        }
        values
    }

    /// 1 for a parameter with a prior of one unit.
    pub(super) fn prior(&self, new: &Problem, old: Option<&Problem>) -> DVector<f64> {
        let mut prior = DVector::zeros(self.count);
        let bounded = |b: bool| f64::from(u8::from(b));
        for (free, at) in new.free.iter().zip(&self.of_new) {
            prior[*at] = bounded(free.bounded);
        }
        for (free, at) in old.map_or(&[][..], |o| &o.free).iter().zip(&self.of_old) {
            prior[*at] = bounded(free.bounded);
        }
        prior
    }
}

/// Whether it is a gain of one run.
pub(super) fn of_run(kind: Nuisance) -> bool {
    matches!(kind, Nuisance::RunReference(_) | Nuisance::RunDut(_))
}
