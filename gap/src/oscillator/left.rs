//! What a fitted oscillator leaves: is it white noise?

use super::fit::Fitted;
use super::model::LINEAR;
use super::residual::{residual, rms};
use super::run::{INTERPOLATED, Run};
use super::slopes::normal;
use crate::engine::significance::{Gauss, chi_square_tail, of_smallest, two_sided};
use nalgebra::{Cholesky, DVector, Dyn};

/// Lags of the tests for memory: a few samples, and about a period of a resonance that is
/// sampled well.
const LAGS: [usize; 2] = [4, 40];
/// Forces whose trace is looked for: the terms that are linear in their size, with their parity.
pub(super) const FORCES: [(usize, Parity); 6] = [
    (0, Parity::Odd),
    (1, Parity::Even),
    (2, Parity::Odd),
    (3, Parity::Odd),
    (4, Parity::Odd),
    (5, Parity::Linear),
];

/// Share of what is left, r.m.s., that the integration may err by: more would be taken for structure.
const RESOLVED: f64 = 0.3;

/// What a force does when the motion is mirrored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Parity {
    /// It is mirrored too.
    Odd,
    /// It stays.
    Even,
    /// It is a linear response.
    Linear,
}

/// What a fit leaves.
#[derive(Debug, Clone)]
pub(super) struct Left {
    /// Probability that white noise leaves as much structure.
    pub(super) p_value: f64,
    /// Whether it is too small to be told from the error of the integration; the p-value is 1 then.
    pub(super) unresolved: bool,
    /// Samples that were compared.
    pub(super) samples: f64,
    /// Standard normal deviate of the trace of each of [`FORCES`] that the fit does not hold.
    pub(super) traces: Vec<(Parity, f64)>,
}

/// Tests the residual for memory and for traces of forces; the null is simulated.
pub(super) fn examine(record: &Run, fit: &Fitted) -> Option<Left> {
    let left = residual(&fit.values, record)?;
    let columns = fit.columns(record, &left, &[])?;
    let space = Space::new(columns)?;
    let missing = FORCES.iter().filter(|f| !fit.terms.contains(&f.0));
    let missing: Vec<(usize, Parity)> = missing.copied().collect();
    let places: Vec<usize> = missing.iter().map(|f| LINEAR + f.0).collect();
    let traces = fit.columns(record, &left, &places)?;
    let traces: Vec<Vec<f64>> = traces.into_iter().map(|t| unit(space.off(t))).collect();
    let known = RESOLVED * rms(&left);
    let unresolved = known
        < fit
            .integration
            .max(INTERPOLATED * RESOLVED * rms(&record.output));
    let left = space.off(left);
    let here = smallest(&left, &traces);
    let count = left.len();
    let p_value = of_smallest(here, |draw: &mut Gauss| {
        smallest(
            &space.off((0..count).map(|_| draw.next()).collect()),
            &traces,
        )
    });
    let deviates = deviates(&left, &traces);
    Some(Left {
        p_value: if unresolved { 1.0 } else { p_value },
        unresolved,
        samples: count as f64,
        traces: missing.iter().map(|m| m.1).zip(deviates).collect(),
    })
}

/// Smallest p-value over all tests; each takes the size of the noise from the residual itself.
fn smallest(left: &[f64], traces: &[Vec<f64>]) -> f64 {
    let traces = deviates(left, traces).into_iter().map(two_sided);
    let memory = LAGS.iter().map(|lags| memory(left, *lags));
    traces.chain(memory).fold(1.0, f64::min)
}

fn deviates(left: &[f64], traces: &[Vec<f64>]) -> Vec<f64> {
    let sigma = (dot(left, left) / left.len() as f64)
        .sqrt()
        .max(f64::MIN_POSITIVE);
    traces.iter().map(|t| dot(t, left) / sigma).collect()
}

/// p-value of the correlations of neighbours up to a lag (Ljung and Box 1978).
fn memory(left: &[f64], lags: usize) -> f64 {
    let (count, power) = (left.len() as f64, dot(left, left));
    let lags = lags.min(left.len() / 4).max(1);
    let of = |lag: usize| {
        let correlation = dot(&left[lag..], &left[..left.len() - lag]) / power;
        correlation * correlation / (count - lag as f64)
    };
    let square = count * (count + 2.0) * (1..=lags).map(of).sum::<f64>();
    chi_square_tail(square, lags as f64)
}

/// The directions that the values of a fit can take over.
struct Space {
    columns: Vec<Vec<f64>>,
    factor: Cholesky<f64, Dyn>,
}

impl Space {
    fn new(columns: Vec<Vec<f64>>) -> Option<Self> {
        let columns: Vec<Vec<f64>> = columns.into_iter().map(unit).collect();
        let zero = vec![0.0; columns.first()?.len()];
        let (matrix, _) = normal(&columns, &zero);
        Some(Self {
            columns,
            factor: Cholesky::new(matrix)?,
        })
    }

    /// A vector without its part in these directions.
    fn off(&self, mut vector: Vec<f64>) -> Vec<f64> {
        let dots = self.columns.iter().map(|c| dot(c, &vector));
        let sizes = self
            .factor
            .solve(&DVector::from_iterator(self.columns.len(), dots));
        for (column, size) in self.columns.iter().zip(sizes.iter()) {
            for (v, c) in vector.iter_mut().zip(column) {
                *v -= size * c;
            }
        }
        vector
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// A vector of length one, or the zero vector.
fn unit(mut vector: Vec<f64>) -> Vec<f64> {
    let length = dot(&vector, &vector).sqrt();
    if length > 0.0 {
        vector.iter_mut().for_each(|v| *v /= length);
    }
    vector
}

#[cfg(test)]
mod tests {
    use super::*;

    /// White noise has a p-value that is even over 0..1: of 40 the smallest is below
    /// 1e-4 once in 250 times. A first-order memory of 0.1 over 4000 samples is 6 sigma: p < 1e-6.
    #[test]
    fn noise_with_a_memory_is_not_white() {
        let mut draw = Gauss::new(3);
        let mut last = 0.0;
        let (mut least, mut with_memory) = (1.0_f64, Vec::new());
        for _ in 0..40 {
            let white: Vec<f64> = (0..4000).map(|_| draw.next()).collect();
            least = least.min(memory(&white, 4));
            with_memory = white
                .iter()
                .map(|w| {
                    last = 0.1 * last + w;
                    last
                })
                .collect();
        }
        assert!(least > 1e-4, "{least}");
        assert!(memory(&with_memory, 4) < 1e-6);
    }
}
