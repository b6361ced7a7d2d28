//! The simulation of an oscillator over a record.
//!
//! x'' + 2 delta x' + x = gain u + offset - terms(x, x'), in time of 1/w0. The
//! linear part and its input are propagated exactly, but for the interpolation
//! of the input by polynomials of degree six; the terms are integrated with the
//! classical Runge-Kutta method in the frame of that motion (Lawson 1967).

use super::model::{
    DEAD_ZONE, DELAY, HELD_BACK, HIGHPASS, HYSTERESIS, LINEAR, SATURATION, SECOND_MODE,
    SECOND_STATE, VALUES,
};
use super::run::Run;

/// Displacement and velocity.
type State = [f64; 2];

/// Points of the input that one step uses: the step has the third to the fifth of them.
const NODES: usize = 7;

/// A linear oscillator over one step and half of it.
struct Mode {
    full: [State; 2],
    half: [State; 2],
    /// What one unit of input at each node adds in a step, and in half of it.
    driven: [[State; NODES]; 2],
    /// The same for a constant.
    steady: [State; 2],
}

/// Places and weights of Gauss and Legendre on 0..1, six points.
const GAUSS: [(f64, f64); 6] = [
    (0.033_765_242_898_423_97, 0.085_662_246_189_585_18),
    (0.169_395_306_766_867_76, 0.180_380_786_524_069_3),
    (0.380_690_406_958_401_56, 0.233_956_967_286_345_52),
    (0.619_309_593_041_598_5, 0.233_956_967_286_345_52),
    (0.830_604_693_233_132_2, 0.180_380_786_524_069_3),
    (0.966_234_757_101_576, 0.085_662_246_189_585_18),
];

impl Mode {
    fn new(frequency: f64, damping: f64, step: f64) -> Self {
        let phi = |t: f64| transition(frequency, damping, t);
        let of = |length: f64| -> [State; NODES] {
            let mut driven = [[0.0; 2]; NODES];
            for (place, weight) in GAUSS {
                let s = place * length;
                let response = phi(length - s);
                for (i, sum) in driven.iter_mut().enumerate() {
                    let share = weight * length * basis(i, 2.0 * s / step);
                    sum[0] += share * response[0][1];
                    sum[1] += share * response[1][1];
                }
            }
            driven
        };
        let driven = [of(step), of(0.5 * step)];
        let total = |d: &[State; NODES]| d.iter().fold([0.0; 2], |m, d| [m[0] + d[0], m[1] + d[1]]);
        Self {
            full: phi(step),
            half: phi(0.5 * step),
            steady: [total(&driven[0]), total(&driven[1])],
            driven,
        }
    }

    /// The state after a whole or half step without the terms.
    fn moved(&self, half: bool, s: State, input: &[f64; NODES], gain: f64, offset: f64) -> State {
        let (phi, at) = if half {
            (&self.half, 1)
        } else {
            (&self.full, 0)
        };
        let mut by = [0.0; 2];
        for (u, d) in input.iter().zip(&self.driven[at]) {
            by[0] += u * d[0];
            by[1] += u * d[1];
        }
        let steady = self.steady[at];
        std::array::from_fn(|i| {
            phi[i][0] * s[0] + phi[i][1] * s[1] + gain * by[i] + offset * steady[i]
        })
    }
}

/// Polynomial of degree six that is one at a node and zero at the others; nodes at -2..4.
fn basis(node: usize, at: f64) -> f64 {
    let others = (0..NODES).filter(|k| *k != node);
    let factor = |k: usize| (at + 2.0 - k as f64) / (node as f64 - k as f64);
    others.map(factor).product()
}

/// Displacement and velocity after a time from those before:
/// x'' + 2 damping frequency x' + frequency^2 x = 0.
fn transition(frequency: f64, damping: f64, t: f64) -> [State; 2] {
    let alpha = damping * frequency;
    let q = frequency * frequency * (1.0 - damping * damping);
    let angle = q.abs().sqrt() * t;
    let (c, s) = if angle < 1e-5 {
        (1.0 - 0.5 * q * t * t, t * (1.0 - q * t * t / 6.0))
    } else if q > 0.0 {
        (angle.cos(), t * angle.sin() / angle)
    } else {
        (angle.cosh(), t * angle.sinh() / angle)
    };
    let e = (-alpha * t).exp();
    [
        [e * (c + alpha * s), e * s],
        [-e * frequency * frequency * s, e * (c - alpha * s)],
    ]
}

/// The terms of an oscillator, as an acceleration in units of w0^2.
struct Terms<'a> {
    values: &'a [f64; VALUES],
    yields_at: f64,
    /// Slope of dry friction about rest: as steep as the steps can follow.
    steepness: f64,
    /// Whether there are any.
    some: bool,
}

impl<'a> Terms<'a> {
    fn new(values: &'a [f64; VALUES], step: f64) -> Self {
        let own = &values[LINEAR..];
        let some = own[..5].iter().any(|v| *v != 0.0)
            || [SATURATION, DEAD_ZONE, HYSTERESIS]
                .iter()
                .any(|at| values[*at] != 0.0);
        Self {
            values,
            yields_at: values[HYSTERESIS + 1].exp(),
            steepness: 1.0 / (own[4] * step).max(1e-9),
            some,
        }
    }

    /// What a saturated input lacks.
    fn lacking(&self, input: f64) -> f64 {
        let saturation = self.values[SATURATION];
        if saturation > 0.0 {
            input.clamp(-1.0 / saturation, 1.0 / saturation) - input
        } else {
            0.0
        }
    }

    fn at(&self, [x, v]: State, yielding: f64, lacking: f64) -> f64 {
        let terms = &self.values[LINEAR..];
        let mut sum = -x * x * (terms[1] + terms[0] * x) - v * v.abs() * terms[2];
        sum += self.values[2] * lacking - terms[3] * v * v * v;
        if terms[4] != 0.0 {
            sum -= terms[4] * (v * self.steepness).clamp(-1.0, 1.0);
        }
        let play = self.values[DEAD_ZONE];
        if play > 0.0 {
            sum += x.clamp(-play, play);
        }
        sum - self.values[HYSTERESIS] * yielding
    }

    /// The yielding part of the spring after a way.
    fn yielded(&self, before: f64, way: f64) -> f64 {
        if self.values[HYSTERESIS] == 0.0 {
            0.0
        } else {
            yielded(before, way, self.yields_at)
        }
    }
}

/// The yielding part of a spring after a way, if the motion does not turn back on it:
/// z' = x' - (|x'| z + x' |z|)/(2 zy) is straight until z has the sign of x', then exponential.
fn yielded(z: f64, way: f64, yields_at: f64) -> f64 {
    let sign = if way < 0.0 { -1.0 } else { 1.0 };
    let (mut z, mut way) = (sign * z, way.abs());
    if z < 0.0 {
        let straight = way.min(-z);
        (z, way) = (z + straight, way - straight);
    }
    sign * (yields_at - (yields_at - z) * (-way / yields_at).exp())
}

/// What a high-pass holds back follows the motion; over a step that is a cubic through both ends.
struct Follower {
    keeps: f64,
    /// Weights of displacement and velocity before, and of those after.
    weights: [f64; 4],
}

impl Follower {
    fn new(rate: f64, step: f64) -> Self {
        let mut weights = [0.0; 4];
        for (t, weight) in GAUSS {
            let share = weight * step * rate * (-rate * step * (1.0 - t)).exp();
            let cubic = [
                (1.0 + 2.0 * t) * (1.0 - t).powi(2),
                step * t * (1.0 - t).powi(2),
                t * t * (3.0 - 2.0 * t),
                step * t * t * (t - 1.0),
            ];
            for (sum, value) in weights.iter_mut().zip(cubic) {
                *sum += share * value;
            }
        }
        Self {
            keeps: (-rate * step).exp(),
            weights,
        }
    }

    fn follow(&self, held: f64, before: State, after: State) -> f64 {
        let [a, b, c, d] = self.weights;
        self.keeps * held + a * before[0] + b * before[1] + c * after[0] + d * after[1]
    }
}

/// An oscillator over one step of the integration.
struct Stepper<'a> {
    terms: Terms<'a>,
    first: Mode,
    second: Option<Mode>,
    gain: f64,
    offset: f64,
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
    /// What an instrument sees.
    fn seen(&self) -> State {
        std::array::from_fn(|i| self.first[i] + self.second[i])
    }
}

impl Stepper<'_> {
    fn advance(&self, m: &Moving, input: &[f64; NODES]) -> Moving {
        let half = |mode: &Mode, s, gain, offset| mode.moved(true, s, input, gain, offset);
        let full = |mode: &Mode, s, gain, offset| mode.moved(false, s, input, gain, offset);
        let mut end = full(&self.first, m.first, self.gain, self.offset);
        let mut yielding = 0.0;
        let lacking = [2, 3, 4].map(|k| self.terms.lacking(input[k]));
        if self.terms.some {
            let middle = half(&self.first, m.first, self.gain, self.offset);
            (end, yielding) = self.bent(m, middle, end, lacking);
        }
        let second = self.second.as_ref().map_or([0.0; 2], |mode| {
            let size = self.terms.values[SECOND_MODE] * self.gain;
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
pub(super) fn simulate(values: &[f64; VALUES], run: &Run) -> Option<Vec<f64>> {
    let step = values[0].exp() * run.interval_s / run.steps as f64;
    let mode = |at: usize| Mode::new(values[at + 1].exp(), values[at + 2], step);
    let stepper = Stepper {
        terms: Terms::new(values, step),
        first: Mode::new(1.0, values[1], step),
        second: (values[SECOND_MODE] != 0.0).then(|| mode(SECOND_MODE)),
        gain: values[2],
        offset: values[3],
        step,
    };
    let rate = values[HIGHPASS] / values[0].exp();
    let follower = (rate > 0.0 || values[HELD_BACK] != 0.0).then(|| Follower::new(rate, step));
    let input = run.driven(values[DELAY]);
    let mut moving = Moving {
        first: [values[4], values[5]],
        second: [values[SECOND_STATE], values[SECOND_STATE + 1]],
        yielding: 0.0,
    };
    let mut held_back = values[HELD_BACK];
    let count = run.input.len();
    let mut output = Vec::with_capacity(count);
    for n in 0..count {
        let seen = moving.seen()[0];
        output.push(seen - held_back);
        if seen.is_nan() || seen.abs() >= 1e6 {
            return None;
        }
        for part in 0..run.steps {
            // The grid begins a sample before the record, a step has two of its places.
            let at = 2 * (run.steps * (n + 1) + part) - 2;
            let Some(nodes) = input.get(at..).and_then(|i| i.first_chunk::<NODES>()) else {
                break;
            };
            let next = stepper.advance(&moving, nodes);
            if let Some(follower) = &follower {
                held_back = follower.follow(held_back, moving.seen(), next.seen());
            }
            moving = next;
        }
    }
    Some(output)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::Record;
    use std::f64::consts::TAU;

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

    const INTERVAL_S: f64 = 1.0 / 600.0;
    const RESONANCE_HZ: f64 = 68.0;

    /// Sines up to a quarter of the rate, and their sum at a time.
    fn force(t: f64) -> f64 {
        let line = |k: usize| (TAU * (7.0 + 11.0 * k as f64) * t + (k * k) as f64).cos();
        (0..14).map(line).sum::<f64>() / 14.0
    }

    fn run(steps: usize) -> Run {
        let input: Vec<f64> = (0..900).map(|n| force(n as f64 * INTERVAL_S)).collect();
        let output = vec![0.0; input.len()];
        let record = Record {
            interval_s: INTERVAL_S,
            input,
            output,
        };
        Run::new(&record, steps)
    }

    fn oscillator() -> [f64; VALUES] {
        let mut values = [0.0; VALUES];
        values[0] = (TAU * RESONANCE_HZ).ln();
        values[1] = 0.02;
        values[2] = 1.0;
        values
    }

    /// Largest difference, over the largest value, away from the ends, where the input beyond the
    /// record is not known.
    fn distance(a: &[f64], b: &[f64]) -> f64 {
        let largest = b.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let pairs = a.iter().zip(b).take(870).skip(600);
        pairs.fold(0.0_f64, |m, (x, y)| m.max((x - y).abs())) / largest
    }

    /// The steady motion under each sine is known in closed form; of the free motion e^(-4.3) of
    /// the start is left, so it starts in the steady motion. The interpolation errs by 1e-5.
    #[test]
    fn a_linear_oscillator_moves_as_its_response_says() {
        let response = |t: f64, order: i32| -> f64 {
            let line = |k: usize| {
                let q = (7.0 + 11.0 * k as f64) / RESONANCE_HZ;
                let at = TAU * (7.0 + 11.0 * k as f64) * t + (k * k) as f64;
                let h = num_complex::Complex64::new(1.0 - q * q, 0.04 * q).inv();
                let turn = num_complex::Complex64::new(0.0, q).powi(order);
                (h * turn * num_complex::Complex64::from_polar(1.0, at)).re
            };
            (0..14).map(line).sum::<f64>() / 14.0
        };
        let mut values = oscillator();
        (values[4], values[5]) = (response(0.0, 0), response(0.0, 1));
        let found = simulate(&values, &run(2)).expect("it does not diverge");
        let expected: Vec<f64> = (0..900)
            .map(|n| response(n as f64 * INTERVAL_S, 0))
            .collect();
        let error = distance(&found, &expected);
        assert!(error < 1e-5, "{error:e}");
    }

    /// Each kind of term against the midpoint rule in 400 steps per sample, which errs by
    /// (w0 h)^2/24 per radian, 1e-7, over the fifty radians of memory: 7e-6. Two steps of the
    /// classical method alone err by 1e-3 here, an input held between the samples by more.
    #[test]
    fn every_smooth_term_is_integrated() {
        let terms: [(&str, &[(usize, f64)]); 5] = [
            ("cubic", &[(LINEAR, 0.02)]),
            ("quadratic", &[(LINEAR + 1, 0.05)]),
            ("quadratic damping", &[(LINEAR + 2, 0.02)]),
            ("cubic damping", &[(LINEAR + 3, 0.02)]),
            ("high-pass", &[(HIGHPASS, 20.0)]),
        ];
        for (name, changes) in terms {
            let mut values = oscillator();
            changes.iter().for_each(|(at, v)| values[*at] = *v);
            let found = simulate(&values, &run(4)).expect("it does not diverge");
            let expected = midpoint(&values);
            let error = distance(&found, &expected);
            assert!(error < 2e-5, "{name}: {error:e}");
        }
    }

    /// A kink lies anywhere in a step: the error falls about with the step, and 16 steps leave
    /// 2e-4 of the largest motion (seen: 1.8e-4 and 1.4e-4).
    #[test]
    fn terms_with_a_kink_are_integrated_the_better_the_finer() {
        let terms = [
            ("friction", LINEAR + 4, 0.003),
            ("dead zone", DEAD_ZONE, 0.03),
        ];
        for (name, at, value) in terms {
            let mut values = oscillator();
            values[at] = value;
            let expected = midpoint(&values);
            let error = |steps: usize| {
                let found = simulate(&values, &run(steps)).expect("it does not diverge");
                distance(&found, &expected)
            };
            let (coarse, fine) = (error(2), error(16));
            assert!(fine < 3e-4, "{name}: {fine:e}");
            assert!(fine < 0.25 * coarse, "{name}: {coarse:e} {fine:e}");
        }
    }

    fn midpoint(values: &[f64; VALUES]) -> Vec<f64> {
        const STEPS: usize = 400;
        let w0 = values[0].exp();
        let terms = &values[LINEAR..];
        let rate = |s: [f64; 3], t: f64| {
            let [x, v, low] = s;
            let loss = v * (0.04 + terms[2] * v.abs() + terms[3] * v * v);
            let play = values[DEAD_ZONE];
            let spring = x - x.clamp(-play, play) + terms[1] * x * x + terms[0] * x * x * x;
            let loss = loss + terms[4] * (v * 1e5).clamp(-1.0, 1.0);
            [
                w0 * v,
                w0 * (force(t) - spring - loss),
                values[HIGHPASS] * (x - low),
            ]
        };
        let h = INTERVAL_S / STEPS as f64;
        let mut s = [0.0; 3];
        let mut output = Vec::new();
        for n in 0..900 {
            output.push(s[0] - s[2]);
            for step in 0..STEPS {
                let t = n as f64 * INTERVAL_S + step as f64 * h;
                let k = rate(s, t);
                let half = std::array::from_fn(|i| s[i] + 0.5 * h * k[i]);
                let k = rate(half, t + 0.5 * h);
                s = std::array::from_fn(|i| s[i] + h * k[i]);
            }
        }
        output
    }
}
