//! The oscillator with its candidate terms, and its simulation.
//!
//! x'' + 2 delta w0 x' + w0^2 x + terms(x, x') = w0^2 gain u + offset, integrated
//! with the classical Runge-Kutta method; the input between two samples is a
//! cubic through its neighbours (a zero-order hold costs half a sample of delay).

/// Candidate terms, in the order of their coefficients.
pub(crate) const TERMS: [Term; 8] = [
    Term {
        name: "cubic_stiffness",
        formula: "k3 x^3",
        unit: "1/(s2 unit2)",
    },
    Term {
        name: "quadratic_stiffness",
        formula: "k2 x^2",
        unit: "1/(s2 unit)",
    },
    Term {
        name: "quadratic_damping",
        formula: "c2 x'|x'|",
        unit: "1/unit",
    },
    Term {
        name: "cubic_damping",
        formula: "c3 x'^3",
        unit: "s/unit2",
    },
    Term {
        name: "coulomb_friction",
        formula: "fc sign(x')",
        unit: "unit/s2",
    },
    Term {
        name: "input_delay",
        formula: "u(t - tau)",
        unit: "samples",
    },
    Term {
        name: "input_saturation",
        formula: "u - s u^3",
        unit: "1/unit2",
    },
    Term {
        name: "output_highpass",
        formula: "x - wc integral of the output",
        unit: "1/s",
    },
];

/// A term a diagnosis may add.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Term {
    /// Name in the library.
    pub(crate) name: &'static str,
    /// What it adds.
    pub(crate) formula: &'static str,
    /// Unit of the coefficient, in the units of the record.
    pub(crate) unit: &'static str,
}

/// Values every simulation has: ln w0, delta, gain, offset, and the state at the first sample.
pub(crate) const LINEAR: usize = 6;
/// All values of a simulation.
pub(crate) const VALUES: usize = LINEAR + TERMS.len();

/// Steps of the integration per sample.
const STEPS: usize = 2;

/// Simulates the output over the record.
///
/// Returns `None` where the simulation diverges.
pub(crate) fn simulate(values: &[f64; VALUES], interval_s: f64, input: &[f64]) -> Option<Vec<f64>> {
    let terms = &values[LINEAR..];
    let (w0, delta, gain, offset) = (values[0].exp(), values[1], values[2], values[3]);
    let (saturation, highpass) = (terms[6], terms[7]);
    // Time in units of 1/w0 keeps displacement and velocity of one size.
    let step = w0 * interval_s / STEPS as f64;
    let (mut x, mut v, mut integral) = (values[4], values[5], 0.0);
    let mut output = Vec::with_capacity(input.len());
    let force = |x: f64, v: f64, u: f64| {
        let drive = gain * (u - saturation * u * u * u) + offset;
        let restoring = x * (1.0 + x * (terms[1] + terms[0] * x));
        let loss =
            v * (2.0 * delta + terms[2] * v.abs() + terms[3] * v * v) + terms[4] * (v * 1e3).tanh();
        drive - restoring - loss
    };
    let delay = terms[5];
    for n in 0..input.len() {
        output.push(x - highpass * integral);
        if x.is_nan() || x.abs() >= 1e6 {
            return None;
        }
        integral += x * interval_s;
        for part in 0..STEPS {
            let at = |c: f64| between(input, n as f64 + (part as f64 + c) / STEPS as f64 - delay);
            let (u0, u1, u2) = (at(0.0), at(0.5), at(1.0));
            let (k1x, k1v) = (v, force(x, v, u0));
            let (k2x, k2v) = (
                v + 0.5 * step * k1v,
                force(x + 0.5 * step * k1x, v + 0.5 * step * k1v, u1),
            );
            let (k3x, k3v) = (
                v + 0.5 * step * k2v,
                force(x + 0.5 * step * k2x, v + 0.5 * step * k2v, u1),
            );
            let (k4x, k4v) = (v + step * k3v, force(x + step * k3x, v + step * k3v, u2));
            x += step / 6.0 * (k1x + 2.0 * k2x + 2.0 * k3x + k4x);
            v += step / 6.0 * (k1v + 2.0 * k2v + 2.0 * k3v + k4v);
        }
    }
    Some(output)
}

/// Input between samples: the cubic of Catmull and Rom.
fn between(input: &[f64], at: f64) -> f64 {
    let last = input.len() as isize - 1;
    let base = at.floor();
    let t = at - base;
    let n = base as isize;
    let get = |k: isize| input[(n + k).clamp(0, last) as usize];
    let (a, b, c, d) = (get(-1), get(0), get(1), get(2));
    b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)))
}
