//! The channel of the output: what it makes of the motion.

use super::mode::{Follower, State};
use super::parameters::{OscillatorParameters, Parameter};
use super::run::Run;

/// Largest output that the channel lets through.
fn rail(values: &OscillatorParameters) -> f64 {
    match values[Parameter::Clipping] {
        0.0 => f64::INFINITY,
        clipping => 1.0 / clipping,
    }
}

/// Slope of the output at a sample with a value that acts behind the motion; `None` for the others.
/// On the rails nothing moves it; within rounding an output there is there.
pub(super) fn slope(
    values: &OscillatorParameters,
    parameter: Parameter,
    at: usize,
    run: &Run,
    output: f64,
) -> Option<f64> {
    let free = |slope: f64| {
        Some(if output.abs() < (1.0 - 1e-12) * rail(values) {
            slope
        } else {
            0.0
        })
    };
    match parameter {
        Parameter::Offset => free(1.0),
        Parameter::Trend => free((run.before + at) as f64),
        Parameter::Lagging => free((-(at as f64) / values[Parameter::Lag]).exp()),
        _ => None,
    }
}

/// A high-pass, a low-pass behind it, a zero that drifts, and the rails of what comes last.
pub(super) struct Channel {
    high: Option<Follower>,
    low: Option<Follower>,
    /// Rate of the high-pass, in units of w0.
    rate: f64,
    /// Level that the high-pass holds back, from rest on.
    held_back: f64,
    /// Output of the low-pass.
    passed: f64,
    /// Output at rest, at the first sample of the file.
    zero: f64,
    /// Growth of it in a sample, and samples of it before the first one.
    trend: f64,
    before: usize,
    /// Largest output.
    rail: f64,
}

impl Channel {
    /// The channel at the first sample, where the motion is `start`; `step` in units of 1/w0.
    pub(super) fn new(values: &OscillatorParameters, run: &Run, start: State, step: f64) -> Self {
        let w0 = values[Parameter::LnResonance].exp();
        let rate = values[Parameter::HighpassCorner] / w0;
        let held_back = values[Parameter::HeldBack];
        let lag = values[Parameter::Lag] * w0 * run.interval_s;
        let mut channel = Self {
            high: (rate > 0.0 || held_back != 0.0).then(|| Follower::new(rate, step)),
            low: (lag > 0.0).then(|| Follower::new(1.0 / lag, step)),
            rate,
            held_back,
            passed: 0.0,
            zero: values[Parameter::Offset],
            trend: values[Parameter::Trend],
            before: run.before,
            rail: rail(values),
        };
        let [x, v] = channel.above(start, held_back);
        channel.passed = x - lag * v + values[Parameter::Lagging];
        channel
    }

    /// The motion behind the high-pass.
    fn above(&self, [x, v]: State, held_back: f64) -> State {
        [x - held_back, v - self.rate * (x - held_back)]
    }

    /// A step of the motion.
    pub(super) fn follow(&mut self, before: State, after: State) {
        let mut held_back = self.held_back;
        if let Some(high) = &self.high {
            held_back = high.follow(held_back, before, after);
        }
        if let Some(low) = &self.low {
            let ends = [
                self.above(before, self.held_back),
                self.above(after, held_back),
            ];
            self.passed = low.follow(self.passed, ends[0], ends[1]);
        }
        self.held_back = held_back;
    }

    /// Level that the high-pass holds back, from rest on.
    pub(super) fn held_back(&self) -> f64 {
        self.held_back
    }

    /// The output of a sample while the motion is at `x`.
    pub(super) fn output(&self, at: usize, x: f64) -> f64 {
        let filtered = match self.low {
            Some(_) => self.passed,
            None => x - self.held_back,
        };
        let shifted = filtered + self.zero + self.trend * (self.before + at) as f64;
        shifted.clamp(-self.rail, self.rail)
    }
}
