//! The oscillator with its candidate terms, and its simulation.
//!
//! x'' + 2 delta w0 x' + w0^2 x + terms(x, x') = w0^2 gain u + offset, integrated
//! with the classical Runge-Kutta method; the input between two samples is that
//! of a band-limited signal (a zero-order hold costs half a sample of delay, a
//! cubic through the neighbours a part of the amplitude above a fifth of the rate).

use crate::effects::Stage;

const COEFFICIENT: &[&str] = &["coefficient"];

/// Candidate terms; the values of each follow those of the one before.
pub(crate) const TERMS: [Term; 11] = [
    Term {
        name: "cubic_stiffness",
        leading: true,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        separate_by: "the same record at half and at twice the amplitude",
    },
    Term {
        name: "quadratic_stiffness",
        leading: true,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        separate_by: "the same input with its sign turned, and one with a steady offset",
    },
    Term {
        name: "quadratic_damping",
        leading: false,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        separate_by: "a sine at the resonance at several amplitudes: the loss per cycle over amplitude",
    },
    Term {
        name: "cubic_damping",
        leading: false,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        separate_by: "a sine at the resonance at several amplitudes: the loss per cycle over amplitude",
    },
    Term {
        name: "coulomb_friction",
        leading: false,
        has_kink: true,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        separate_by: "a decay from the resonance down to rest, and the smallest amplitudes",
    },
    Term {
        name: "input_delay",
        leading: true,
        has_kink: false,
        stage: Stage::Amplifier,
        parameters: COEFFICIENT,
        separate_by: "frequencies far above the resonance",
    },
    Term {
        name: "input_saturation",
        leading: true,
        has_kink: true,
        stage: Stage::Amplifier,
        parameters: &["threshold"],
        separate_by: "an input of half the peak value, and the input as it arrives",
    },
    Term {
        name: "output_highpass",
        leading: true,
        has_kink: false,
        stage: Stage::Conditioning,
        parameters: &["corner_hz"],
        separate_by: "frequencies far below the resonance",
    },
    Term {
        name: "second_mode",
        leading: true,
        has_kink: false,
        stage: Stage::Dut,
        parameters: &["gain", "mode_hz", "damping"],
        separate_by: "a small-amplitude sweep around the second frequency",
    },
    Term {
        name: "dead_zone",
        leading: false,
        has_kink: true,
        stage: Stage::Dut,
        parameters: &["half_width"],
        separate_by: "the smallest amplitudes, below and above the play",
    },
    Term {
        name: "hysteresis",
        leading: false,
        has_kink: true,
        stage: Stage::Dut,
        parameters: &["alpha", "yield_deflection"],
        separate_by: "slow loading and unloading: the path of the restoring force",
    },
];

/// A term a diagnosis may add.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Term {
    /// Name in the library.
    pub(crate) name: &'static str,
    /// Whether it comes early in an expansion of the forces in powers.
    pub(crate) leading: bool,
    /// Whether its force has a kink, which the integration meets between two steps.
    pub(crate) has_kink: bool,
    /// Where it sits.
    pub(crate) stage: Stage,
    /// The record that tells it from the others.
    pub(crate) separate_by: &'static str,
    /// Names of its values.
    pub(crate) parameters: &'static [&'static str],
}

/// Values every simulation has: ln w0, delta, gain, offset, and the state at the first sample.
pub(crate) const LINEAR: usize = 6;
/// All values of a simulation.
pub(crate) const VALUES: usize = LINEAR + 17;
/// Coefficients of damping and friction.
pub(crate) const LOSSES: std::ops::Range<usize> = LINEAR + 2..LINEAR + 5;
/// One over the input at which it saturates.
pub(crate) const SATURATION: usize = LINEAR + 6;
/// Corner of the output's high-pass, in rad/s.
pub(crate) const HIGHPASS: usize = LINEAR + 7;
/// First value of the second mode: gain, ln of its frequency over w0, damping.
pub(crate) const SECOND_MODE: usize = LINEAR + 8;
/// Half width of the play.
pub(crate) const DEAD_ZONE: usize = LINEAR + 11;
/// First value of the hysteresis: alpha, ln of the yield deflection.
pub(crate) const HYSTERESIS: usize = LINEAR + 12;

/// What the high-pass holds back at the first sample: the first state that only some terms have.
pub(crate) const HELD_BACK: usize = LINEAR + 14;
/// Displacement and velocity of the second mode at the first sample.
const SECOND_STATE: usize = HELD_BACK + 1;

/// Places of the state at the first sample with the given terms.
pub(crate) fn states(terms: &[usize]) -> Vec<usize> {
    let mut states = vec![4, 5];
    for term in terms {
        match places(*term).start {
            HIGHPASS => states.push(HELD_BACK),
            SECOND_MODE => states.extend([SECOND_STATE, SECOND_STATE + 1]),
            _ => {}
        }
    }
    states
}

/// Places of the values of a term.
pub(crate) fn places(term: usize) -> std::ops::Range<usize> {
    let first = TERMS[..term]
        .iter()
        .map(|t| t.parameters.len())
        .sum::<usize>();
    LINEAR + first..LINEAR + first + TERMS[term].parameters.len()
}

/// Displacements and velocities of both modes, and the yielding part of the spring.
#[derive(Clone, Copy, Default)]
struct State {
    x: f64,
    v: f64,
    x2: f64,
    v2: f64,
    z: f64,
}

/// Forces in units of w0^2, with time in units of 1/w0.
struct Forces<'a> {
    values: &'a [f64; VALUES],
    second: f64,
    yields_at: f64,
}

impl<'a> Forces<'a> {
    fn new(values: &'a [f64; VALUES]) -> Self {
        Self {
            values,
            second: values[SECOND_MODE + 1].exp(),
            yields_at: values[HYSTERESIS + 1].exp(),
        }
    }

    /// Accelerations of both modes.
    fn at(&self, s: &State, input: f64) -> (f64, f64) {
        let terms = &self.values[LINEAR..];
        let (delta, gain, offset) = (self.values[1], self.values[2], self.values[3]);
        let (x, v) = (s.x, s.v);
        let saturation = self.values[SATURATION];
        let input = if saturation > 0.0 {
            input.clamp(-1.0 / saturation, 1.0 / saturation)
        } else {
            input
        };
        let drive = gain * input;
        let mut restoring = x * (1.0 + x * (terms[1] + terms[0] * x));
        let play = self.values[DEAD_ZONE];
        if play > 0.0 {
            restoring -= x.clamp(-play, play);
        }
        restoring += self.values[HYSTERESIS] * s.z;
        let loss =
            v * (2.0 * delta + terms[2] * v.abs() + terms[3] * v * v) + terms[4] * (v * 1e3).tanh();
        let second = self.values[SECOND_MODE];
        let other = if second == 0.0 {
            0.0
        } else {
            let damping = self.values[SECOND_MODE + 2];
            second * drive - self.second * (2.0 * damping * s.v2 + self.second * s.x2)
        };
        (drive + offset - restoring - loss, other)
    }

    /// A state moved along a slope. The spring yields with the way, whatever the time:
    /// z' = x' - (|x'| z + x' |z|)/(2 zy) is straight until z has the sign of x', then exponential.
    fn along(&self, s: &State, slope: &Slope, step: f64) -> State {
        let x = s.x + step * slope.x;
        State {
            x,
            v: s.v + step * slope.v,
            x2: s.x2 + step * slope.x2,
            v2: s.v2 + step * slope.v2,
            z: if self.values[HYSTERESIS] == 0.0 {
                0.0
            } else {
                yielded(s.z, x - s.x, self.yields_at)
            },
        }
    }

    fn slope(&self, s: &State, input: f64) -> Slope {
        let (v, v2) = self.at(s, input);
        Slope {
            x: s.v,
            v,
            x2: s.v2,
            v2,
        }
    }

    /// One step of the classical Runge-Kutta method.
    fn advance(&self, s: &State, [u0, u1, u2]: [f64; 3], step: f64) -> State {
        let a = self.slope(s, u0);
        let b = self.slope(&self.along(s, &a, 0.5 * step), u1);
        let c = self.slope(&self.along(s, &b, 0.5 * step), u1);
        let d = self.slope(&self.along(s, &c, step), u2);
        let mean = |a: f64, b: f64, c: f64, d: f64| (a + 2.0 * b + 2.0 * c + d) / 6.0;
        let slope = Slope {
            x: mean(a.x, b.x, c.x, d.x),
            v: mean(a.v, b.v, c.v, d.v),
            x2: mean(a.x2, b.x2, c.x2, d.x2),
            v2: mean(a.v2, b.v2, c.v2, d.v2),
        };
        self.along(s, &slope, step)
    }
}

/// Rates of a state, but for the yielding part.
struct Slope {
    x: f64,
    v: f64,
    x2: f64,
    v2: f64,
}

/// The yielding part of a spring after a way, if the motion does not turn back on it.
fn yielded(z: f64, way: f64, yields_at: f64) -> f64 {
    let sign = if way < 0.0 { -1.0 } else { 1.0 };
    let (mut z, mut way) = (sign * z, way.abs());
    if z < 0.0 {
        let straight = way.min(-z);
        (z, way) = (z + straight, way - straight);
    }
    sign * (yields_at - (yields_at - z) * (-way / yields_at).exp())
}

/// Steps of the integration per sample.
const STEPS: usize = 2;

/// Simulates the output over the record.
///
/// Returns `None` where the simulation diverges.
pub(crate) fn simulate(values: &[f64; VALUES], interval_s: f64, input: &[f64]) -> Option<Vec<f64>> {
    let w0 = values[0].exp();
    let delay = values[LINEAR + 5];
    // The low-pass whose difference to the output is the high-pass follows a mean exactly.
    let follows = 1.0 - (-values[HIGHPASS] * interval_s).exp();
    // Time in units of 1/w0 keeps displacement and velocity of one size.
    let step = w0 * interval_s / STEPS as f64;
    let forces = Forces::new(values);
    let mut state = State {
        x: values[4],
        v: values[5],
        x2: values[SECOND_STATE],
        v2: values[SECOND_STATE + 1],
        z: 0.0,
    };
    let mut held_back = values[HELD_BACK];
    let mut output = Vec::with_capacity(input.len());
    let between = PLACES.map(|place| shifted(input, place - delay));
    for n in 0..input.len() {
        let seen = state.x + state.x2;
        output.push(seen - held_back);
        if seen.is_nan() || seen.abs() >= 1e6 {
            return None;
        }
        let next = (n + 1).min(input.len() - 1);
        for part in 0..STEPS {
            let last = if part + 1 < STEPS {
                between[2 * part + 2][n]
            } else {
                between[0][next]
            };
            let inputs = [between[2 * part][n], between[2 * part + 1][n], last];
            state = forces.advance(&state, inputs, step);
        }
        let mean = 0.5 * (seen + state.x + state.x2);
        held_back += follows * (mean - held_back);
    }
    Some(output)
}

/// Places between two samples where the integration needs the input.
const PLACES: [f64; 2 * STEPS] = [0.0, 0.25, 0.5, 0.75];
/// Samples on each side that take part in the interpolation.
const REACH: isize = 16;

/// The input moved earlier by a part of a sample: a sine over its angle, under a raised cosine.
fn shifted(input: &[f64], by: f64) -> Vec<f64> {
    use std::f64::consts::PI;
    let (whole, part) = (by.floor(), by - by.floor());
    if part == 0.0 && whole == 0.0 {
        return input.to_vec();
    }
    let weights: Vec<f64> = (1 - REACH..=REACH)
        .map(|k| {
            let distance = part - k as f64;
            let sinc = if distance == 0.0 {
                1.0
            } else {
                (PI * distance).sin() / (PI * distance)
            };
            sinc * (0.5 * PI * distance / (REACH as f64 + 0.5)).cos().powi(2)
        })
        .collect();
    let sum: f64 = weights.iter().sum();
    let last = input.len() as isize - 1;
    (0..=last)
        .map(|n| {
            let first = n + whole as isize + 1 - REACH;
            let at = |k: usize| input[(first + k as isize).clamp(0, last) as usize];
            weights
                .iter()
                .enumerate()
                .map(|(k, w)| w * at(k))
                .sum::<f64>()
                / sum
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Euler steps of a hundred-thousandth of the way: their error is of that order.
    #[test]
    fn a_spring_yields_as_its_equation_says() {
        let yields_at = 0.3;
        for (start, way) in [(0.0, 0.5), (-0.2, 0.9), (0.1, -0.7), (0.29, -0.1)] {
            let (mut z, steps) = (start, 100_000);
            let dx: f64 = way / f64::from(steps);
            for _ in 0..steps {
                z += dx - (dx.abs() * z + dx * z.abs()) / (2.0 * yields_at);
            }
            let found = yielded(start, way, yields_at);
            assert!((found - z).abs() < 1e-5, "{start} {way}: {found} {z}");
        }
    }

    /// At a third of the rate the transition band of the window is still
    /// 0.17 of the rate away; sidelobes of a raised cosine of 33 samples are below 1e-3 there.
    #[test]
    fn a_sine_is_moved_by_part_of_a_sample() {
        let sine = |n: f64| (std::f64::consts::TAU * 0.33 * n).sin();
        let input: Vec<f64> = (0..200).map(|n| sine(f64::from(n))).collect();
        for by in [0.25, 0.5, -0.7, 1.5] {
            let moved = shifted(&input, by);
            for (n, value) in moved.iter().enumerate().take(150).skip(50) {
                assert!((value - sine(n as f64 + by)).abs() < 1e-3, "{by} {n}");
            }
        }
    }
}
