//! Correlated inputs: coefficients, their matrix, and whether it can exist.

use nalgebra::{DMatrix, SymmetricEigen};

/// Correlation coefficient of two components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coefficient {
    /// Known or estimated, -1 to 1.
    Known(f64),
    /// Correlated to an unknown degree: the two contributions add linearly,
    /// `(|u1| + |u2|)^2`, which bounds every case (ISO 16063-21 D.4).
    Unknown,
}

/// Correlation between two components, by index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correlation {
    /// First component.
    pub a: usize,
    /// Second component, another than the first.
    pub b: usize,
    /// Coefficient.
    pub coefficient: Coefficient,
}

/// Rounding that a coefficient written with a few decimals may leave in the
/// smallest eigenvalue of a singular matrix: half a unit of the third decimal.
const WRITTEN_TO: f64 = 5.0e-4;

/// The most negative eigenvalue of the known coefficients' matrix, if it is
/// more negative than rounding of the written numbers explains.
pub fn first_negative_eigenvalue(count: usize, correlations: &[Correlation]) -> Option<f64> {
    let matrix = known_matrix(count, correlations);
    let lowest = SymmetricEigen::new(matrix).eigenvalues.min();
    (lowest < -WRITTEN_TO).then_some(lowest)
}

/// Correlation matrix of the known coefficients, ones on the diagonal.
pub(super) fn known_matrix(count: usize, correlations: &[Correlation]) -> DMatrix<f64> {
    let mut matrix = DMatrix::identity(count, count);
    for correlation in correlations {
        if let Coefficient::Known(r) = correlation.coefficient {
            matrix[(correlation.a, correlation.b)] = r;
            matrix[(correlation.b, correlation.a)] = r;
        }
    }
    matrix
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(a: usize, b: usize, r: f64) -> Correlation {
        Correlation {
            a,
            b,
            coefficient: Coefficient::Known(r),
        }
    }

    #[test]
    fn a_matrix_that_cannot_be_is_found() {
        // 1, 2 equal and 2, 3 equal, yet 1, 3 opposed: eigenvalue -1.
        let impossible = [known(0, 1, 1.0), known(1, 2, 1.0), known(0, 2, -1.0)];
        let lowest = first_negative_eigenvalue(3, &impossible).expect("negative");
        assert!((lowest + 1.0).abs() < 1.0e-12);
        // Fully correlated inputs are singular, which is allowed.
        let singular = [known(0, 1, 1.0), known(1, 2, 1.0), known(0, 2, 1.0)];
        assert_eq!(first_negative_eigenvalue(3, &singular), None);
        // GUM H.2 with coefficients printed to two decimals.
        let printed = [known(0, 1, -0.36), known(0, 2, 0.86), known(1, 2, -0.65)];
        assert_eq!(first_negative_eigenvalue(3, &printed), None);
    }
}
