//! Columns of a Jacobian over the data, sparse by observable.

use super::problem::Problem;
use crate::model::row::Row;
use crate::observable::Observable;

/// Values for the data of one observable.
pub(crate) type Part = (Observable, Vec<f64>);

/// One column of a Jacobian: values for the observables it touches.
#[derive(Debug, Clone, Default)]
pub(crate) struct Column {
    pub(crate) parts: Vec<Part>,
}

impl Column {
    /// Inner product with another column.
    pub(crate) fn dot(&self, other: &Self) -> f64 {
        let mut sum = 0.0;
        for (observable, a) in &self.parts {
            if let Some((_, b)) = other.parts.iter().find(|(o, _)| o == observable) {
                sum += inner(a, b);
            }
        }
        sum
    }

    /// Inner product with a vector over all data.
    pub(crate) fn dot_data(&self, problem: &Problem, data: &[f64]) -> f64 {
        self.parts
            .iter()
            .map(|(observable, a)| inner(a, &data[problem.data_of(*observable)]))
            .sum()
    }

    /// Square of the length.
    pub(crate) fn norm2(&self) -> f64 {
        self.parts.iter().map(|(_, a)| inner(a, a)).sum()
    }

    /// The column where a condition holds for the row, zero elsewhere.
    pub(crate) fn only(&self, problem: &Problem, holds: impl Fn(&Row) -> bool) -> Self {
        let mut kept = self.clone();
        for (observable, values) in &mut kept.parts {
            let rows = &problem.row_of[problem.data_of(*observable)];
            for (value, row) in values.iter_mut().zip(rows) {
                *value *= f64::from(u8::from(holds(&problem.rows[*row])));
            }
        }
        kept
    }

    /// Adds values for an observable.
    pub(crate) fn add_part(&mut self, observable: Observable, values: Vec<f64>) {
        match self.parts.iter_mut().find(|(o, _)| *o == observable) {
            Some((_, sum)) => sum.iter_mut().zip(values).for_each(|(s, v)| *s += v),
            None => self.parts.push((observable, values)),
        }
    }

    /// Multiplies the column.
    pub(crate) fn scale(&mut self, factor: f64) {
        for (_, values) in &mut self.parts {
            values.iter_mut().for_each(|v| *v *= factor);
        }
    }

    /// Adds a multiple of the column to a vector over all data.
    pub(crate) fn add_to(&self, problem: &Problem, data: &mut [f64], factor: f64) {
        for (observable, values) in &self.parts {
            let data = &mut data[problem.data_of(*observable)];
            for (d, v) in data.iter_mut().zip(values) {
                *d += factor * v;
            }
        }
    }

    /// Column of differences `(b - a) * scale` over all data, observables without any left out.
    pub(crate) fn difference(problem: &Problem, a: &[f64], b: &[f64], scale: f64) -> Self {
        let mut parts = Vec::new();
        for (observable, range) in problem.measured_observables() {
            let values: Vec<f64> = a[range.clone()]
                .iter()
                .zip(&b[range.clone()])
                .map(|(a, b)| (b - a) * scale)
                .collect();
            if values.iter().any(|v| v.abs() > 1e-11 * scale.abs()) {
                parts.push((observable, values));
            }
        }
        Self { parts }
    }
}

/// Inner product in four lanes, so that the compiler may use vector instructions.
fn inner(a: &[f64], b: &[f64]) -> f64 {
    let mut lanes = [0.0; 4];
    let ((chunks_a, rest_a), (chunks_b, rest_b)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    for (x, y) in chunks_a.iter().zip(chunks_b) {
        for lane in 0..4 {
            lanes[lane] += x[lane] * y[lane];
        }
    }
    let rest: f64 = rest_a.iter().zip(rest_b).map(|(x, y)| x * y).sum();
    lanes.iter().sum::<f64>() + rest
}
