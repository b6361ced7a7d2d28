//! Which values of an oscillator a fit moves, between which bounds, and in which steps.

use super::model::{
    DEAD_ZONE, HELD_BACK, HIGHPASS, HYSTERESIS, LINEAR, LOSSES, SATURATION, SECOND_MODE, VALUES,
    places, states,
};
use super::run::Run;

/// Times a record is longer than the memory of a high-pass from which what it held back
/// before is fitted; left free in a slower one it would be an offset of the output.
const REMEMBERED: f64 = 8.0;

/// Values that a fit moves from there.
pub(super) fn free(terms: &[usize], values: &[f64; VALUES], record: &Run) -> Vec<usize> {
    let duration_s = record.interval_s * record.input.len() as f64;
    let forgets = values[HIGHPASS] * duration_s > REMEMBERED;
    let states = states(terms).into_iter();
    (0..LINEAR)
        .chain(terms.iter().flat_map(|t| places(*t)))
        .chain(states.filter(|s| *s > HELD_BACK || *s == HELD_BACK && forgets))
        .collect()
}

/// Logarithm of half the rate over the lowest resonance that is tried.
const LOWEST: f64 = 20.0;

/// Keeps damping, widths and frequencies where the simulation can follow them.
pub(super) fn bound(values: &mut [f64; VALUES], record: &Run, scale: f64) {
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

/// Size of a step of each value for the slopes.
pub(super) fn nudge(values: &[f64; VALUES], index: usize, unit: f64) -> f64 {
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
