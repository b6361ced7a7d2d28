//! Columns with free amounts: what they take out of a residual.

use super::kind::Kind;
use crate::engine::column::Column;
use crate::engine::normal::Tangent;
use crate::engine::problem::Problem;
use crate::model::row::Row;
use crate::observable::Observable;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Ridge that keeps directions still which the nuisances take over.
const RIDGE: f64 = 1e-6;

/// A rule with one choice of free courses.
pub(super) struct Pattern {
    pub(super) kind: Kind,
    columns: Vec<Column>,
    loads: Vec<DVector<f64>>,
    /// Of the normal matrix, the nuisances taken out.
    factor: Cholesky<f64, Dyn>,
    /// Chi-square that pays for the free amounts: their number times the logarithm of that of the data.
    pub(super) cost: f64,
}

impl Pattern {
    pub(super) fn new(
        problem: &Problem,
        tangent: &Tangent,
        kind: Kind,
        columns: Vec<Column>,
    ) -> Option<Self> {
        let loads: Vec<DVector<f64>> = columns.iter().map(|c| tangent.load(c)).collect();
        let mut matrix = DMatrix::zeros(columns.len(), columns.len());
        for i in 0..columns.len() {
            for j in 0..=i {
                let value = columns[i].dot(&columns[j]) - loads[i].dot(&loads[j]);
                (matrix[(i, j)], matrix[(j, i)]) = (value, value);
            }
            matrix[(i, i)] += RIDGE * columns[i].norm2();
        }
        let data = touched(&columns)
            .map(|observable| problem.data_of(observable).len())
            .sum::<usize>();
        Some(Self {
            kind,
            factor: Cholesky::new(matrix)?,
            cost: columns.len() as f64 * (data as f64).ln(),
            columns,
            loads,
        })
    }

    /// Sizes of the columns that fit a residual best, and the chi-square they take out.
    pub(super) fn fit(&self, problem: &Problem, residual: &[f64]) -> (DVector<f64>, f64) {
        let dots = self.columns.iter().map(|c| c.dot_data(problem, residual));
        let vector = DVector::from_iterator(self.columns.len(), dots);
        let sizes = self.factor.solve(&vector);
        let gain = sizes.dot(&vector);
        (sizes, gain)
    }

    /// Takes the pattern out of a residual, the nuisances refitted.
    pub(super) fn take_out(&self, problem: &Problem, tangent: &Tangent, residual: &mut [f64]) {
        let (sizes, _) = self.fit(problem, residual);
        let mut load = DVector::zeros(tangent.columns.len());
        for (part, size) in self.loads.iter().zip(sizes.iter()) {
            load.axpy(*size, part, 1.0);
        }
        let refitted = tangent.unload(load);
        for (column, size) in self.columns.iter().zip(sizes.iter()) {
            column.add_to(problem, residual, -size);
        }
        for (column, size) in tangent.columns.iter().zip(refitted.iter()) {
            column.add_to(problem, residual, *size);
        }
    }
}

/// Observables of a rule with the sign of the deviation in each.
pub(super) type Parts = [(Observable, f64)];

/// A column of whitened data; what is not finite or was not measured deviates by nothing.
pub(super) fn column(
    problem: &Problem,
    weight: &[f64],
    parts: &Parts,
    shape: &dyn Fn(&Row) -> f64,
) -> Column {
    let value = |at: usize| {
        let value = shape(&problem.rows[problem.row_of[at]]);
        if value.is_finite() {
            value * weight[at]
        } else {
            0.0
        }
    };
    let filled = parts.iter().map(|(observable, sign)| {
        let data = problem.data_of(*observable);
        (
            *observable,
            data.map(|at| sign * value(at)).collect::<Vec<_>>(),
        )
    });
    Column {
        parts: filled
            .filter(|(_, v)| v.iter().any(|x| *x != 0.0))
            .collect(),
    }
}

/// Observables for which columns have values.
fn touched(columns: &[Column]) -> impl Iterator<Item = Observable> {
    let parts = || columns.iter().flat_map(|c| &c.parts);
    let all = Observable::ALL.into_iter();
    all.filter(move |observable| parts().any(|p| p.0 == *observable))
}
