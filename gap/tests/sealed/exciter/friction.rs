//! Dry friction as a series: a square wave that turns where the velocity does.

use super::series::{HARMONICS, INSTANTS, Series};
use num_complex::Complex64 as C;
use std::f64::consts::{PI, TAU};

/// Highest order of the force that moves anything.
const HIGHEST: usize = 401;

/// Series of the friction force of a motion; `velocity_ms` are its values at the instants, and
/// `mobility` is displacement over force of any order.
///
/// The velocity has a bend where the force turns, which [`HARMONICS`] orders round off. What the
/// higher orders of the force itself add there is put back, once with the angles that are too
/// early, once with those found.
pub(super) fn friction_force(
    friction_n: f64,
    travel: &[C],
    velocity_ms: &[f64],
    mobility: impl Fn(usize) -> C,
) -> Series {
    let mut turns = turning_points(travel, velocity_ms);
    let higher: Vec<C> = (HARMONICS + 1..=HIGHEST).map(mobility).collect();
    let rough = turns.clone();
    for _ in 0..2 {
        let missing = missing(friction_n, &turns, &higher);
        let moved = rough.iter().map(|(angle, sign)| {
            let step = missing(*angle) / slope(travel, *angle);
            (angle - step, *sign)
        });
        turns = moved.collect();
    }
    (0..=HARMONICS)
        .map(|n| force_order(friction_n, &turns, n))
        .collect()
}

/// One order of a force that has these signs from these angles on.
fn force_order(friction_n: f64, turns: &[(f64, f64)], n: usize) -> C {
    let order = n as f64;
    let last = turns.first().map(|(from, _)| from + TAU);
    let ends = turns.iter().map(|(from, _)| *from).chain(last);
    let ends = ends.map(|angle| (angle, C::from_polar(1.0, -order * angle)));
    let ends: Vec<(f64, C)> = ends.collect();
    let piece = |(ends, (_, sign)): (&[(f64, C)], &(f64, f64))| match (n, ends[0], ends[1]) {
        (0, (from, _), (to, _)) => C::from(friction_n * sign * (to - from) / TAU),
        (_, (_, from), (_, to)) => (to - from) / C::new(0.0, -order) * (friction_n * sign / PI),
    };
    ends.windows(2).zip(turns).map(piece).sum()
}

/// Velocity over the angular frequency, at an angle, of the orders that are not in the series.
fn missing(friction_n: f64, turns: &[(f64, f64)], higher: &[C]) -> impl Fn(f64) -> f64 + use<> {
    let orders = (HARMONICS + 1..).zip(higher);
    let velocity = orders.map(|(n, mobility)| {
        let travel = -force_order(friction_n, turns, n) * mobility;
        (n as f64, travel * C::new(0.0, n as f64))
    });
    let velocity: Vec<(f64, C)> = velocity.collect();
    move |angle| {
        let turned = |(n, c): &(f64, C)| (c * C::from_polar(1.0, n * angle)).re;
        velocity.iter().map(turned).sum()
    }
}

/// Derivative of the velocity over the angular frequency by the angle.
fn slope(travel: &[C], angle: f64) -> f64 {
    let terms = travel.iter().enumerate();
    terms
        .map(|(n, c)| -((n * n) as f64) * (c * C::from_polar(1.0, n as f64 * angle)).re)
        .sum()
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

#[cfg(test)]
mod tests {
    use super::super::{Amplifier, Exciter};
    use num_complex::Complex64 as C;

    /// Third harmonic over the fundamental of the same rig integrated in time, with exact turning
    /// points; 30 orders alone miss it by 4e-4.
    #[test]
    fn friction_is_that_of_the_motion_in_time() {
        let exciter = Exciter {
            mass_kg: 0.09,
            stiffness_n_per_m: 8000.0,
            creep: None,
            damping_ns_per_m: 3.0,
            force_factor_n_per_a: 7.0,
            back_emf: 1.0,
            resistance_ohm: 4.0,
            inductance_h: 1.2e-4,
            inductance_exponent: 1.0,
            apart: false,
            shorted_share: 0.0,
            shorted_per_s: 1.0,
            diffuses: false,
            quadratic_n_per_m2: 0.0,
            cubic_n_per_m3: 0.0,
            droop_per_m2: 0.0,
            friction_n: 0.0154,
            sag_share: 0.0,
            gravity_ms2: 0.0,
            amplifier: Amplifier {
                clips_at_v: None,
                bends_to_v: None,
                even_per_v: 0.0,
            },
            body: None,
        };
        let motion = exciter.solve(160.0, 1.413_782_638).motion_ms2;
        let found = motion[3] / motion[1].norm();
        let expected = C::new(-0.008_562_984, 0.051_293_902);
        assert!((found - expected).norm() < 5e-5, "{found}");
    }
}
