//! Type A evaluation of simultaneous observations, and its propagation.
//!
//! # Source
//! GUM 4.2, 5.2.3, H.2; JCGM 102 (GUM-S2) 6.2 for several outputs.

use nalgebra::{DMatrix, DVector};

/// Means of simultaneously observed quantities with their covariance matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Observed {
    /// Arithmetic means.
    pub mean: DVector<f64>,
    /// Covariance matrix of the means.
    pub covariance: DMatrix<f64>,
    /// Degrees of freedom, n - 1.
    pub degrees_of_freedom: f64,
}

/// Means and covariances of `series`, one slice for each quantity, in which
/// equal positions were observed together.
///
/// Returns `None` unless there are at least two observations and every series
/// has as many.
pub fn observe(series: &[&[f64]]) -> Option<Observed> {
    let count = series.first()?.len();
    if count < 2 || series.iter().any(|values| values.len() != count) {
        return None;
    }
    let n = count as f64;
    let mean = DVector::from_iterator(
        series.len(),
        series.iter().map(|values| values.iter().sum::<f64>() / n),
    );
    let covariance = DMatrix::from_fn(series.len(), series.len(), |row, column| {
        let products = series[row].iter().zip(series[column]);
        products
            .map(|(a, b)| (a - mean[row]) * (b - mean[column]))
            .sum::<f64>()
            / (n * (n - 1.0))
    });
    Some(Observed {
        mean,
        covariance,
        degrees_of_freedom: n - 1.0,
    })
}

/// Covariance matrix from standard uncertainties and correlation coefficients.
pub fn covariance(standard_uncertainties: &[f64], correlation: &DMatrix<f64>) -> DMatrix<f64> {
    let u = DMatrix::from_diagonal(&DVector::from_column_slice(standard_uncertainties));
    &u * correlation * &u
}

/// Covariance of `outputs(inputs)` to first order, `J V J^T`, with central
/// differences over a hundredth of each standard uncertainty.
///
/// # Accuracy
/// The differences are exact to second order; error terms are below 1e-4 of
/// the linearisation error itself. Test `gum_h2_from_the_observations`.
pub fn propagate(
    inputs: &DVector<f64>,
    covariance: &DMatrix<f64>,
    outputs: impl Fn(&DVector<f64>) -> DVector<f64>,
) -> DMatrix<f64> {
    let size = outputs(inputs).len();
    let mut jacobian = DMatrix::zeros(size, inputs.len());
    for column in 0..inputs.len() {
        let step = match covariance[(column, column)].sqrt() * 0.01 {
            0.0 => inputs[column].abs().max(1.0) * 1.0e-6,
            step => step,
        };
        let (mut above, mut below) = (inputs.clone(), inputs.clone());
        above[column] += step;
        below[column] -= step;
        let difference = (outputs(&above) - outputs(&below)) / (2.0 * step);
        jacobian.set_column(column, &difference);
    }
    &jacobian * covariance * jacobian.transpose()
}

/// Correlation coefficient of two outputs.
pub fn correlation(covariance: &DMatrix<f64>, a: usize, b: usize) -> f64 {
    covariance[(a, b)] / (covariance[(a, a)] * covariance[(b, b)]).sqrt()
}
