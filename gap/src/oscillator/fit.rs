//! Least squares of the simulated against the recorded output.

use super::model::{
    DEAD_ZONE, HELD_BACK, HIGHPASS, HYSTERESIS, LINEAR, LOSSES, SATURATION, SECOND_MODE, TERMS,
    VALUES, places, states,
};
use super::run::{REACH, Run};
use super::simulate::simulate;
use crate::dataset::Record;
use nalgebra::{Cholesky, DMatrix, DVector};

/// Samples at the start that only settle the state.
pub(crate) const SETTLING: usize = 50;
/// Samples at the end beyond which the interpolation of the input would have to look.
const ENDING: usize = REACH;
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

/// Times a record is longer than the memory of a high-pass from which what it held back
/// before is fitted; left free in a slower one it would be an offset of the output.
const REMEMBERED: f64 = 8.0;

/// Values that a fit moves from there.
fn free(terms: &[usize], values: &[f64; VALUES], record: &Run) -> Vec<usize> {
    let duration_s = record.interval_s * record.input.len() as f64;
    let forgets = values[HIGHPASS] * duration_s > REMEMBERED;
    let states = states(terms).into_iter();
    (0..LINEAR)
        .chain(terms.iter().flat_map(|t| places(*t)))
        .chain(states.filter(|s| *s > HELD_BACK || *s == HELD_BACK && forgets))
        .collect()
}

/// Measured minus simulated output after the settling samples; `None` where the simulation diverges.
pub(super) fn residual(values: &[f64; VALUES], record: &Run) -> Option<Vec<f64>> {
    let simulated = simulate(values, record)?;
    let both = compared(&record.output).iter().zip(compared(&simulated));
    Some(both.map(|(m, s)| m - s).collect())
}

/// The samples that are compared: the first settle the state, and at the last the input
/// that follows is not known.
pub(super) fn compared(values: &[f64]) -> &[f64] {
    let end = values.len().saturating_sub(ENDING).max(SETTLING);
    values
        .get(SETTLING..end.min(values.len()))
        .unwrap_or_default()
}

/// Size of a step of each value for the slopes.
fn nudge(values: &[f64; VALUES], index: usize, unit: f64) -> f64 {
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
        SATURATION => 1e-4 * values[index].max(1e-9),
        HIGHPASS => 1e-3,
        SECOND_MODE => 1e-5,
        DEAD_ZONE => 1e-4 * unit,
        _ if index >= HELD_BACK => 1e-5 * unit,
        _ => 1e-3,
    }
}

/// Logarithm of half the rate over the lowest resonance that is tried.
const LOWEST: f64 = 20.0;

/// Keeps damping, widths and frequencies where the simulation can follow them.
fn bound(values: &mut [f64; VALUES], record: &Run, scale: f64) {
    values[1] = values[1].clamp(1e-5, 2.0);
    // Friction and damping take energy out.
    for loss in LOSSES {
        values[loss] = values[loss].max(0.0);
    }
    // A mode must lie below half the rate at which the force is known, the first one too.
    let half_rate = (std::f64::consts::PI / record.interval_s).ln();
    values[0] = values[0].clamp(half_rate - LOWEST, half_rate);
    let highest = half_rate - values[0];
    values[SECOND_MODE + 1] = values[SECOND_MODE + 1].clamp(-7.0, highest);
    values[SECOND_MODE + 2] = values[SECOND_MODE + 2].clamp(1e-4, 1.0);
    values[DEAD_ZONE] = values[DEAD_ZONE].clamp(0.0, 10.0 * scale);
    values[HIGHPASS] = values[HIGHPASS].clamp(0.0, std::f64::consts::PI / record.interval_s);
    values[SATURATION] = values[SATURATION].max(0.0);
    values[HYSTERESIS] = values[HYSTERESIS].clamp(0.0, 10.0);
    let yields_at = values[HYSTERESIS + 1];
    values[HYSTERESIS + 1] = yields_at.clamp((1e-3 * scale).ln(), (30.0 * scale).ln());
}

/// Root mean square of the output.
fn scale_of(record: &Run) -> f64 {
    rms(&record.output).max(f64::MIN_POSITIVE)
}

/// Samples on which starts are compared.
const COMPARED: usize = 4_000;
/// Frequencies of a second mode that are tried: a step of 7 % meets every mode
/// whose resonance is no sharper than that of the start.
const MODES: usize = 90;
/// Damping of a second mode at the start.
const MODE_DAMPING: f64 = 0.05;

/// Where the fit of a term begins: the most promising values of those it is not linear in.
pub(crate) fn begin(record: &Run, base: &[f64; VALUES], term: usize) -> [f64; VALUES] {
    let scale = scale_of(record);
    let with = |changes: &[(usize, f64)]| {
        let mut values = *base;
        changes.iter().for_each(|(at, value)| values[*at] = *value);
        bound(&mut values, record, scale);
        values
    };
    let wide = |share: f64| share * scale;
    let candidates: Vec<[f64; VALUES]> = match places(term).start {
        SECOND_MODE => {
            let highest = (0.9 * std::f64::consts::PI / record.interval_s).ln() - base[0];
            let lowest = highest - 6.2;
            let of = |i: usize| lowest + (highest - lowest) * i as f64 / (MODES - 1) as f64;
            let values = |ln: f64| {
                [
                    (SECOND_MODE, 1e-3),
                    (SECOND_MODE + 1, ln),
                    (SECOND_MODE + 2, MODE_DAMPING),
                ]
            };
            (0..MODES).map(|i| with(&values(of(i)))).collect()
        }
        SATURATION => {
            let largest = record.input.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
            [0.97, 0.9, 0.8, 0.65, 0.5, 0.35, 0.2]
                .map(|share| with(&[(SATURATION, 1.0 / (share * largest))]))
                .into()
        }
        DEAD_ZONE => [0.003, 0.01, 0.03, 0.1, 0.3, 1.0]
            .map(|w| with(&[(DEAD_ZONE, wide(w))]))
            .into(),
        HYSTERESIS => [0.03, 0.1, 0.3, 1.0, 3.0]
            .map(|w| with(&[(HYSTERESIS, 1e-3), (HYSTERESIS + 1, wide(w).ln())]))
            .into(),
        _ => return *base,
    };
    most_promising(record, base, term, &candidates).unwrap_or(*base)
}

/// The candidate that, scaled, takes most out of what the base leaves beside the linear values.
fn most_promising(
    record: &Run,
    base: &[f64; VALUES],
    term: usize,
    candidates: &[[f64; VALUES]],
) -> Option<[f64; VALUES]> {
    let part = record.head(COMPARED);
    let left = residual(base, &part)?;
    let linear = columns(
        &part,
        base,
        &left,
        &free(&[], base, &part),
        scale_of(record),
    )?;
    let amplitude = places(term).start;
    let gain = |candidate: &[f64; VALUES]| -> Option<(f64, f64)> {
        let there = residual(candidate, &part)?;
        let change: Vec<f64> = left.iter().zip(&there).map(|(a, b)| a - b).collect();
        let mut all = linear.clone();
        all.push(change);
        let (matrix, gradient) = normal(&all, &left);
        let step = Cholesky::new(matrix)?.solve(&gradient);
        Some((step.dot(&gradient), step[step.len() - 1]))
    };
    let scored = candidates.iter().filter_map(|c| gain(c).map(|g| (g, c)));
    let ((_, size), best) = scored.max_by(|a, b| a.0.0.total_cmp(&b.0.0))?;
    let mut values = *best;
    // A width or a threshold is no amplitude.
    if amplitude != DEAD_ZONE && amplitude != SATURATION {
        values[amplitude] *= size;
    }
    bound(&mut values, record, scale_of(record));
    Some(values)
}

/// Refines the linear values and the given terms.
pub(crate) fn refine(
    record: &Run,
    start: [f64; VALUES],
    terms: &[usize],
    steps: usize,
) -> Option<Fitted> {
    let free = free(terms, &start, record);
    let count = record.output.len() as f64;
    let scale = scale_of(record);
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
        if trial.iter().any(|v| !v.is_finite()) {
            break;
        }
        bound(&mut trial, record, scale);
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
        integration: 0.0,
    })
}

/// Normal matrix and gradient by differences.
fn slopes(
    record: &Run,
    values: &[f64; VALUES],
    left: &[f64],
    free: &[usize],
    scale: f64,
) -> Option<(DMatrix<f64>, DVector<f64>)> {
    Some(normal(&columns(record, values, left, free, scale)?, left))
}

/// Change of the simulated output with each value, by differences.
fn columns(
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

/// Change of the simulated output with the values a fit moves, or with those at the given places.
pub(super) fn columns_of(
    record: &Run,
    fit: &Fitted,
    left: &[f64],
    places: &[usize],
) -> Option<Vec<Vec<f64>>> {
    let moved = free(&fit.terms, &fit.values, record);
    let wanted = if places.is_empty() { &moved } else { places };
    columns(record, &fit.values, left, wanted, scale_of(record))
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

/// Simulation errors on another record: only the state at its start is fitted.
pub(crate) fn validation(fit: &Fitted, record: &Run) -> Option<Vec<f64>> {
    let head = record.head(400);
    let mut values = fit.values;
    let states = states(&fit.terms);
    states.iter().for_each(|state| values[*state] = 0.0);
    (values[4], values[5]) = first_state(&head, values[0]);
    // The first samples determine the states; SETTLING samples take part here only. A few of
    // them first: over many periods a bent spring's phase has more than one solution.
    for count in [
        SETTLING / 4,
        SETTLING / 4,
        SETTLING / 2,
        SETTLING,
        SETTLING,
        SETTLING,
    ] {
        let here = simulate(&values, &head)?;
        let errors = head.output.iter().zip(&here).take(count);
        let left: Vec<f64> = errors.map(|(m, s)| m - s).collect();
        let of = |&state: &usize| {
            let mut there = values;
            there[state] += 1e-6;
            let moved = simulate(&there, &head)?;
            let change = moved.iter().zip(&here).take(count);
            Some(change.map(|(a, b)| (a - b) / 1e-6).collect())
        };
        let columns: Vec<Vec<f64>> = states.iter().map(of).collect::<Option<_>>()?;
        let (matrix, gradient) = normal(&columns, &left);
        let step = Cholesky::new(matrix)?.solve(&gradient);
        for (state, change) in states.iter().zip(step.iter()) {
            values[*state] += change;
        }
    }
    residual(&values, record)
}

/// Displacement and velocity at the first sample, from the first three; `ln_w0` as in a simulation.
pub(super) fn first_state(run: &Run, ln_w0: f64) -> (f64, f64) {
    match run.output[..] {
        [x0, x1, x2, ..] => {
            let interval = ln_w0.exp() * run.interval_s;
            (x0, (4.0 * x1 - 3.0 * x0 - x2) / (2.0 * interval))
        }
        _ => (0.0, 0.0),
    }
}

/// Root mean square.
pub(crate) fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|r| r * r).sum::<f64>() / values.len() as f64).sqrt()
}

/// Every term that may be added.
pub(crate) fn all_terms() -> std::ops::Range<usize> {
    0..TERMS.len()
}
