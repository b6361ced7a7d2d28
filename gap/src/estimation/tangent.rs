//! Normal equations of least squares, and projection off the tangent space of a fit.

use super::column::{Blocks, Column};
use crate::thresholds;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Normal equations at a fit, for steps of any damping.
pub(crate) struct Equations {
    pub(crate) matrix: DMatrix<f64>,
    pub(crate) gradient: DVector<f64>,
}

impl Equations {
    /// Equations of columns with a prior each and the residual they are to explain; `pulled[i]` is
    /// how far a parameter with a prior already is from it (none beyond the end).
    pub(crate) fn new<B: Copy + PartialEq>(
        of: &impl Blocks<Block = B>,
        columns: &[Column<B>],
        prior: &[f64],
        residual: &[f64],
        pulled: &[f64],
    ) -> Self {
        let mut gradient = DVector::zeros(columns.len());
        for (i, column) in columns.iter().enumerate() {
            gradient[i] = column.dot_data(of, residual);
            if let Some(pulled) = pulled.get(i) {
                gradient[i] -= prior.get(i).unwrap_or(&0.0) * pulled;
            }
        }
        Self {
            matrix: gram(columns, prior, RIDGE),
            gradient,
        }
    }

    /// Adds a datum with its slopes.
    pub(crate) fn add(&mut self, slopes: &DVector<f64>, difference: f64) {
        self.matrix.ger(1.0, slopes, slopes, 1.0);
        self.gradient.axpy(difference, slopes, 1.0);
    }

    /// Keeps a parameter where it is, and the others from being moved on its account.
    pub(crate) fn hold(&mut self, at: usize) {
        self.matrix.row_mut(at).fill(0.0);
        self.matrix.column_mut(at).fill(0.0);
        self.matrix[(at, at)] = 1.0;
        self.gradient[at] = 0.0;
    }

    /// A step of Levenberg and Marquardt; none where the damped matrix is not positive definite.
    pub(crate) fn step(&self, damping: f64) -> Option<DVector<f64>> {
        let mut damped = self.matrix.clone();
        for i in 0..self.gradient.len() {
            damped[(i, i)] *= 1.0 + damping;
        }
        Some(Cholesky::new(damped)?.solve(&self.gradient))
    }

    /// Decrease of the sum of squares that a step promises, as if the model were linear.
    pub(crate) fn predicted(&self, step: &DVector<f64>) -> f64 {
        2.0 * self.gradient.dot(step) - step.dot(&(&self.matrix * step))
    }

    /// Covariance matrix of the parameters for data of unit variance.
    pub(crate) fn covariance(&self) -> Option<DMatrix<f64>> {
        Some(Cholesky::new(self.matrix.clone())?.inverse())
    }
}

/// Tangent space of a fit: columns, their priors, and the factor of the normal matrix.
pub(crate) struct Tangent<B> {
    pub(crate) columns: Vec<Column<B>>,
    factor: Cholesky<f64, Dyn>,
}

impl<B: Copy + PartialEq> Tangent<B> {
    /// Builds the tangent space; `prior[i]` is 1 for a parameter with a prior of one unit.
    pub(crate) fn new(columns: Vec<Column<B>>, prior: &[f64]) -> Option<Self> {
        let matrix = gram(&columns, prior, RIDGE);
        let factor = Cholesky::new(matrix)?;
        Some(Self { columns, factor })
    }

    /// L^-1 T' b for a column b.
    pub(crate) fn load(&self, column: &Column<B>) -> DVector<f64> {
        let dots = self.columns.iter().map(|c| c.dot(column));
        self.halfway(DVector::from_iterator(self.columns.len(), dots))
    }

    /// L^-1 g for a gradient g.
    pub(crate) fn halfway(&self, mut gradient: DVector<f64>) -> DVector<f64> {
        self.factor
            .l_dirty()
            .solve_lower_triangular_mut(&mut gradient);
        gradient
    }

    /// L'^-1 v: the parameters that a load stands for.
    fn unload(&self, mut load: DVector<f64>) -> DVector<f64> {
        self.factor
            .l_dirty()
            .tr_solve_lower_triangular_mut(&mut load);
        load
    }

    /// Data without what the parameters take over, and the values they take.
    pub(crate) fn reduce(
        &self,
        of: &impl Blocks<Block = B>,
        data: &[f64],
    ) -> (Vec<f64>, DVector<f64>) {
        let dots = self.columns.iter().map(|c| c.dot_data(of, data));
        let gradient = DVector::from_iterator(self.columns.len(), dots);
        let solution = self.factor.solve(&gradient);
        let mut left = data.to_vec();
        for (column, value) in self.columns.iter().zip(solution.iter()) {
            column.add_to(of, &mut left, -value);
        }
        (left, solution)
    }

    /// Part of columns outside this space; `ridge`, a share of each column, keeps those still that it
    /// takes over.
    pub(crate) fn beside(&self, columns: &[Column<B>], ridge: f64) -> Beside {
        let loads: Vec<DVector<f64>> = columns.iter().map(|c| self.load(c)).collect();
        let mut matrix = gram(columns, &[], ridge);
        for i in 0..columns.len() {
            for j in 0..columns.len() {
                matrix[(i, j)] -= loads[i].dot(&loads[j]);
            }
        }
        Beside { loads, matrix }
    }

    /// Changes of the parameters that make room for columns of some sizes.
    pub(crate) fn refitted(&self, beside: &Beside, sizes: &DVector<f64>) -> DVector<f64> {
        let mut load = DVector::zeros(self.columns.len());
        for (part, size) in beside.loads.iter().zip(sizes.iter()) {
            load.axpy(-size, part, 1.0);
        }
        self.unload(load)
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

/// Columns beside a tangent space, which takes over part of each.
pub(crate) struct Beside {
    /// L^-1 T' b of each column b.
    pub(crate) loads: Vec<DVector<f64>>,
    /// Normal matrix of the rest of the columns.
    pub(crate) matrix: DMatrix<f64>,
}

impl Beside {
    /// Products of the rest of the columns with a residual that asks the parameters for `owed`,
    /// L^-1 of their gradient; none where the tangent space takes over a column completely.
    pub(crate) fn products<B: Copy + PartialEq>(
        &self,
        of: &impl Blocks<Block = B>,
        columns: &[Column<B>],
        residual: &[f64],
        owed: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let mut products = DVector::zeros(columns.len());
        for (i, (column, load)) in columns.iter().zip(&self.loads).enumerate() {
            // At an optimum the fit owes nothing: its own gradients are balanced by their priors. A
            // parameter that is stuck at a bound has a slope left, which is no promise of others.
            products[i] = column.dot_data(of, residual) - load.dot(owed);
            // A direction that the nuisances can take over completely promises nothing.
            // (One that they take over against their priors does: the priors are the evidence.)
            if self.matrix[(i, i)] < thresholds::TAKEN_OVER * column.norm2() {
                return None;
            }
        }
        Some(products)
    }
}

/// Share of a column that keeps idle parameters still.
pub(crate) const RIDGE: f64 = 1e-9;

/// Gram matrix of columns plus priors (none beyond the end), with a ridge: a share of each column.
fn gram<B: Copy + PartialEq>(columns: &[Column<B>], prior: &[f64], ridge: f64) -> DMatrix<f64> {
    let count = columns.len();
    let mut matrix = DMatrix::zeros(count, count);
    for i in 0..count {
        for j in 0..=i {
            let value = columns[i].dot(&columns[j]);
            matrix[(i, j)] = value;
            matrix[(j, i)] = value;
        }
        let own = matrix[(i, i)];
        let prior = prior.get(i).copied().unwrap_or(0.0);
        matrix[(i, i)] += prior + if own > 0.0 { ridge * own } else { 1.0 };
    }
    matrix
}
