//! Least squares of the simulated against the recorded output.

use super::model::VALUES;
use super::moves::{bound, free};
use super::residual::{compared, residual, rms, scale_of};
use super::run::Run;
use super::simulate::simulate;
use super::slopes::{columns, normal};
use crate::engine::normal::damped_step;
use nalgebra::{Cholesky, DMatrix, DVector};

/// Share of the squared error that a step must take out for another to follow.
const ENOUGH: f64 = 1e-6;
/// Damping of the steps beyond which no step helps.
const MOST_DAMPING: f64 = 1e8;

/// A fitted oscillator.
#[derive(Clone)]
pub(crate) struct Fitted {
    pub(crate) values: [f64; VALUES],
    /// Terms in use.
    pub(crate) terms: Vec<usize>,
    /// Sum of squared simulation errors.
    pub(crate) square: f64,
    /// Covariance of the free values, residual variance included.
    pub(crate) covariance: DMatrix<f64>,
    /// Estimated error of the integration, r.m.s.; zero where nobody asked.
    pub(crate) integration: f64,
}

impl Fitted {
    /// Difference, r.m.s., to an integration in other steps.
    pub(super) fn off(&self, run: &Run, finer: &Run) -> Option<f64> {
        let (here, there) = (simulate(&self.values, run)?, simulate(&self.values, finer)?);
        let off: Vec<f64> = here.iter().zip(&there).map(|(a, b)| a - b).collect();
        Some(rms(compared(&off)))
    }

    /// Change of the simulated output with the values the fit moves, or with those at `places` if
    /// there are any; `left` is what the fit leaves.
    pub(super) fn columns(
        &self,
        record: &Run,
        left: &[f64],
        places: &[usize],
    ) -> Option<Vec<Vec<f64>>> {
        let moved = free(&self.terms, &self.values, record);
        let wanted = if places.is_empty() { &moved } else { places };
        columns(record, &self.values, left, wanted, scale_of(record))
    }
}

/// Refines the linear values and the given terms.
pub(crate) fn refine(
    record: &Run,
    start: [f64; VALUES],
    terms: &[usize],
    steps: usize,
) -> Option<Fitted> {
    let free = free(terms, &start, record);
    let scale = scale_of(record);
    let mut here = Place::new(start, record)?;
    let mut damping = 1e-3;
    let (mut matrix, mut gradient) = here.normal(record, &free, scale)?;
    for _ in 0..steps {
        let mut values = here.moved(&free, &damped_step(&matrix, &gradient, damping)?);
        if values.iter().any(|v| !v.is_finite()) {
            break;
        }
        bound(&mut values, record, scale);
        match Place::new(values, record).filter(|there| there.square < here.square) {
            Some(there) => {
                let gain = (here.square - there.square) / here.square;
                here = there;
                damping = (damping * 0.1).max(1e-9);
                if gain < ENOUGH {
                    break;
                }
                (matrix, gradient) = here.normal(record, &free, scale)?;
            }
            None => {
                damping *= 10.0;
                if damping > MOST_DAMPING {
                    break;
                }
            }
        }
    }
    let variance = here.square / (record.output.len() as f64 - free.len() as f64);
    Some(Fitted {
        values: here.values,
        terms: terms.to_vec(),
        square: here.square,
        covariance: Cholesky::new(matrix)?.inverse() * variance,
        integration: 0.0,
    })
}

/// Values on the way of a fit, and what they leave.
struct Place {
    values: [f64; VALUES],
    left: Vec<f64>,
    square: f64,
}

impl Place {
    /// `None` where the simulation diverges.
    fn new(values: [f64; VALUES], record: &Run) -> Option<Self> {
        let left = residual(&values, record)?;
        Some(Self {
            values,
            square: left.iter().map(|r| r * r).sum(),
            left,
        })
    }

    /// The values a step further.
    fn moved(&self, free: &[usize], step: &DVector<f64>) -> [f64; VALUES] {
        let mut values = self.values;
        for (&index, change) in free.iter().zip(step.iter()) {
            values[index] += change;
        }
        values
    }

    /// Normal matrix and gradient against the free values.
    fn normal(
        &self,
        record: &Run,
        free: &[usize],
        scale: f64,
    ) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let columns = columns(record, &self.values, &self.left, free, scale)?;
        Some(normal(&columns, &self.left))
    }
}

/// Size of a first stretch over that of the whole record below which it says nothing.
const QUIET: f64 = 0.1;

/// Linear fit from the rig's resonance, by growing parts of the record.
pub(crate) fn linear(record: &Run, resonance_hz: f64, delta: f64) -> Option<Fitted> {
    let mut best: Option<Fitted> = None;
    for factor in [1.0, 0.9, 1.1, 0.8, 1.25] {
        let mut values = [0.0; VALUES];
        values[0] = (std::f64::consts::TAU * resonance_hz * factor).ln();
        values[1] = delta;
        values[2] = 1.0;
        values[4] = record.output[0];
        for count in [2_000, 8_000, usize::MAX] {
            let part = record.head(count);
            // A stretch before a shock shows nothing but noise.
            if rms(&part.output) < QUIET * scale_of(record) {
                continue;
            }
            if let Some(fit) = refine(&part, values, &[], 30) {
                values = fit.values;
                if part.input.len() == record.input.len()
                    && best.as_ref().is_none_or(|b| fit.square < b.square)
                {
                    best = Some(fit);
                }
            }
        }
        if factor == 1.0 && best.as_ref().is_some_and(|b| explains(b, record)) {
            break;
        }
    }
    best
}

/// Whether a fit describes most of the output.
fn explains(fit: &Fitted, record: &Run) -> bool {
    fit.square < 0.3 * record.output.iter().map(|x| x * x).sum::<f64>()
}
