//! The simulation of an oscillator over a record.
//!
//! x'' + 2 delta x' + x = gain u + force - terms(x, x'), in time of 1/w0. The
//! linear part and its input are propagated exactly, but for the interpolation
//! of the input by polynomials of degree six; the terms are integrated with the
//! classical Runge-Kutta method in the frame of that motion (Lawson 1967).

use super::channel::Channel;
use super::mode::{Mode, NODES, State};
use super::parameters::{OscillatorParameters, Parameter};
use super::run::Run;
use super::terms::Terms;

#[cfg(test)]
mod tests;

/// An oscillator over one step of the integration.
struct Stepper<'a> {
    terms: Terms<'a>,
    first: Mode,
    second: Option<Mode>,
    gain: f64,
    force: f64,
    step: f64,
}

/// Displacements and velocities of both modes, and the yielding part of the spring.
#[derive(Clone, Copy)]
struct Moving {
    first: State,
    second: State,
    yielding: f64,
}

impl Moving {
    /// Signal an instrument sees.
    fn seen(&self) -> State {
        std::array::from_fn(|i| self.first[i] + self.second[i])
    }
}

impl Stepper<'_> {
    fn advance(&self, m: &Moving, input: &[f64; NODES]) -> Moving {
        let half = |mode: &Mode, s, gain, force| mode.moved(true, s, input, gain, force);
        let full = |mode: &Mode, s, gain, force| mode.moved(false, s, input, gain, force);
        let mut end = full(&self.first, m.first, self.gain, self.force);
        let mut yielding = 0.0;
        let lacking = [2, 3, 4].map(|k| self.terms.lacking(input[k]));
        if self.terms.some {
            let middle = half(&self.first, m.first, self.gain, self.force);
            (end, yielding) = self.bent(m, middle, end, lacking);
        }
        let second = self.second.as_ref().map_or([0.0; 2], |mode| {
            let size = self.terms.values[Parameter::ModeGain] * self.gain;
            let mut lacks = *input;
            if lacking.iter().any(|l| *l != 0.0) {
                lacks = input.map(|u| u + self.terms.lacking(u));
            }
            mode.moved(false, m.second, &lacks, size, 0.0)
        });
        Moving {
            first: end,
            second,
            yielding,
        }
    }

    /// The end of a step with the terms; `middle` and `end` are without them.
    fn bent(&self, m: &Moving, middle: State, end: State, lacking: [f64; 3]) -> (State, f64) {
        let (h, terms) = (self.step, &self.terms);
        // An acceleration turns a state by the second column of a transition.
        let turned = |phi: &[State; 2], k: f64| [phi[0][1] * k, phi[1][1] * k];
        let (half, full) = (&self.first.half, &self.first.full);
        let at = |s: State, lacking: f64| {
            let yielding = terms.yielded(m.yielding, s[0] - m.first[0]);
            terms.at(s, yielding, lacking)
        };
        let k1 = terms.at(m.first, m.yielding, lacking[0]);
        let by = turned(half, 0.5 * h * k1);
        let k2 = at([middle[0] + by[0], middle[1] + by[1]], lacking[1]);
        let k3 = at([middle[0], middle[1] + 0.5 * h * k2], lacking[1]);
        let by = turned(half, h * k3);
        let k4 = at([end[0] + by[0], end[1] + by[1]], lacking[2]);
        let (a, b) = (turned(full, k1), turned(half, 2.0 * (k2 + k3)));
        let end = [
            end[0] + h / 6.0 * (a[0] + b[0]),
            end[1] + h / 6.0 * (a[1] + b[1] + k4),
        ];
        (end, terms.yielded(m.yielding, end[0] - m.first[0]))
    }
}

/// Simulates the output over the record.
///
/// Returns `None` where the simulation diverges.
pub(super) fn simulate(values: &OscillatorParameters, run: &Run) -> Option<Vec<f64>> {
    followed(values, run).map(|(output, ..)| output)
}

/// States with a long memory that follow from the motion: what the high-pass holds back, and the second mode.
pub(super) const LINEAR_STATES: [Parameter; 3] = [
    Parameter::HeldBack,
    Parameter::ModeDisplacement,
    Parameter::ModeVelocity,
];

/// The values with [`LINEAR_STATES`] as they are at the first sample behind the record.
pub(super) fn states_behind(
    values: &OscillatorParameters,
    run: &Run,
) -> Option<OscillatorParameters> {
    let (_, moving, channel) = followed(values, run)?;
    let mut behind = *values;
    let [x2, v2] = moving.second;
    for (state, value) in LINEAR_STATES.into_iter().zip([channel.held_back(), x2, v2]) {
        behind[state] = value;
    }
    Some(behind)
}

/// The output over the record, and motion and channel behind it.
fn followed(values: &OscillatorParameters, run: &Run) -> Option<(Vec<f64>, Moving, Channel)> {
    let w0 = values[Parameter::LnResonance].exp();
    let step = w0 * run.interval_s / run.steps as f64;
    let second = || {
        let ratio = values[Parameter::ModeLnRatio].exp();
        Mode::new(ratio, values[Parameter::ModeDamping], step)
    };
    let mut stepper = Stepper {
        terms: Terms::new(values, step),
        first: Mode::new(1.0, values[Parameter::Delta], step),
        second: (values[Parameter::ModeGain] != 0.0).then(second),
        gain: values[Parameter::Gain],
        force: values[Parameter::SteadyForce],
        step,
    };
    let input = run.input_at(values[Parameter::Delay]);
    let state = |x: Parameter, v: Parameter| [values[x], values[v]];
    let mut moving = Moving {
        first: state(Parameter::Displacement, Parameter::Velocity),
        second: state(Parameter::ModeDisplacement, Parameter::ModeVelocity),
        yielding: 0.0,
    };
    let mut channel = Channel::new(values, run, moving.seen(), step);
    let count = run.input.len();
    let mut output = Vec::with_capacity(count);
    for n in 0..count {
        let seen = moving.seen()[0];
        output.push(channel.output(n, seen));
        if seen.is_nan() || seen.abs() >= run.largest {
            return None;
        }
        for part in 0..run.steps {
            let Some(nodes) = run.nodes(&input, n, part) else {
                break;
            };
            // The spring is as it is in the middle of the step.
            let middle = (part as f64 + 0.5) / run.steps as f64;
            stepper.terms.at_sample((run.before + n) as f64 + middle);
            let next = stepper.advance(&moving, &nodes);
            channel.follow(moving.seen(), next.seen());
            moving = next;
        }
    }
    Some((output, moving, channel))
}
