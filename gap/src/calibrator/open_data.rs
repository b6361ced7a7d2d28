//! Data whose scatter an effect leaves open: they may scatter, but not follow a pattern.

use super::evaluation::Evaluation;
use super::problem::Problem;
use super::shapes::Test;
use crate::thresholds;

/// The open data of an evaluation, and the tests that cover enough of them.
pub(super) struct OpenData<'a> {
    tests: Vec<&'a Test>,
    /// Whether half of a datum's variance or more is open.
    open: Vec<bool>,
}

impl<'a> OpenData<'a> {
    pub(super) fn new(problem: &Problem, evaluation: &Evaluation, tests: &'a [Test]) -> Self {
        let open: Vec<bool> = evaluation
            .weight
            .iter()
            .enumerate()
            .map(|(at, w)| w * problem.uncertainty(at) < thresholds::OPEN)
            .collect();
        let covers = |test: &&Test| {
            let (observable, values) = &test.column.parts[0];
            let inside = values.iter().zip(&open[problem.data_of(*observable)]);
            let (mut square, mut fourth) = (0.0, 0.0);
            for (v, _) in inside.filter(|(_, open)| **open) {
                square += v * v;
                fourth += v.powi(4);
            }
            // How the noise itself is left open is a matter of shape: no pattern is asked of it.
            !observable.is_noise() && square * square > thresholds::FEWEST_OPEN * fourth
        };
        let tests = if open.iter().any(|o| *o) {
            tests.iter().filter(covers).collect()
        } else {
            Vec::new()
        };
        Self { tests, open }
    }

    /// Largest deviate over the tests, the scatter taken from the data themselves, and of a
    /// single datum, whose scatter is known to a factor.
    pub(super) fn largest(&self, problem: &Problem, residual: &[f64]) -> f64 {
        let open = residual.iter().zip(&self.open).filter(|(_, open)| **open);
        let outlier = open.fold(0.0, |m: f64, (r, _)| {
            m.max(r.abs() / thresholds::OPEN_FACTOR)
        });
        self.tests.iter().fold(outlier, |most: f64, test| {
            let (observable, values) = &test.column.parts[0];
            let range = problem.data_of(*observable);
            let inside = values
                .iter()
                .zip(&residual[range.clone()])
                .zip(&self.open[range])
                .filter(|(_, open)| **open)
                .map(|((v, r), _)| (*v, *r));
            most.max(by_size(inside.clone())).max(by_sign(inside))
        })
    }
}

/// Deviate of a pattern in data of unknown scatter: divided by its own scatter,
/// a wrong guess of the open size does not matter.
fn by_size(data: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut sum, mut square) = (0.0, 0.0);
    for (v, r) in data {
        sum += v * r;
        square += v * v * (r * r).max(0.25);
    }
    sum.abs() / square.sqrt().max(1e-300) * 0.9
}

/// Tests the sign: a component not locked to the excitation has either sign
/// by chance, however large, so that a few large data do not hide the others.
fn by_sign(data: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut sum, mut square) = (0.0, 0.0);
    for (v, r) in data.filter(|(v, _)| *v != 0.0) {
        let bounded = r.clamp(-1.0, 1.0);
        sum += v.signum() * bounded;
        square += (bounded * bounded).max(0.1);
    }
    sum.abs() / square.sqrt().max(1e-300)
}
