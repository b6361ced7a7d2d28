//! One step of a linear oscillator and of the filters behind it: exact, but for the interpolation
//! of what drives it.

/// Displacement and velocity.
pub(super) type State = [f64; 2];

/// Points of the input that one step uses: the step has the third to the fifth of them.
pub(super) const NODES: usize = 7;

/// A linear oscillator over one step and half of it.
pub(super) struct Mode {
    pub(super) full: [State; 2],
    pub(super) half: [State; 2],
    /// Response to one unit of input at each node, over a step and over half of it.
    driven: [[State; NODES]; 2],
    /// Response to a constant input, over a step and over half of it.
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
    pub(super) fn new(frequency: f64, damping: f64, step: f64) -> Self {
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
    pub(super) fn moved(
        &self,
        half: bool,
        s: State,
        input: &[f64; NODES],
        gain: f64,
        offset: f64,
    ) -> State {
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

/// Integrals over u from 0 to 1 of r e^(-r u) u^k, k from 0 to 3; `keeps` is e^-r.
fn moments(r: f64, keeps: f64) -> [f64; 4] {
    let mut moments = [1.0 - keeps; 4];
    if r > 1.0 {
        for k in 1..4 {
            moments[k] = k as f64 / r * moments[k - 1] - keeps;
        }
    } else {
        // There the recursion cancels.
        moments = std::array::from_fn(|k| {
            let at = |(u, weight): (f64, f64)| weight * r * (-r * u).exp() * u.powi(k as i32);
            GAUSS.into_iter().map(at).sum()
        });
    }
    moments
}

/// The state of a filter of first order follows the motion; over a step that is a cubic through both
/// ends.
pub(super) struct Follower {
    keeps: f64,
    /// Weights of displacement and velocity before, and of those after.
    weights: [f64; 4],
}

impl Follower {
    pub(super) fn new(rate: f64, step: f64) -> Self {
        let keeps = (-rate * step).exp();
        let [m0, m1, m2, m3] = moments(rate * step, keeps);
        // The cubics of Hermite in powers of the time that is left.
        let weights = [
            3.0 * m2 - 2.0 * m3,
            step * (m2 - m3),
            m0 - 3.0 * m2 + 2.0 * m3,
            -step * (m1 - 2.0 * m2 + m3),
        ];
        Self { keeps, weights }
    }

    pub(super) fn follow(&self, held: f64, before: State, after: State) -> f64 {
        let [a, b, c, d] = self.weights;
        self.keeps * held + a * before[0] + b * before[1] + c * after[0] + d * after[1]
    }
}
