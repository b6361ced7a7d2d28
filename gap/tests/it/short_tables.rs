//! Tables of a dozen to some dozens of rows, as a person takes them at a filter or a sensor: instruments that round,
//! uncertainties that are guessed, often no phase.

use super::sealed::random::Random;
use calib_gap::{Answer, Group, Options, Verdict, diagnose};
use num_complex::Complex64;
use std::f64::consts::PI;
use std::fmt::Write;

type Response = Box<dyn Fn(f64) -> Complex64>;

/// Uncertainties stated of each row.
const U_RATIO: f64 = 0.01;
const U_PHASE_DEG: f64 = 1.0;

/// Answer to a sweep in equal steps of the logarithm, with the noise that is stated.
fn answer(response: &Response, hz: [f64; 2], rows: usize, phase: bool, seed: u64) -> Answer {
    let sweep = (0..rows).map(|at| hz[0] * (hz[1] / hz[0]).powf(at as f64 / (rows - 1) as f64));
    answer_at(response, &sweep.collect::<Vec<f64>>(), phase, 1.0, seed)
}

/// The answer at any frequencies, with noise of `factor` times the stated uncertainty.
fn answer_at(response: &Response, hz: &[f64], phase: bool, factor: f64, seed: u64) -> Answer {
    let mut random = Random::new(seed);
    let mut table = String::from("frequency_hz,ratio,u_ratio");
    table += if phase {
        ",dut_deg,u_phase_deg\n"
    } else {
        "\n"
    };
    for hz in hz {
        let value = response(*hz);
        let ratio = value.norm() * (1.0 + factor * U_RATIO * random.normal());
        let _ = write!(table, "{hz:.4},{ratio:.3e},{U_RATIO}");
        if phase {
            let deg = value.arg().to_degrees() + factor * U_PHASE_DEG * random.normal();
            let _ = write!(table, ",{deg:.1},{U_PHASE_DEG}");
        }
        table.push('\n');
    }
    let folder = tempfile::tempdir().expect("a folder");
    let rig = "kind = \"calibrator\"\nmeasurand = \"dut_sensitivity\"\n";
    std::fs::write(folder.path().join("rig.toml"), rig).expect("written");
    std::fs::write(folder.path().join("points.csv"), table).expect("written");
    diagnose(folder.path(), &Options::default()).expect("a good dataset")
}

fn leading(answer: &Answer) -> &[&'static str] {
    answer.causes.first().map_or(&[], |cause| &cause.effects)
}

/// 1 + j f/fc.
fn corner(corner_hz: f64) -> impl Fn(f64) -> Complex64 {
    move |hz| Complex64::new(1.0, hz / corner_hz)
}

/// An echo: a comb, of which a coarse sweep shows swings that look like noise of fifty times the stated.
fn echo(delay_s: f64, share: f64) -> Response {
    Box::new(move |hz| 1.0 + share * Complex64::from_polar(1.0, -2.0 * PI * hz * delay_s))
}

/// A twin T, which the library lacks.
fn notch(notch_hz: f64) -> Response {
    Box::new(move |hz| {
        let q = hz / notch_hz;
        let through = Complex64::new(1.0 - q * q, 0.05 * q);
        through / Complex64::new(1.0 - q * q, 4.0 * q)
    })
}

/// Before, the comb and the notch were `data`: "nothing is wrong with the rig", the noise 30 to 60 times the stated.
#[test]
fn what_the_library_lacks_is_not_taken_for_noise() {
    for (seed, rows, phase) in [
        (1, 12, false),
        (2, 15, true),
        (3, 15, true),
        (4, 20, false),
        (5, 30, true),
    ] {
        for response in [echo(1.1e-3, 0.4), echo(2.3e-4, 0.3), notch(375.0)] {
            let answer = answer(&response, [40.0, 4e3], rows, phase, seed);
            let claims = matches!(
                answer.verdict,
                Verdict::Data | Verdict::NoGap | Verdict::Explained
            );
            assert!(!claims, "seed {seed}: {}", answer.summary);
            assert!(
                answer.noise.factor_on_u.values().all(|f| *f < 10.0),
                "seed {seed}: {}",
                answer.summary
            );
        }
    }
}

/// Swings are noise where each point was taken three times and came out anew.
#[test]
fn repetitions_show_a_noise_of_any_size() {
    let once: Vec<f64> = (0..20).map(|at| 20.0 * 1.3_f64.powi(at)).collect();
    let flat: Response = Box::new(|_| Complex64::new(2.0, 0.0));
    let answer = answer_at(&flat, &once.repeat(3), false, 15.0, 6);
    assert_eq!(answer.verdict, Verdict::Data, "{}", answer.summary);
    let factor = answer.noise.factor_on_u[&Group::Ratio];
    // 60 data: 2/sqrt(2 nu) of the factor are 18 %.
    assert!((factor / 15.0 - 1.0).abs() < 0.18, "{factor}");
}

/// Two equal RC stages, the second loading the first, have a quality of 1/3: below the bounds before, and described
/// by a steep filter and a resonance of the reference instead.
#[test]
fn loaded_stages_are_one_filter_of_second_order() {
    for (seed, rows, phase) in [(1, 18, true), (2, 19, true), (3, 20, false), (4, 30, true)] {
        let response: Response = Box::new(|hz| {
            let q = hz / 700.0;
            1.0 / Complex64::new(1.0 - q * q, 3.0 * q)
        });
        let answer = answer(&response, [35.0, 7e3], rows, phase, seed);
        assert_eq!(
            leading(&answer),
            ["dut_lowpass_2"],
            "seed {seed}: {}",
            answer.summary
        );
        let quality = answer.causes[0].parameters["dut_lowpass_2"]["quality"].value;
        assert!((quality * 3.0 - 1.0).abs() < 0.1, "seed {seed}: {quality}");
    }
}

/// Between a filter (quality up to 1 before) and a resonance (from 1.5 on) lay a hole.
#[test]
fn a_servo_accelerometer_has_a_filter_of_quality_1_2() {
    let response: Response = Box::new(|hz| {
        let q = hz / 300.0;
        1.0 / Complex64::new(1.0 - q * q, q / 1.2)
    });
    for seed in [1, 2, 3] {
        let answer = answer(&response, [3.0, 400.0], 30, true, seed);
        assert_eq!(
            leading(&answer),
            ["dut_lowpass_2"],
            "seed {seed}: {}",
            answer.summary
        );
        assert_eq!(
            answer.verdict,
            Verdict::Explained,
            "seed {seed}: {}",
            answer.summary
        );
    }
}

/// Of eight rows five are searched for one effect only; before, the gap was that of this one, 5 % closed.
#[test]
fn a_short_table_is_scored_with_what_it_names() {
    let (high, low) = (corner(40.0), corner(5e3));
    let response: Response =
        Box::new(move |hz| Complex64::new(0.0, hz / 40.0) / high(hz) / low(hz));
    for seed in [1, 2, 3] {
        let answer = answer(&response, [9.0, 27e3], 8, true, seed);
        let mut names = leading(&answer).to_vec();
        names.sort_unstable();
        assert_eq!(
            names,
            ["dut_highpass", "dut_lowpass_1"],
            "seed {seed}: {}",
            answer.summary
        );
        assert!(
            answer.gap.size.closed.is_some_and(|c| c > 0.95),
            "seed {seed}: {}",
            answer.summary
        );
    }
}
