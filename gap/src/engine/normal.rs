//! Normal equations of sparse columns, and projection off a tangent space.

use super::problem::{Column, Evaluation, Problem, is_phase, wrapped};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

impl Column {
    /// Inner product with another column.
    pub(crate) fn dot(&self, other: &Self) -> f64 {
        let mut sum = 0.0;
        for (slot, a) in &self.parts {
            if let Some((_, b)) = other.parts.iter().find(|(s, _)| s == slot) {
                sum += inner(a, b);
            }
        }
        sum
    }

    /// Inner product with a vector over all data.
    pub(crate) fn dot_data(&self, problem: &Problem, data: &[f64]) -> f64 {
        self.parts
            .iter()
            .map(|(slot, a)| inner(a, &data[problem.slots[*slot].clone()]))
            .sum()
    }

    /// Square of the length.
    pub(crate) fn norm2(&self) -> f64 {
        self.parts.iter().map(|(_, a)| inner(a, a)).sum()
    }

    /// Adds a multiple of the column to a vector over all data.
    pub(crate) fn add_to(&self, problem: &Problem, data: &mut [f64], factor: f64) {
        for (slot, values) in &self.parts {
            for (d, v) in data[problem.slots[*slot].clone()].iter_mut().zip(values) {
                *d += factor * v;
            }
        }
    }

    /// Column of differences `(b - a) * scale` over all data, zero slots left out.
    pub(crate) fn difference(problem: &Problem, a: &[f64], b: &[f64], scale: f64) -> Self {
        let mut parts = Vec::new();
        for (slot, range) in problem.slots.iter().enumerate() {
            let values: Vec<f64> = a[range.clone()]
                .iter()
                .zip(&b[range.clone()])
                .map(|(a, b)| (b - a) * scale)
                .collect();
            if values.iter().any(|v| v.abs() > 1e-11 * scale.abs()) {
                parts.push((slot, values));
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

/// Tangent space of a fit: columns, their priors, and the factor of the normal matrix.
pub(crate) struct Tangent {
    pub(crate) columns: Vec<Column>,
    factor: Cholesky<f64, Dyn>,
}

impl Tangent {
    /// Builds the tangent space; `prior[i]` is 1 for a parameter with a prior of one unit.
    pub(crate) fn new(columns: Vec<Column>, prior: &[f64]) -> Option<Self> {
        let matrix = gram(&columns, prior);
        let factor = Cholesky::new(matrix)?;
        Some(Self { columns, factor })
    }

    /// L^-1 T' b for a column b.
    pub(crate) fn load(&self, column: &Column) -> DVector<f64> {
        let mut inner = DVector::from_iterator(
            self.columns.len(),
            self.columns.iter().map(|c| c.dot(column)),
        );
        self.factor.l_dirty().solve_lower_triangular_mut(&mut inner);
        inner
    }

    /// L'^-1 v: the parameters that a load stands for.
    pub(crate) fn unload(&self, mut load: DVector<f64>) -> DVector<f64> {
        self.factor
            .l_dirty()
            .tr_solve_lower_triangular_mut(&mut load);
        load
    }

    /// Data without what the parameters take over, and the values they take.
    pub(crate) fn reduce(&self, problem: &Problem, data: &[f64]) -> (Vec<f64>, DVector<f64>) {
        let gradient = DVector::from_iterator(
            self.columns.len(),
            self.columns.iter().map(|c| c.dot_data(problem, data)),
        );
        let solution = self.factor.solve(&gradient);
        let mut left = data.to_vec();
        for (column, value) in self.columns.iter().zip(solution.iter()) {
            column.add_to(problem, &mut left, -value);
        }
        (left, solution)
    }

    /// Values of the parameters for a gradient.
    pub(crate) fn solve(&self, gradient: &DVector<f64>) -> DVector<f64> {
        self.factor.solve(gradient)
    }

    /// Covariance matrix of the parameters.
    pub(crate) fn covariance(&self) -> DMatrix<f64> {
        self.factor.inverse()
    }
}

/// Gram matrix of columns plus priors, with a ridge that keeps idle parameters still.
pub(crate) fn gram(columns: &[Column], prior: &[f64]) -> DMatrix<f64> {
    let count = columns.len();
    let mut matrix = DMatrix::zeros(count, count);
    for i in 0..count {
        for j in 0..=i {
            let value = columns[i].dot(&columns[j]);
            matrix[(i, j)] = value;
            matrix[(j, i)] = value;
        }
        let own = matrix[(i, i)];
        matrix[(i, i)] += prior[i] + if own > 0.0 { 1e-9 * own } else { 1.0 };
    }
    matrix
}

/// Change of the weighted residual between two evaluations, weights of the first.
pub(crate) fn difference(problem: &Problem, here: &Evaluation, there: &Evaluation) -> Vec<f64> {
    (0..problem.len())
        .map(|at| {
            let mut change =
                here.residual[at] / here.weight[at] - there.residual[at] / there.weight[at];
            if is_phase(problem.slot_of(at)) {
                change = wrapped(change);
            }
            change * here.weight[at]
        })
        .collect()
}
