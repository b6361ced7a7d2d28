//! Normal equations of sparse columns, and projection off a tangent space.

use super::column::Column;
use super::evaluation::Evaluation;
use super::problem::{Problem, wrapped};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

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

    /// L^-1 g for a gradient g.
    pub(crate) fn halfway(&self, mut gradient: DVector<f64>) -> DVector<f64> {
        self.factor
            .l_dirty()
            .solve_lower_triangular_mut(&mut gradient);
        gradient
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

/// A step of Levenberg and Marquardt; none where the damped matrix is not positive definite.
pub(crate) fn damped_step(
    matrix: &DMatrix<f64>,
    gradient: &DVector<f64>,
    damping: f64,
) -> Option<DVector<f64>> {
    let mut damped = matrix.clone();
    for i in 0..gradient.len() {
        damped[(i, i)] *= 1.0 + damping;
    }
    Some(Cholesky::new(damped)?.solve(gradient))
}

/// Change of the weighted residual between two evaluations, weights of the first.
pub(crate) fn difference(problem: &Problem, here: &Evaluation, there: &Evaluation) -> Vec<f64> {
    let mut changes = Vec::with_capacity(problem.len());
    for (observable, data) in problem.measured_observables() {
        changes.extend(data.map(|at| {
            let mut change =
                here.residual[at] / here.weight[at] - there.residual[at] / there.weight[at];
            if observable.is_phase() {
                change = wrapped(change);
            }
            change * here.weight[at]
        }));
    }
    changes
}
