//! The motion of an oscillator, step by step.

use std::f64::consts::TAU;

use super::{Multisine, Oscillator};
use crate::model::friction;

/// Deflection, velocity, hysteretic state, deflection and velocity of the second mode, what the
/// high-pass holds back, output of the low-pass.
type State = [f64; 7];

/// Phase of the fastest mode per step, rad: `x^4/120` is 5e-10 of the motion per radian.
const PHASE_PER_STEP: f64 = 0.015;

/// Share of the corner of a low-pass that a mode may have and take as many steps: a decay of it per
/// step, where Runge-Kutta is stable up to 2.8.
const SHARE_OF_CORNER: f64 = PHASE_PER_STEP;

/// Output of `oscillator` at `count` instants from 0 in steps of `1 / sample_rate_hz`, starting at
/// rest `settle_s` earlier.
///
/// # Accuracy
/// 1e-6 of the amplitude where all is smooth; with friction, play, and a hysteresis that yields at
/// no less than a hundredth of the amplitude, 3e-4. Tests
/// `a_linear_oscillator_has_its_response` and `halving_the_step_changes_nothing`.
pub fn simulate(
    oscillator: &Oscillator,
    input: &Multisine,
    sample_rate_hz: f64,
    count: usize,
    settle_s: f64,
) -> Vec<f64> {
    simulate_in_steps(
        oscillator,
        input,
        sample_rate_hz,
        count,
        settle_s,
        PHASE_PER_STEP,
    )
}

pub(super) fn simulate_in_steps(
    oscillator: &Oscillator,
    input: &Multisine,
    sample_rate_hz: f64,
    count: usize,
    settle_s: f64,
    phase_per_step: f64,
) -> Vec<f64> {
    let mut highest_hz = oscillator.resonance_hz.max(match oscillator.second_gain {
        0.0 => 0.0,
        _ => oscillator.second_hz,
    });
    if oscillator.output_lowpass_hz.is_finite() {
        highest_hz = highest_hz.max(SHARE_OF_CORNER * oscillator.output_lowpass_hz);
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "small and positive"
    )]
    let (steps, settle) = (
        (TAU * highest_hz / sample_rate_hz / phase_per_step)
            .ceil()
            .max(2.0) as usize,
        (settle_s * sample_rate_hz).ceil() as usize,
    );
    let step_s = 1.0 / sample_rate_hz / steps as f64;
    let mut state = State::default();
    let mut output = Vec::with_capacity(count);
    for sample in 0..settle + count {
        if sample >= settle {
            let time_s = (sample - settle) as f64 / sample_rate_hz;
            output.push(seen(oscillator, &state, time_s));
        }
        let start_s = (sample as f64 - settle as f64) / sample_rate_hz - oscillator.input_delay_s;
        // Runge-Kutta looks at both ends and the middle of each step.
        let forces = input.values(start_s, step_s / 2.0, 2 * steps + 1);
        for step in 0..steps {
            let force = &forces[2 * step..2 * step + 3];
            // The spring is as it is in the middle of the step.
            let time_s = (sample.max(settle) - settle) as f64 / sample_rate_hz;
            let grown = oscillator.resonance_drift_per_s * (time_s + (step as f64 + 0.5) * step_s);
            let stiffer = if sample < settle {
                0.0
            } else {
                grown * (2.0 + grown)
            };
            advance(oscillator, &mut state, force, step_s, stiffer);
        }
    }
    output
}

fn seen(oscillator: &Oscillator, state: &State, time_s: f64) -> f64 {
    let filtered = if oscillator.output_lowpass_hz.is_finite() {
        state[6]
    } else {
        above_the_corner(oscillator, state)
    };
    let shifted = filtered + oscillator.output_drift_per_s * time_s;
    shifted.clamp(-oscillator.output_threshold, oscillator.output_threshold)
}

/// The motion behind the high-pass.
fn above_the_corner(oscillator: &Oscillator, state: &State) -> f64 {
    let total = state[0] + state[3];
    if oscillator.output_corner_hz == 0.0 {
        total
    } else {
        total - state[5]
    }
}

/// One step of Runge-Kutta, then dry friction as an impulse.
fn advance(oscillator: &Oscillator, state: &mut State, force: &[f64], step_s: f64, stiffer: f64) {
    let before = state[1];
    let along = |state: &State, slope: &State, share: f64| -> State {
        std::array::from_fn(|index| state[index] + share * step_s * slope[index])
    };
    let a = rate(oscillator, state, force[0], stiffer);
    let b = rate(oscillator, &along(state, &a, 0.5), force[1], stiffer);
    let c = rate(oscillator, &along(state, &b, 0.5), force[1], stiffer);
    let d = rate(oscillator, &along(state, &c, 1.0), force[2], stiffer);
    for (index, value) in state.iter_mut().enumerate() {
        *value += step_s / 6.0 * (a[index] + 2.0 * b[index] + 2.0 * c[index] + d[index]);
    }
    if oscillator.friction != 0.0 {
        let omega = TAU * oscillator.resonance_hz;
        let rubbed = friction(
            before,
            state[1],
            step_s,
            omega * omega * oscillator.friction,
        );
        state[1] += step_s * rubbed.mean_n;
        // A force moves the further the earlier it acts: by the share of the step that is left.
        state[0] += step_s * step_s * (rubbed.mean_n / 2.0 - rubbed.change_n / 12.0);
    }
}

/// `stiffer` is the growth of the spring since the first sample, relative.
fn rate(oscillator: &Oscillator, state: &State, force: f64, stiffer: f64) -> State {
    let [x, v, z, x2, v2, held_back, passed] = *state;
    let omega = TAU * oscillator.resonance_hz;
    let force = force.clamp(-oscillator.input_threshold, oscillator.input_threshold);
    let drive = oscillator.rho * (force + oscillator.input_offset);
    let speed = v / omega;
    let drag =
        1.0 + oscillator.quadratic_damping * speed.abs() + oscillator.cubic_damping * speed * speed;
    let spring = x - x.clamp(-oscillator.dead_zone, oscillator.dead_zone)
        + stiffer * x
        + x * x * (oscillator.quadratic_stiffness + oscillator.cubic_stiffness * x)
        + oscillator.hysteresis * z;
    let second = TAU * oscillator.second_hz;
    let slip = (v.abs() * z + v * z.abs()) / (2.0 * oscillator.yield_deflection);
    [
        v,
        drive - 2.0 * oscillator.damping * omega * v * drag - omega * omega * spring,
        v - slip,
        v2,
        oscillator.second_gain * drive
            - 2.0 * oscillator.second_damping * second * v2
            - second * second * x2,
        TAU * oscillator.output_corner_hz * (x + x2 - held_back),
        if oscillator.output_lowpass_hz.is_finite() {
            TAU * oscillator.output_lowpass_hz * (above_the_corner(oscillator, state) - passed)
        } else {
            0.0
        },
    ]
}
