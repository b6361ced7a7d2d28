//! The oscillator with its candidate terms, and its simulation.
//!
//! x'' + 2 delta w0 x' + w0^2 x + terms(x, x') = w0^2 gain u + offset, integrated
//! with the classical Runge-Kutta method; the input between two samples is that
//! of a band-limited signal (a zero-order hold costs half a sample of delay, a
//! cubic through the neighbours a part of the amplitude above a fifth of the rate).

/// Candidate terms, in the order of their coefficients.
pub(crate) const TERMS: [Term; 8] = [
    Term {
        name: "cubic_stiffness",
        formula: "k3 x^3",
        leading: true,
        unit: "1/(s2 unit2)",
    },
    Term {
        name: "quadratic_stiffness",
        formula: "k2 x^2",
        leading: true,
        unit: "1/(s2 unit)",
    },
    Term {
        name: "quadratic_damping",
        formula: "c2 x'|x'|",
        leading: false,
        unit: "1/unit",
    },
    Term {
        name: "cubic_damping",
        formula: "c3 x'^3",
        leading: false,
        unit: "s/unit2",
    },
    Term {
        name: "coulomb_friction",
        formula: "fc sign(x')",
        leading: false,
        unit: "unit/s2",
    },
    Term {
        name: "input_delay",
        formula: "u(t - tau)",
        leading: true,
        unit: "samples",
    },
    Term {
        name: "input_saturation",
        formula: "u - s u^3",
        leading: true,
        unit: "1/unit2",
    },
    Term {
        name: "output_highpass",
        formula: "x - wc integral of the output",
        leading: true,
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
    /// Whether it comes early in an expansion of the forces in powers.
    pub(crate) leading: bool,
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
    let between = PLACES.map(|place| shifted(input, place - terms[5]));
    for n in 0..input.len() {
        output.push(x - highpass * integral);
        if x.is_nan() || x.abs() >= 1e6 {
            return None;
        }
        integral += x * interval_s;
        for part in 0..STEPS {
            let (u0, u1) = (between[2 * part][n], between[2 * part + 1][n]);
            let next = (n + 1).min(input.len() - 1);
            let u2 = if part + 1 < STEPS {
                between[2 * part + 2][n]
            } else {
                between[0][next]
            };
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
