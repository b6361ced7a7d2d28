//! Slopes of the simulated output, by differences, and their normal equations.

use super::model::VALUES;
use super::moves::nudge;
use super::residual::residual;
use super::run::Run;
use nalgebra::{DMatrix, DVector};

/// Change of the simulated output with each value, by differences.
pub(super) fn columns(
    record: &Run,
    values: &[f64; VALUES],
    left: &[f64],
    free: &[usize],
    scale: f64,
) -> Option<Vec<Vec<f64>>> {
    let of = |&index: &usize| {
        let mut there = *values;
        let step = nudge(values, index, scale);
        there[index] += step;
        let moved = residual(&there, record)?;
        Some(
            left.iter()
                .zip(moved)
                .map(|(a, b)| (a - b) / step)
                .collect(),
        )
    };
    free.iter().map(of).collect()
}

/// Normal matrix and gradient of columns.
pub(super) fn normal(columns: &[Vec<f64>], left: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let count = columns.len();
    let mut matrix = DMatrix::zeros(count, count);
    for i in 0..count {
        for j in 0..=i {
            let value = dot(&columns[i], &columns[j]);
            (matrix[(i, j)], matrix[(j, i)]) = (value, value);
        }
        // A value that the output does not depend on stands still.
        matrix[(i, i)] = if matrix[(i, i)] > 0.0 {
            matrix[(i, i)] * (1.0 + 1e-12)
        } else {
            1.0
        };
    }
    let gradient = DVector::from_iterator(count, columns.iter().map(|c| dot(c, left)));
    (matrix, gradient)
}
