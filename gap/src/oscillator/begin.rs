//! Where the fit of a term begins.

use super::model::{DEAD_ZONE, HYSTERESIS, SATURATION, SECOND_MODE, VALUES, places};
use super::moves::{bound, free};
use super::residual::{residual, scale_of};
use super::run::Run;
use super::slopes::{columns, normal};
use nalgebra::Cholesky;

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
