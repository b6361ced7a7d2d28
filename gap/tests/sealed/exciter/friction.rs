//! Dry friction as a series: a square wave that turns where the velocity does.

use super::series::{HARMONICS, INSTANTS, Series};
use num_complex::Complex64 as C;
use std::f64::consts::{PI, TAU};

/// Series of the friction force of a motion; `velocity_ms` are its values at the instants.
pub(super) fn friction_force(friction_n: f64, travel: &[C], velocity_ms: &[f64]) -> Series {
    let turns = turning_points(travel, velocity_ms);
    let mut force = vec![C::ZERO; HARMONICS + 1];
    for (k, (from_rad, sign)) in turns.iter().enumerate() {
        let to_rad = turns.get(k + 1).map_or(turns[0].0 + TAU, |next| next.0);
        force[0] += friction_n * sign * (to_rad - from_rad) / TAU;
        for (n, order) in force.iter_mut().enumerate().skip(1) {
            let n = n as f64;
            let ends = C::from_polar(1.0, -n * to_rad) - C::from_polar(1.0, -n * from_rad);
            *order += ends / C::new(0.0, -n) * (friction_n * sign / PI);
        }
    }
    force
}

/// Angles at which the velocity changes its sign, with the sign behind.
fn turning_points(travel: &[C], velocity_ms: &[f64]) -> Vec<(f64, f64)> {
    let angle_rad = |k: usize| TAU * k as f64 / INSTANTS as f64;
    let back = |k: usize| velocity_ms[k % INSTANTS] < 0.0;
    (0..INSTANTS)
        .filter(|k| back(*k) != back(k + 1))
        .map(|k| {
            let range = (angle_rad(k), angle_rad(k + 1));
            let sign = if back(k) { 1.0 } else { -1.0 };
            (zero_between(travel, range, back(k)), sign)
        })
        .collect()
}

/// Zero of the velocity between two angles, by bisection.
fn zero_between(travel: &[C], (mut from, mut to): (f64, f64), back_at_from: bool) -> f64 {
    for _ in 0..30 {
        let middle = 0.5 * (from + to);
        match (velocity(travel, middle) < 0.0) == back_at_from {
            true => from = middle,
            false => to = middle,
        }
    }
    0.5 * (from + to)
}

/// Velocity over the angular frequency.
fn velocity(travel: &[C], angle_rad: f64) -> f64 {
    let turn = C::from_polar(1.0, angle_rad);
    let mut power = turn;
    let mut sum = 0.0;
    for (n, c) in travel.iter().enumerate().skip(1) {
        sum += (c * C::new(0.0, n as f64) * power).re;
        power *= turn;
    }
    sum
}
