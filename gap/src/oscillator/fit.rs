//! Least squares of the simulated against the recorded output.

use super::model::{LINEAR, TERMS, VALUES, simulate};
use crate::dataset::Record;
use nalgebra::{Cholesky, DMatrix, DVector};

/// Samples at the start that only settle the state.
pub(crate) const SETTLING: usize = 50;
/// Longest part of a record that is fitted.
const MOST_SAMPLES: usize = 20_000;

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
}

/// The part of a record that is fitted.
pub(crate) fn fitted_part(record: &Record) -> Record {
    let count = record.input.len().min(MOST_SAMPLES);
    Record {
        interval_s: record.interval_s,
        input: record.input[..count].to_vec(),
        output: record.output[..count].to_vec(),
    }
}

fn free(terms: &[usize]) -> Vec<usize> {
    (0..LINEAR)
        .chain(terms.iter().map(|t| LINEAR + t))
        .collect()
}

fn residual(values: &[f64; VALUES], record: &Record) -> Option<Vec<f64>> {
    let simulated = simulate(values, record.interval_s, &record.input)?;
    Some(
        record
            .output
            .iter()
            .zip(simulated)
            .skip(SETTLING)
            .map(|(m, s)| m - s)
            .collect(),
    )
}

/// Size of a step of each value for the slopes.
fn nudge(index: usize, scale: f64) -> f64 {
    let unit = if scale > 0.0 { scale } else { 1.0 };
    match index {
        0 => 1e-6,
        1 | 2 => 1e-5,
        3..=5 => 1e-5 * unit,
        6 => 1e-3 / (unit * unit),
        7 => 1e-3 / unit,
        8 => 1e-4 / unit,
        9 => 1e-4 / (unit * unit),
        10 => 1e-5 * unit,
        11 => 1e-3,
        12 => 1e-4 / (unit * unit),
        _ => 1e-3,
    }
}

/// Refines the linear values and the given terms.
pub(crate) fn refine(
    record: &Record,
    start: [f64; VALUES],
    terms: &[usize],
    steps: usize,
) -> Option<Fitted> {
    let free = free(terms);
    let count = record.output.len() as f64;
    let scale = (record.output.iter().map(|x| x * x).sum::<f64>() / count).sqrt();
    let mut values = start;
    let mut left = residual(&values, record)?;
    let mut square: f64 = left.iter().map(|r| r * r).sum();
    let mut damping = 1e-3;
    let (mut matrix, mut gradient) = slopes(record, &values, &left, &free, scale)?;
    for _ in 0..steps {
        let mut damped = matrix.clone();
        for i in 0..free.len() {
            damped[(i, i)] *= 1.0 + damping;
        }
        let step = Cholesky::new(damped)?.solve(&gradient);
        let mut trial = values;
        for (&index, change) in free.iter().zip(step.iter()) {
            trial[index] += change;
        }
        trial[1] = trial[1].clamp(1e-5, 2.0);
        let next = residual(&trial, record);
        let sum = next
            .as_ref()
            .map_or(f64::INFINITY, |l| l.iter().map(|r| r * r).sum());
        if sum < square {
            let gain = (square - sum) / square;
            (values, square) = (trial, sum);
            left = next?;
            damping = (damping * 0.1).max(1e-9);
            if gain < 1e-6 {
                break;
            }
            (matrix, gradient) = slopes(record, &values, &left, &free, scale)?;
        } else {
            damping *= 10.0;
            if damping > 1e8 {
                break;
            }
        }
    }
    let variance = square / (count - free.len() as f64);
    let covariance = Cholesky::new(matrix)?.inverse() * variance;
    Some(Fitted {
        values,
        terms: terms.to_vec(),
        square,
        covariance,
    })
}

/// Normal matrix and gradient by differences.
fn slopes(
    record: &Record,
    values: &[f64; VALUES],
    left: &[f64],
    free: &[usize],
    scale: f64,
) -> Option<(DMatrix<f64>, DVector<f64>)> {
    let columns: Option<Vec<Vec<f64>>> = free
        .iter()
        .map(|&index| {
            let mut there = *values;
            let step = nudge(index, scale);
            there[index] += step;
            let moved = residual(&there, record)?;
            Some(
                left.iter()
                    .zip(moved)
                    .map(|(a, b)| (a - b) / step)
                    .collect(),
            )
        })
        .collect();
    let columns = columns?;
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let matrix = DMatrix::from_fn(free.len(), free.len(), |i, j| {
        dot(&columns[i], &columns[j]) * if i == j { 1.0 + 1e-12 } else { 1.0 }
    });
    let gradient = DVector::from_iterator(free.len(), columns.iter().map(|c| dot(c, left)));
    Some((matrix, gradient))
}

/// Linear fit from the rig's resonance, by growing parts of the record.
pub(crate) fn linear(record: &Record, resonance_hz: f64, delta: f64) -> Option<Fitted> {
    let mut best: Option<Fitted> = None;
    for factor in [1.0, 0.9, 1.1, 0.8, 1.25] {
        let mut values = [0.0; VALUES];
        values[0] = (std::f64::consts::TAU * resonance_hz * factor).ln();
        values[1] = delta;
        values[2] = 1.0;
        values[4] = record.output[0];
        for count in [2_000, 8_000, usize::MAX] {
            let count = record.input.len().min(count);
            let part = Record {
                interval_s: record.interval_s,
                input: record.input[..count].to_vec(),
                output: record.output[..count].to_vec(),
            };
            if let Some(fit) = refine(&part, values, &[], 30) {
                values = fit.values;
                if count == record.input.len()
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
fn explains(fit: &Fitted, record: &Record) -> bool {
    fit.square < 0.3 * record.output.iter().map(|x| x * x).sum::<f64>()
}

/// Simulation errors on another record: only the state at its start is fitted.
pub(crate) fn validation(fit: &Fitted, record: &Record) -> Option<Vec<f64>> {
    let head = Record {
        interval_s: record.interval_s,
        input: record.input[..record.input.len().min(400)].to_vec(),
        output: record.output[..record.output.len().min(400)].to_vec(),
    };
    let mut values = fit.values;
    (values[4], values[5]) = (head.output[0], 0.0);
    for _ in 0..6 {
        // The first samples determine the two states; SETTLING samples take part here only.
        let here = simulate(&values, head.interval_s, &head.input)?;
        let (mut m, mut g) = (DMatrix::<f64>::zeros(2, 2), DVector::<f64>::zeros(2));
        let mut slopes = Vec::new();
        for index in [4, 5] {
            let mut there = values;
            there[index] += 1e-6;
            let moved = simulate(&there, head.interval_s, &head.input)?;
            slopes.push(
                moved
                    .iter()
                    .zip(&here)
                    .map(|(a, b)| (a - b) / 1e-6)
                    .collect::<Vec<f64>>(),
            );
        }
        for n in 0..SETTLING.min(here.len()) {
            for i in 0..2 {
                g[i] += slopes[i][n] * (head.output[n] - here[n]);
                for j in 0..2 {
                    m[(i, j)] += slopes[i][n] * slopes[j][n];
                }
            }
        }
        let step = Cholesky::new(m)?.solve(&g);
        values[4] += step[0];
        values[5] += step[1];
    }
    residual(&values, record)
}

/// Root mean square.
pub(crate) fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|r| r * r).sum::<f64>() / values.len() as f64).sqrt()
}

/// Every term that may be added.
pub(crate) fn all_terms() -> std::ops::Range<usize> {
    0..TERMS.len()
}
