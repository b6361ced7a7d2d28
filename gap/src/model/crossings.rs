//! Where a wave crosses zero.

use super::grid::{GRID, Wave, synthesize, value};
use std::f64::consts::TAU;

/// Parts of the period, from and to in rad, where a wave is positive.
pub(super) fn positive(wave: &Wave) -> Vec<(f64, f64)> {
    let crossings = crossings(wave);
    let Some(&(_, rises)) = crossings.first() else {
        let always = value(wave, 0.0).0 > 0.0;
        return if always { vec![(0.0, TAU)] } else { Vec::new() };
    };
    let mut parts = Vec::with_capacity(crossings.len() / 2 + 1);
    let mut from = (!rises).then_some(0.0);
    for &(at, rises) in &crossings {
        match (rises, from.take()) {
            (true, _) => from = Some(at),
            (false, Some(from)) => parts.push((from, at)),
            (false, None) => {}
        }
    }
    if let Some(from) = from {
        parts.push((from, TAU));
    }
    parts
}

/// Where a wave changes its sign, in order, and whether it rises there.
fn crossings(wave: &Wave) -> Vec<(f64, bool)> {
    let signal = synthesize(wave);
    let step = TAU / GRID as f64;
    let mut found = Vec::new();
    let at = |i: usize| i as f64 * step;
    for i in 0..GRID {
        let (here, next) = (signal[i], signal[(i + 1) % GRID]);
        if (here > 0.0) != (next > 0.0) {
            found.push((root(wave, (at(i), here), (at(i + 1), next)), next > 0.0));
        } else if let Some(turn) = turn_between(&signal, i) {
            // It may touch the other side between two points and come back.
            let top = extremum(wave, at(i) + turn * step);
            let beyond = value(wave, top).0;
            if (beyond > 0.0) != (here > 0.0) && top > at(i) && top < at(i + 1) {
                let there = (top, beyond);
                found.push((root(wave, (at(i), here), there), beyond > 0.0));
                found.push((root(wave, there, (at(i + 1), next)), here > 0.0));
            }
        }
    }
    found
}

/// Where a wave turns towards zero in an interval of the grid, as a share of it, if it could get there.
fn turn_between(signal: &[f64; GRID], i: usize) -> Option<f64> {
    let [before, here, next, after] = [GRID - 1, 0, 1, 2].map(|k| signal[(i + k) % GRID]);
    let (left, right) = (here - before, after - next);
    let towards = -here.signum();
    // Slopes at both ends from the neighbours: towards zero first, away from it last.
    let slopes = [left + (next - here), right + (next - here)].map(|s| 0.5 * towards * s);
    if slopes[0] <= 0.0 || slopes[1] >= 0.0 {
        return None;
    }
    let share = slopes[0] / (slopes[0] - slopes[1]);
    let reach = here.abs() - slopes[0] * share;
    (reach < 0.5 * here.abs()).then_some(share)
}

/// Zero between two places where the signs differ: Newton's steps, halving where they leave the bracket.
fn root(wave: &Wave, low: (f64, f64), high: (f64, f64)) -> f64 {
    let (mut from, mut to) = (low.0, high.0);
    let mut t = from + (to - from) * low.1 / (low.1 - high.1);
    for _ in 0..30 {
        let (v, slope) = value(wave, t);
        if (v > 0.0) == (low.1 > 0.0) {
            from = t;
        } else {
            to = t;
        }
        let next = t - v / slope;
        if next > from && next < to {
            // Newton's step leaves about the square of its size.
            if (next - t).abs() < 1e-7 {
                return next;
            }
            t = next;
        } else {
            t = 0.5 * (from + to);
        }
    }
    t
}

/// Place of an extremum near a place.
fn extremum(wave: &Wave, near: f64) -> f64 {
    const STEP: f64 = 1e-3;
    let mut t = near;
    for _ in 0..4 {
        let [left, here, right] = [-STEP, 0.0, STEP].map(|d| value(wave, t + d).1);
        t -= (here * 2.0 * STEP / (right - left)).clamp(-0.05, 0.05);
    }
    t
}
