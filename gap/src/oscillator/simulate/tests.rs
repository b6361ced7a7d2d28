//! Simulated motions against their equations.

use super::*;
use crate::dataset::Record;
use std::f64::consts::TAU;

const INTERVAL_S: f64 = 1.0 / 600.0;
const RESONANCE_HZ: f64 = 68.0;

/// Sines up to a quarter of the rate, and their sum at a time.
fn force(t: f64) -> f64 {
    let line = |k: usize| (TAU * (7.0 + 11.0 * k as f64) * t + (k * k) as f64).cos();
    (0..14).map(line).sum::<f64>() / 14.0
}

fn run(steps: usize) -> Run {
    let input: Vec<f64> = (0..900).map(|n| force(n as f64 * INTERVAL_S)).collect();
    // Of the size of the motion: what is far beyond it diverges.
    let output = vec![1.0; input.len()];
    let record = Record {
        interval_s: INTERVAL_S,
        before: 0,
        input,
        output,
    };
    Run::new(&record, steps)
}

fn oscillator() -> OscillatorParameters {
    let mut values = OscillatorParameters::default();
    values[Parameter::LnResonance] = (TAU * RESONANCE_HZ).ln();
    values[Parameter::Delta] = 0.02;
    values[Parameter::Gain] = 1.0;
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
    values[Parameter::Displacement] = response(0.0, 0);
    values[Parameter::Velocity] = response(0.0, 1);
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
    let terms = [
        (Parameter::CubicStiffness, 0.02),
        (Parameter::QuadraticStiffness, 0.05),
        (Parameter::QuadraticDamping, 0.02),
        (Parameter::CubicDamping, 0.02),
        (Parameter::ResonanceDrift, 2e-5),
        (Parameter::HighpassCorner, 20.0),
        (Parameter::Lag, 0.05),
        (Parameter::Lag, 20.0),
    ];
    for (term, value) in terms {
        let mut values = oscillator();
        values[term] = value;
        let found = simulate(&values, &run(4)).expect("it does not diverge");
        let expected = midpoint(&values);
        let error = distance(&found, &expected);
        assert!(error < 2e-5, "{term:?}: {error:e}");
    }
}

/// A kink lies anywhere in a step: the error falls about with the step, and 16 steps leave
/// 2e-4 of the largest motion (seen: 1.8e-4 and 1.4e-4).
#[test]
fn terms_with_a_kink_are_integrated_the_better_the_finer() {
    let terms = [
        (Parameter::CoulombFriction, 0.003),
        (Parameter::DeadZone, 0.03),
    ];
    for (term, value) in terms {
        let mut values = oscillator();
        values[term] = value;
        let expected = midpoint(&values);
        let error = |steps: usize| {
            let found = simulate(&values, &run(steps)).expect("it does not diverge");
            distance(&found, &expected)
        };
        let (coarse, fine) = (error(2), error(16));
        assert!(fine < 3e-4, "{term:?}: {fine:e}");
        assert!(fine < 0.25 * coarse, "{term:?}: {coarse:e} {fine:e}");
    }
}

fn midpoint(values: &OscillatorParameters) -> Vec<f64> {
    const STEPS: usize = 400;
    let w0 = values[Parameter::LnResonance].exp();
    let of = |parameter: Parameter| values[parameter];
    let lag_s = of(Parameter::Lag) * INTERVAL_S;
    let rate = |s: [f64; 4], t: f64| {
        let [x, v, low, late] = s;
        let loss = v
            * (0.04
                + of(Parameter::QuadraticDamping) * v.abs()
                + of(Parameter::CubicDamping) * v * v);
        let play = of(Parameter::DeadZone);
        let spring = x - x.clamp(-play, play)
            + ((1.0 + of(Parameter::ResonanceDrift) * t / INTERVAL_S).powi(2) - 1.0) * x
            + of(Parameter::QuadraticStiffness) * x * x
            + of(Parameter::CubicStiffness) * x * x * x;
        let loss = loss + of(Parameter::CoulombFriction) * (v * 1e5).clamp(-1.0, 1.0);
        [
            w0 * v,
            w0 * (force(t) - spring - loss),
            of(Parameter::HighpassCorner) * (x - low),
            (x - low - late) / lag_s,
        ]
    };
    let h = INTERVAL_S / STEPS as f64;
    let mut s = [0.0; 4];
    let mut output = Vec::new();
    for n in 0..900 {
        output.push(if lag_s > 0.0 { s[3] } else { s[0] - s[2] });
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
