//! Oscillators against closed formulas.

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;

use super::integrate::simulate_in_steps;
use super::*;
use crate::effects::ActiveEffect;
use crate::effects::oscillator::{OscillatorAction, OscillatorEffect};

const RATE_HZ: f64 = 1000.0;

fn active(text: &str) -> ActiveEffect<OscillatorAction> {
    text.parse().expect("known")
}

fn oscillator(effects: &[&str]) -> Oscillator {
    let mut oscillator = Oscillator::linear(TAU * TAU * 400.0, 20.0, 0.05);
    for text in effects {
        active(text).apply_to(&mut oscillator);
    }
    oscillator
}

/// A single tone of `amplitude` at `frequency_hz`, 1 s of steady state: harmonics 0 to 3 over the
/// input's phasor.
fn tone(effects: &[&str], frequency_hz: f64, amplitude: f64) -> [Complex<f64>; 4] {
    let input = Multisine::new(frequency_hz, frequency_hz, amplitude / 2.0_f64.sqrt(), 1);
    let driven = input.values(0.0, 1.0 / RATE_HZ, 1000);
    let output = simulate(&oscillator(effects), &input, RATE_HZ, 1000, 5.0);
    let harmonic = |values: &[f64], order: f64| -> Complex<f64> {
        let angle = |index: usize| -TAU * frequency_hz * order * index as f64 / RATE_HZ;
        let turn = |(index, value): (usize, &f64)| Complex::from_polar(value / 500.0, angle(index));
        values.iter().enumerate().map(turn).sum()
    };
    let phase = harmonic(&driven, 1.0);
    let phase = phase / phase.norm();
    [0, 1, 2, 3].map(|order: u32| harmonic(&output, f64::from(order)) / phase.powu(order))
}

fn response(frequency_hz: f64) -> Complex<f64> {
    let q = frequency_hz / 20.0;
    1.0 / Complex::new(1.0 - q * q, 0.1 * q)
}

#[test]
fn a_linear_oscillator_has_its_response() {
    for frequency_hz in [5.0, 20.0, 50.0] {
        let got = tone(&[], frequency_hz, 0.7)[1] / 0.7;
        assert!(
            (got / response(frequency_hz) - 1.0).norm() < 1e-6,
            "{frequency_hz} {got}"
        );
    }
}

#[test]
fn linear_effects_have_their_response() {
    for frequency_hz in [5.0, 25.0, 50.0] {
        let s = Complex::new(0.0, TAU * frequency_hz);
        let q = frequency_hz / 60.0;
        let second = 0.2 * (20.0_f64 / 60.0).powi(2) / Complex::new(1.0 - q * q, 0.2 * q);
        for (text, expected) in [
            (
                "input_delay=tau_s:0.002",
                response(frequency_hz) * (-s * 0.002).exp(),
            ),
            (
                "output_highpass=corner_hz:2",
                response(frequency_hz) * s / (s + TAU * 2.0),
            ),
            (
                "output_lowpass=corner_hz:30",
                response(frequency_hz) / (1.0 + s / (TAU * 30.0)),
            ),
            // Its decay is the shortest time of all.
            (
                "output_lowpass=corner_hz:20000",
                response(frequency_hz) / (1.0 + s / (TAU * 20_000.0)),
            ),
            (
                "second_mode=gain:0.2,mode_hz:60,damping:0.1",
                response(frequency_hz) + second,
            ),
        ] {
            let got = tone(&[text], frequency_hz, 0.7)[1] / 0.7;
            assert!(
                (got / expected - 1.0).norm() < 2e-6,
                "{text} {frequency_hz} {got} {expected}"
            );
        }
    }
}

/// First order of each nonlinear term at a frequency far above resonance, where the motion is nearly
/// a cosine: the fundamental of the term over that of the linear force.
#[test]
fn nonlinear_effects_have_their_describing_function() {
    let (frequency_hz, amplitude) = (25.0, 1.0);
    let plain = tone(&[], frequency_hz, amplitude)[1];
    let x = plain.norm();
    let q: f64 = frequency_hz / 20.0;
    let drag = Complex::new(0.0, 0.1 * q);
    let small = 1e-3;
    // Term over w0^2 x, as a complex stiffness added to 1 - q^2 + j q/Q.
    for (text, added) in [
        (
            format!("cubic_stiffness=k3:{}", small / (x * x)),
            Complex::new(0.75 * small, 0.0),
        ),
        (
            format!("quadratic_damping=d2:{}", small / x),
            drag * small * q * 8.0 / (3.0 * PI),
        ),
        (
            format!("cubic_damping=d3:{}", small / (x * x)),
            drag * small * q * q * 0.75,
        ),
        (
            format!("coulomb_friction=deflection:{}", small * x),
            Complex::new(0.0, small * 4.0 / PI),
        ),
        (
            format!("dead_zone=half_width:{}", small * x),
            Complex::new(-small * 4.0 / PI, 0.0),
        ),
    ] {
        let got = tone(&[&text], frequency_hz, amplitude)[1];
        let expected = 1.0 / (1.0 / response(frequency_hz) + added) - response(frequency_hz);
        let effect = got - plain;
        // Second order is 1e-3 times the amplification of 2 near resonance, and friction and play
        // are resolved to a percent of themselves.
        assert!(
            (effect / expected - 1.0).norm() < 1.5e-2,
            "{text}: {effect} {expected}"
        );
    }
}

#[test]
fn even_stiffness_makes_a_mean_and_a_second_harmonic() {
    let x = tone(&[], 8.0, 0.3)[1].norm();
    let bent = tone(&["quadratic_stiffness=k2:0.01"], 8.0, 0.3);
    // -k2 x^2/2 against the static stiffness; harmonic 0 of the sum is twice the mean.
    assert!(
        (bent[0].re / (-0.01 * x * x) - 1.0).abs() < 5e-3,
        "{}",
        bent[0]
    );
    let second = 0.005 * x * x * response(16.0).norm();
    assert!((bent[2].norm() / second - 1.0).abs() < 5e-3);
}

#[test]
fn a_saturated_input_loses_its_fundamental() {
    let clipped = tone(&["input_saturation=threshold:0.9"], 8.0, 1.0);
    let b = 0.9_f64.acos();
    let gain = 1.0 - (2.0 * b - (2.0 * b).sin()) / PI;
    // The corners fall within a step: 1e-4.
    assert!((clipped[1].norm() / response(8.0).norm() / gain - 1.0).abs() < 2e-4);
}

#[test]
fn a_clipped_output_is_the_linear_one_up_to_the_rails() {
    let largest = response(8.0).norm();
    let clipped = tone(
        &[&format!("output_clipping=threshold:{}", 0.9 * largest)],
        8.0,
        1.0,
    );
    let b = 0.9_f64.acos();
    let gain = 1.0 - (2.0 * b - (2.0 * b).sin()) / PI;
    // The corners fall between samples, 125 of which make a period: (pi/125)^2 of what is cut off.
    assert!((clipped[1].norm() / largest / gain - 1.0).abs() < 6e-4);
    // As in the Fourier series of a clipped sine: the third harmonic of what is left.
    let third = ((2.0 * b).sin() / 2.0 - (4.0 * b).sin() / 4.0) * 2.0 / (3.0 * PI);
    assert!(
        (clipped[3].norm() / largest / third - 1.0).abs() < 2e-3,
        "{} {third}",
        clipped[3]
    );
}

#[test]
fn a_trend_starts_at_the_first_sample_and_is_evenly_steep() {
    let input = Multisine::new(8.0, 8.0, 0.7, 1);
    let of = |effects: &[&str]| simulate(&oscillator(effects), &input, RATE_HZ, 1000, 5.0);
    let (plain, drifting) = (of(&[]), of(&["output_trend=drift_per_s:0.25"]));
    for at in [0, 1, 500, 999] {
        let drift = drifting[at] - plain[at];
        assert!((drift - 0.25e-3 * at as f64).abs() < 1e-12, "{at} {drift}");
    }
}

/// A tone far below the resonance moves by 1 + q^2 of the static deflection, which falls as the spring
/// stiffens: at 1 Hz and 20 Hz a term of q^2 = 1/400 follows it to a few per cent of the change.
#[test]
fn a_spring_that_stiffens_moves_less_and_less() {
    let input = Multisine::new(1.0, 1.0, 0.7, 1);
    let of = |effects: &[&str]| simulate(&oscillator(effects), &input, RATE_HZ, 4001, 5.0);
    let (plain, drifting) = (of(&[]), of(&["resonance_drift=drift_per_s:0.02"]));
    let largest = |record: &[f64], second: usize| {
        let period = &record[1000 * second..1000 * (second + 1)];
        period.iter().fold(0.0_f64, |m, x| m.max(x.abs()))
    };
    // The deflection is largest once in each half of a period, at most half a second from its end.
    for second in [0, 3] {
        let ratio = largest(&drifting, second) / largest(&plain, second);
        let [early, late] = [0.0, 1.0].map(|s: f64| (1.0 + 0.02 * (second as f64 + s)).powi(-2));
        assert!(
            ratio < early * 1.001 && ratio > late * 0.999,
            "{second}: {ratio}"
        );
    }
}

#[test]
fn a_steady_force_moves_the_rest_and_with_it_the_stiffness() {
    // rho over w0^2 is 1: the force is the deflection it would hold.
    let moved = tone(&["input_offset=offset:0.3"], 8.0, 0.5);
    assert!((moved[0].re / 2.0 - 0.3).abs() < 1e-6, "{}", moved[0]);
    assert!((moved[1] / 0.5 / response(8.0) - 1.0).norm() < 1e-6);
    // At rest x + k3 x^3 = 0.327; about it the spring is 1 + 3 k3 x^2 = 1.27 as stiff.
    let effects = ["cubic_stiffness=k3:1", "input_offset=offset:0.327"];
    let sagged = tone(&effects, 8.0, 1e-4);
    assert!((sagged[0].re / 2.0 - 0.3).abs() < 1e-6, "{}", sagged[0]);
    let q: f64 = 0.4;
    let expected = 1.0 / Complex::new(1.27 - q * q, 0.1 * q);
    assert!((sagged[1] / 1e-4 / expected - 1.0).norm() < 1e-4);
}

#[test]
fn hysteresis_stiffens_and_damps() {
    // Far below yield the state follows the deflection: stiffness 1 + alpha. Far above it turns to
    // friction of alpha zy.
    let elastic = tone(&["hysteresis=alpha:0.2,yield_deflection:1000"], 5.0, 0.1)[1] / 0.1;
    let q: f64 = 0.25;
    let expected = 1.0 / Complex::new(1.2 - q * q, 0.1 * q);
    assert!((elastic / expected - 1.0).norm() < 1e-3, "{elastic}");
    let plastic = tone(&["hysteresis=alpha:0.2,yield_deflection:0.02"], 5.0, 1.0)[1];
    let rubbed = tone(&["coulomb_friction=deflection:0.004"], 5.0, 1.0)[1];
    let plain = tone(&[], 5.0, 1.0)[1];
    // The work of a cycle is that of friction but for the corners of the loop, some two yield
    // deflections of a stroke of two: 4 %. (The corners also stiffen, which friction does not.)
    let loss = |motion: Complex<f64>| (1.0 / motion - 1.0 / plain).im;
    assert!(
        (loss(plastic) / loss(rubbed) - 1.0).abs() < 0.06,
        "{plastic} {rubbed}"
    );
}

#[test]
fn halving_the_step_changes_nothing() {
    let input = Multisine::new(1.0, 60.0, 0.05, 3);
    for effect in OscillatorEffect::all() {
        let mut bent = oscillator(&[]);
        effect.usual().apply_to(&mut bent);
        assert_ne!(bent, oscillator(&[]), "{}", effect.entry.id);
        let run = |phase| simulate_in_steps(&bent, &input, RATE_HZ, 500, 1.0, phase);
        let (coarse, fine) = (run(0.015), run(0.0075));
        let size = fine.iter().map(|value| value * value).sum::<f64>();
        let error: f64 = coarse.iter().zip(&fine).map(|(a, b)| (a - b).powi(2)).sum();
        assert!(
            (error / size).sqrt() < 3e-4,
            "{} {:e}",
            effect.entry.id,
            (error / size).sqrt()
        );
    }
}
