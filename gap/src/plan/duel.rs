//! Two sets of effects: one is true, the other is refitted as well as it can be.

use super::candidates::observable;
use crate::engine::column::Column;
use crate::engine::fit::{Fit, Workspace};
use crate::engine::linear::Linearised;
use crate::engine::normal::difference;
use crate::engine::nuisance::Nuisance;
use crate::engine::problem::Problem;
use crate::model::row::SLOTS;
use nalgebra::{Cholesky, DMatrix, DVector};

/// Keeps parameters that nothing has taught anything about.
const RIDGE: f64 = 1e-8;

/// One value of a point: slot, difference of the predictions, slopes of the refitted set.
struct Datum {
    slot: usize,
    difference: f64,
    slopes: DVector<f64>,
}

/// State of a comparison.
pub(super) struct Duel {
    /// Names of the set that is taken for true.
    pub(super) truth: Vec<&'static str>,
    /// Names of the set that tries to look like it.
    pub(super) rival: Vec<&'static str>,
    rows: Vec<Vec<Datum>>,
    /// Normal matrix of what is refitted, and its inverse.
    matrix: DMatrix<f64>,
    covariance: DMatrix<f64>,
    gradient: DVector<f64>,
    /// How far the refitted parameters have moved to look alike.
    moved: DVector<f64>,
    square: f64,
}

impl Duel {
    /// Compares fits of the problem `of` on the data there are (none: nothing measured yet).
    pub(super) fn new(
        old: Option<&Problem>,
        new: &Problem,
        of: &Problem,
        [truth, rival]: [&Fit; 2],
    ) -> Option<Self> {
        let on = |problem: &Problem| {
            if std::ptr::eq(problem, of) {
                Side::new(problem, truth, rival)
            } else {
                let fits = [truth, rival].map(|fit| carried(fit, of, problem));
                Side::new(problem, &fits[0], &fits[1])
            }
        };
        let points = on(new);
        let measured = old.map(on);
        let scales = points.scales(new.free.len());
        let names = Parameters::new(new, old, rival.parameter_count());
        let count = names.count;
        let mut matrix = DMatrix::from_diagonal(&names.prior(new, old));
        // Priors are data too: the refit may have moved far from what is stated already.
        let start = |fit: &Fit| names.values(of, old, &fit.theta);
        let (theta, true_theta) = (start(rival), start(truth));
        let prior = matrix.diagonal();
        let mut gradient = -prior.component_mul(&theta);
        let cost = |theta: &DVector<f64>| theta.dot(&prior.component_mul(theta));
        let mut square = cost(&theta) - cost(&true_theta);
        if let (Some(problem), Some(side)) = (old, &measured) {
            for datum in side
                .rows(problem, &names.of_old, &scales, count)
                .into_iter()
                .flatten()
            {
                matrix.ger(1.0, &datum.slopes, &datum.slopes, 1.0);
                gradient.axpy(datum.difference, &datum.slopes, 1.0);
                square += datum.difference * datum.difference;
            }
        }
        for i in 0..count {
            matrix[(i, i)] += RIDGE * (1.0 + matrix[(i, i)]);
        }
        let covariance = Cholesky::new(matrix.clone())?.inverse();
        let moved = &covariance * &gradient;
        square -= gradient.dot(&moved);
        Some(Self {
            truth: truth.names(),
            rival: rival.names(),
            rows: points.rows(new, &names.of_new, &scales, count),
            matrix,
            covariance,
            gradient,
            moved,
            square: square.max(0.0),
        })
    }

    /// Separation in standard uncertainties.
    pub(super) fn sigma(&self) -> f64 {
        self.square.sqrt()
    }

    pub(super) fn square(&self) -> f64 {
        self.square
    }

    /// By how much a point raises the squared separation (Kalman's innovation), and how
    /// much it teaches about what is refitted (logarithm of the ratio of variances).
    pub(super) fn gain(&self, row: usize, slots: &[bool; SLOTS]) -> (f64, f64) {
        let data: Vec<&Datum> = self.rows[row].iter().filter(|d| slots[d.slot]).collect();
        if data.is_empty() {
            return (0.0, 0.0);
        }
        let slopes: Vec<DVector<f64>> = data.iter().map(|d| d.slopes.clone()).collect();
        let slopes = DMatrix::from_columns(&slopes);
        let mut scatter = slopes.transpose() * (&self.covariance * &slopes);
        for i in 0..data.len() {
            scatter[(i, i)] += 1.0;
        }
        let differences = data.iter().map(|d| d.difference);
        let innovation =
            DVector::from_iterator(data.len(), differences) - slopes.tr_mul(&self.moved);
        let Some(factor) = Cholesky::new(scatter) else {
            return (0.0, 0.0);
        };
        let logs = factor
            .l_dirty()
            .diagonal()
            .iter()
            .map(|l| l.ln())
            .sum::<f64>();
        (innovation.dot(&factor.solve(&innovation)), 2.0 * logs)
    }

    /// Adds a point.
    pub(super) fn add(&mut self, row: usize, slots: &[bool; SLOTS]) {
        self.square += self.gain(row, slots).0;
        for datum in self.rows[row].iter().filter(|d| slots[d.slot]) {
            self.matrix.ger(1.0, &datum.slopes, &datum.slopes, 1.0);
            self.gradient.axpy(datum.difference, &datum.slopes, 1.0);
        }
        if let Some(factor) = Cholesky::new(self.matrix.clone()) {
            self.covariance = factor.inverse();
            self.moved = &self.covariance * &self.gradient;
        }
    }

    /// Observable in which a point tells the two apart.
    pub(super) fn look_at(&self, row: usize, slots: &[bool; SLOTS]) -> &'static str {
        let left = |d: &&Datum| (d.difference - d.slopes.dot(&self.moved)).abs();
        let data = self.rows[row].iter().filter(|d| slots[d.slot]);
        let most = data.max_by(|a, b| left(a).total_cmp(&left(b)));
        most.map_or("ratio", |d| observable(d.slot))
    }
}

/// Differences and slopes on one problem.
struct Side {
    difference: Vec<f64>,
    columns: Vec<Column>,
}

impl Side {
    fn new(problem: &Problem, truth: &Fit, rival: &Fit) -> Self {
        let mut work = Workspace::new(problem);
        let there = problem.evaluate(&truth.effects, &truth.theta, &mut problem.memory());
        let linear = Linearised::new(problem, rival, &mut work);
        Self {
            difference: difference(problem, &linear.evaluation, &there),
            columns: linear.columns,
        }
    }

    /// Units of the refitted effects' parameters that make them change all points by one.
    fn scales(&self, nuisances: usize) -> Vec<f64> {
        let effects = &self.columns[nuisances..];
        let unit = |column: &Column| {
            let norm = column.norm2().sqrt();
            if norm > 0.0 { 1.0 / norm } else { 1.0 }
        };
        effects.iter().map(unit).collect()
    }

    /// By row; `place[i]` is where column i belongs among `count` parameters.
    fn rows(
        &self,
        problem: &Problem,
        place: &[usize],
        scales: &[f64],
        count: usize,
    ) -> Vec<Vec<Datum>> {
        let nuisances = self.columns.len() - scales.len();
        let scale = |i: usize| {
            if i < nuisances {
                1.0
            } else {
                scales[i - nuisances]
            }
        };
        let mut rows: Vec<Vec<Datum>> = problem.rows.iter().map(|_| Vec::new()).collect();
        for slot in 0..SLOTS {
            for at in problem.slots[slot].clone() {
                let mut slopes = DVector::zeros(count);
                for (i, (column, to)) in self.columns.iter().zip(place).enumerate() {
                    if let Some((_, values)) = column.parts.iter().find(|p| p.0 == slot) {
                        slopes[*to] = values[at - problem.slots[slot].start] * scale(i);
                    }
                }
                let difference = self.difference[at];
                if difference.abs() > 1e-6 || slopes.iter().any(|s| *s != 0.0) {
                    rows[problem.row_of[at]].push(Datum {
                        slot,
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

fn of_run(kind: Nuisance) -> bool {
    matches!(kind, Nuisance::RunReference(_) | Nuisance::RunDut(_))
}

/// Where the columns of both problems belong: shared nuisances once, runs apart.
struct Parameters {
    count: usize,
    of_new: Vec<usize>,
    of_old: Vec<usize>,
}

impl Parameters {
    fn new(new: &Problem, old: Option<&Problem>, effects: usize) -> Self {
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
    fn values(&self, of: &Problem, old: Option<&Problem>, theta: &[f64]) -> DVector<f64> {
        let mut values = DVector::zeros(self.count);
        let is_old = old.is_some_and(|old| std::ptr::eq(old, of));
        let place = if is_old { &self.of_old } else { &self.of_new };
        for (value, at) in theta.iter().zip(place) {
            values[*at] = *value;
        }
        values
    }

    fn prior(&self, new: &Problem, old: Option<&Problem>) -> DVector<f64> {
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
