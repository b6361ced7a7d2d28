//! Shock identification and prediction on synthetic and measured records.

use calib_metrology::discrete::{Discrete, Mapping};
use calib_metrology::input::Source;
use calib_metrology::monte_carlo::Lanes;
use calib_metrology::oscillator::Oscillator;
use calib_metrology::predict::{self, Model, Request};
use calib_metrology::record::{self, TimeRecord};
use calib_metrology::shock::{self, Choice};
use std::f64::consts::{PI, TAU};
use std::path::Path;

const TRUTH: Oscillator = Oscillator {
    s0: 0.2275,
    f0_hz: 30_000.0,
    delta: 0.05,
};
const RATE_HZ: f64 = 1.0e6;

/// A half-sine of 40 us in 4 ms.
fn half_sine() -> Vec<f64> {
    (0..4000)
        .map(|n| match n {
            500..540 => 100.0 * (PI * f64::from(n - 500) / 40.0).sin(),
            _ => 0.0,
        })
        .collect()
}

/// Output by Runge-Kutta of order 4 with 20 steps per sample: the continuous
/// model itself, independent of any mapping.
fn integrate(oscillator: &Oscillator, input: &[f64]) -> Vec<f64> {
    let (w, d, rho) = (TAU * oscillator.f0_hz, oscillator.delta, oscillator.rho());
    let h = 1.0 / RATE_HZ / 20.0;
    let rate = |x: f64, v: f64, a: f64| (v, rho * a - 2.0 * d * w * v - w * w * x);
    let (mut x, mut v) = (0.0, 0.0);
    let mut output = vec![0.0];
    for pair in input.windows(2) {
        for step in 0..20 {
            let a = |s: f64| pair[0] + (pair[1] - pair[0]) * (f64::from(step) + s) / 20.0;
            let k1 = rate(x, v, a(0.0));
            let k2 = rate(x + h / 2.0 * k1.0, v + h / 2.0 * k1.1, a(0.5));
            let k3 = rate(x + h / 2.0 * k2.0, v + h / 2.0 * k2.1, a(0.5));
            let k4 = rate(x + h * k3.0, v + h * k3.1, a(1.0));
            x += h / 6.0 * (k1.0 + 2.0 * k2.0 + 2.0 * k3.0 + k4.0);
            v += h / 6.0 * (k1.1 + 2.0 * k2.1 + 2.0 * k3.1 + k4.1);
        }
        output.push(x);
    }
    output
}

fn synthetic() -> TimeRecord {
    let input = half_sine();
    TimeRecord {
        sample_rate_hz: RATE_HZ,
        start_s: 0.0,
        output: Some(integrate(&TRUTH, &input)),
        input: Some(input),
    }
}

#[test]
fn a_synthetic_shock_returns_the_truth() {
    let result = shock::identify(&synthetic(), &Choice::default()).expect("oscillator");
    let got = result.oscillator;
    // At 33 samples per period the mapping warps by (w T)^2 / 12 = 3e-3 at the
    // resonance, and the fit ends below it.
    assert!((got.s0 / TRUTH.s0 - 1.0).abs() < 1e-3, "{got:?}");
    assert!((got.f0_hz / TRUTH.f0_hz - 1.0).abs() < 5e-3, "{got:?}");
    assert!((got.delta / TRUTH.delta - 1.0).abs() < 2e-2, "{got:?}");
    assert_eq!(result.consistent, None);
    // A peak ratio is no sensitivity.
    assert!(result.peak_ratio / TRUTH.s0 > 1.02);
    let report = shock::report(&result);
    assert!(report.contains("1000000 S/s"), "{report}");
    assert!(
        report.lines().all(|line| line.chars().count() <= 80),
        "{report}"
    );
}

#[test]
fn discrete_truth_is_found_exactly_with_either_mapping() {
    for (mapping, prewarp) in [
        (Mapping::Bilinear, false),
        (Mapping::BilinearPrewarped, true),
    ] {
        let input = half_sine();
        let discrete = Discrete::new(&TRUTH, RATE_HZ, mapping);
        let record = TimeRecord {
            output: Some(discrete.respond(&input)),
            input: Some(input),
            ..synthetic()
        };
        let choice = Choice {
            prewarp,
            ..Choice::default()
        };
        let result = shock::identify(&record, &choice).expect("oscillator");
        // The response decays by exp(-delta w0 * 3.5 ms) = 5e-15 in the record.
        assert!(
            (result.oscillator.f0_hz / TRUTH.f0_hz - 1.0).abs() < 1e-8,
            "{mapping:?}"
        );
        assert!((result.oscillator.s0 / TRUTH.s0 - 1.0).abs() < 1e-9);
        assert!((result.oscillator.delta / TRUTH.delta - 1.0).abs() < 1e-7);
        assert!((result.discrete.b / discrete.b - 1.0).abs() < 1e-7);
        assert!((result.discrete.c2 - discrete.c2).abs() < 1e-9);
    }
}

#[test]
fn a_known_delay_is_compensated() {
    let mut record = synthetic();
    let (plain, delay) = (
        shock::identify(&record, &Choice::default()).expect("fit"),
        7,
    );
    // The input channel lags by seven samples.
    record.input = record
        .input
        .map(|input| [vec![0.0; delay], input[..4000 - delay].to_vec()].concat());
    let choice = Choice {
        input_delay_s: delay as f64 / RATE_HZ,
        ..Choice::default()
    };
    let fit = shock::identify(&record, &choice).expect("fit");
    assert!((fit.oscillator.delta / plain.oscillator.delta - 1.0).abs() < 1e-6);
    assert!((fit.oscillator.f0_hz / plain.oscillator.f0_hz - 1.0).abs() < 1e-9);
}

#[test]
fn the_erratum_of_formula_34_is_right() {
    // S0 = 4 / (v1 + v2 + v3) with v = (1, c1, c2) / b; printed is 2/sqrt(...).
    let d = Discrete::new(&TRUTH, RATE_HZ, Mapping::Bilinear);
    let sum = (1.0 + d.c1 + d.c2) / d.b;
    assert!((4.0 / sum / TRUTH.s0 - 1.0).abs() < 1e-9);
}

#[test]
fn the_ptb_shock_agrees_with_the_sine_fit() {
    let Some(path) = crate::shared::path("data/ptb_accelerometer_shock/record.csv") else {
        return;
    };
    let record = record::read(Source::read(&path).expect("file")).expect("record");
    assert!((record.sample_rate_hz / 1.0e7 - 1.0).abs() < 1e-6);
    let result = shock::identify(&record, &Choice::default()).expect("oscillator");
    // Published peak ratio; S0 of the sine fit within the spread of the bins.
    assert!(
        (result.peak_ratio - 0.237_67).abs() < 1e-3,
        "{}",
        result.peak_ratio
    );
    assert!(
        (result.oscillator.s0 / 0.2277 - 1.0).abs() < 0.01,
        "{}",
        result.oscillator.s0
    );
    assert!((result.oscillator.f0_hz - 51_317.0).abs() < 4.0 * result.u_f0_hz);
    // The channels are not synchronous: the phase leads, delta is negative, and
    // the report says what to do. 0.8 us brings delta to that of the sine fit.
    assert!(result.oscillator.delta < 0.0 && result.simulation_rms_rel.is_none());
    assert!(result.warnings.iter().any(|w| w.contains("synchronous")));
    let choice = Choice {
        input_delay_s: 0.8e-6,
        ..Choice::default()
    };
    let aligned = shock::identify(&record, &choice).expect("oscillator");
    let delta = aligned.oscillator.delta;
    assert!((delta - 0.083).abs() < 4.0 * aligned.u_delta, "{delta}");
    // Better than any single sensitivity: peak ratio and S0 are 4.5 % apart.
    assert!(
        aligned.simulation_rms_rel.is_some_and(|rms| rms < 0.045),
        "{aligned:?}"
    );
}

fn request(u_sample: f64) -> Request {
    Request {
        sample_rate_hz: RATE_HZ,
        mapping: Mapping::BilinearPrewarped,
        u_sample,
        cutoff_hz: 60_000.0,
    }
}

/// A pulse without corners: 100 sin^2 over 80 us.
fn smooth_pulse() -> Vec<f64> {
    (0..4000)
        .map(|n| match n {
            500..580 => 100.0 * (PI * f64::from(n - 500) / 80.0).sin().powi(2),
            _ => 0.0,
        })
        .collect()
}

/// Largest error of the estimate, and the largest error it expects of itself.
fn found_again(input: &[f64]) -> (f64, f64, f64) {
    let model = Model::new(TRUTH, [1e-4, 30.0, 1e-3]).expect("model");
    let output = integrate(&TRUTH, input);
    let estimate = predict::estimate_input(&model, &output, &request(1e-3)).expect("estimate");
    let expected = estimate.regularisation_error.as_ref().expect("inverse");
    let largest =
        |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, |m, e| m.max(e.abs()));
    (
        largest(
            &mut estimate
                .values
                .iter()
                .zip(input)
                .map(|(found, wanted)| found - wanted),
        ),
        largest(&mut expected.iter().copied()),
        estimate.values[3000],
    )
}

#[test]
fn the_input_is_found_again() {
    let (error, expected, later) = found_again(&smooth_pulse());
    // Without corners the expectation holds; the mapping adds its warping,
    // (w T)^2 / 12 = 0.05 % at the pulse's 12.5 kHz.
    assert!(error <= 1.5 * expected + 0.2, "{error} {expected}");
    assert!(expected < 1.0, "{expected}");
    // Stable: quiet long after the shock.
    assert!(later.abs() < 0.01, "{later}");
    // A corner of slope 7.85 per sample is rounded by half the slope times the
    // kernel's width, 1 / (2 pi 60 kHz) = 2.7 samples: 10.4 at most.
    let (error, ..) = found_again(&half_sine());
    assert!(error < 10.4, "{error}");
    let wrong = Request {
        cutoff_hz: 6e5,
        ..request(0.0)
    };
    let model = Model::new(TRUTH, [0.0; 3]).expect("model");
    assert!(predict::estimate_input(&model, &half_sine(), &wrong).is_err());
}

#[test]
fn predicted_uncertainty_is_that_of_monte_carlo() {
    let input = half_sine();
    let u = [2e-4, 60.0, 1e-3];
    let model = Model::new(TRUTH, u).expect("model");
    let estimate = predict::predict_output(&model, &input, &request(0.5));
    let (trials, mut lanes) = (2000, Lanes::new(3, 0));
    let (mut sum, mut squares) = (vec![0.0; input.len()], vec![0.0; input.len()]);
    let mut normal = vec![0.0; 3 + input.len()];
    for _ in 0..trials {
        lanes.fill_normal(&mut normal);
        let drawn = Oscillator {
            s0: TRUTH.s0 + u[0] * normal[0],
            f0_hz: TRUTH.f0_hz + u[1] * normal[1],
            delta: TRUTH.delta + u[2] * normal[2],
        };
        let noisy: Vec<f64> = input
            .iter()
            .zip(&normal[3..])
            .map(|(a, n)| a + 0.5 * n)
            .collect();
        let output = Discrete::new(&drawn, RATE_HZ, Mapping::BilinearPrewarped).respond(&noisy);
        for (k, x) in output.iter().enumerate() {
            sum[k] += x;
            squares[k] += x * x;
        }
    }
    // Relative standard error of a deviation from 2000 trials: 1.6 %; four.
    for k in [505, 515, 520, 530, 545, 560, 600, 1500] {
        let mean = sum[k] / f64::from(trials);
        let deviation = (squares[k] / f64::from(trials) - mean * mean).sqrt();
        let ratio = estimate.u_values[k] / deviation;
        assert!((ratio - 1.0).abs() < 0.065, "sample {k}: {ratio}");
    }
}

#[test]
fn faulty_records_name_the_line() {
    let read =
        |text: &str| record::read(Source::from_text(Path::new("r.csv"), text).expect("text"));
    let mut rows = String::from("time_s,input,output\n");
    for n in 0..10 {
        rows += &format!("{},0,0\n", f64::from(n) * 1e-3);
    }
    assert!(read(&rows).is_ok());
    let message = read(&rows.replace("0.005,", "0.0057,"))
        .expect_err("uneven")
        .to_string();
    assert!(message.starts_with("r.csv:7: time step"), "{message}");
    let message = read("time_s,input\n0,1\n1,2\n")
        .expect_err("short")
        .to_string();
    assert!(message.contains("too few"), "{message}");
    let message = read("time_s,z\n0,1\n1,2\n")
        .expect_err("no signal")
        .to_string();
    assert!(message.contains("no column"), "{message}");
}
