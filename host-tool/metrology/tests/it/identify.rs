//! Identification from sinusoidal data against independent fits and known truth.

use calib_metrology::identify::{self, Identification, Points, Weighting};
use calib_metrology::input::Source;
use calib_metrology::monte_carlo::Lanes;
use calib_metrology::oscillator::Oscillator;
use std::fmt::Write;
use std::path::Path;

fn read(text: &str) -> calib_files::Result<Points> {
    identify::read(Source::from_text(Path::new("p.csv"), text)?)
}

fn fit(points: &Points, weighting: Weighting) -> Identification {
    identify::identify(points, weighting, 0.05).expect("a resonance")
}

/// The synthetic transducer of PyDynamic's own tests.
const TRUTH: Oscillator = Oscillator {
    s0: 0.124,
    f0_hz: 36.0,
    delta: 0.01,
};

/// Points of a transducer with errors of the stated standard uncertainties.
fn table(oscillator: &Oscillator, errors: Option<&mut Lanes>) -> String {
    let mut text = String::from("Frequency [Hz],|S|,phase (rad),u_S_percent,u_phase (deg)\n");
    let mut normal = [0.0; 60];
    if let Some(lanes) = errors {
        lanes.fill_normal(&mut normal);
    }
    for n in 0..30 {
        let frequency_hz = 1.0 + f64::from(n);
        let h = oscillator.response(frequency_hz);
        let index = n as usize;
        let magnitude = h.norm() * (1.0 + 0.002 * normal[index]);
        let phase = h.arg() + 0.1_f64.to_radians() * normal[30 + index];
        writeln!(text, "{frequency_hz},{magnitude:.12},{phase:.12},0.2,0.1").expect("text");
    }
    text
}

#[test]
fn the_ptb_accelerometer_is_identified_and_rejected() {
    let Some(path) = crate::shared::path("data/ptb_accelerometer_sine/points.csv") else {
        return;
    };
    let points = identify::read(Source::read(&path).expect("file")).expect("points");
    // Independent fits of the same points: seeds' ERRATA, to its digits.
    let plain = fit(&points, Weighting::None);
    assert!((plain.oscillator.s0 - 0.227_380_875).abs() < 5e-10);
    assert!((plain.oscillator.delta - 0.083_336_875).abs() < 1e-9);
    assert!((plain.oscillator.f0_hz - 51_436.869).abs() < 5e-4);
    assert_eq!(plain.consistent, None);
    let weighted = fit(&points, Weighting::Covariance);
    assert!((weighted.oscillator.s0 - 0.227_706_8).abs() < 5e-8);
    assert!((weighted.oscillator.delta - 0.083_119_7).abs() < 5e-8);
    assert!((weighted.oscillator.f0_hz - 51_317.11).abs() < 5e-3);
    assert!((weighted.chi2.expect("tested") - 216.0).abs() < 0.05);
    assert_eq!(weighted.degrees_of_freedom, 95);
    assert_eq!(weighted.consistent, Some(false));
    let report = identify::report(&weighted, None);
    assert!(report.contains("REJECTED"), "{report}");
    assert!(
        report.lines().all(|line| line.chars().count() <= 80),
        "{report}"
    );
}

#[test]
fn noise_free_points_return_the_truth() {
    let points = read(&table(&TRUTH, None)).expect("points");
    for weighting in [Weighting::Covariance, Weighting::None] {
        let result = fit(&points, weighting);
        // Twelve digits are written.
        assert!((result.oscillator.s0 / TRUTH.s0 - 1.0).abs() < 1e-9);
        assert!((result.oscillator.f0_hz / TRUTH.f0_hz - 1.0).abs() < 1e-9);
        assert!((result.oscillator.delta - TRUTH.delta).abs() < 1e-9);
    }
}

#[test]
fn the_test_accepts_its_own_model_and_the_uncertainties_cover() {
    let mut lanes = Lanes::new(11, 0);
    let (mut rejected, mut covered) = (0, [0; 3]);
    let runs = 400;
    for _ in 0..runs {
        let points = read(&table(&TRUTH, Some(&mut lanes))).expect("points");
        let result = fit(&points, Weighting::Covariance);
        rejected += i32::from(result.consistent == Some(false));
        let truth = [TRUTH.s0, TRUTH.f0_hz, TRUTH.delta];
        let got = [
            result.oscillator.s0,
            result.oscillator.f0_hz,
            result.oscillator.delta,
        ];
        let u = [result.u_s0, result.u_f0_hz, result.u_delta];
        for index in 0..3 {
            let inside = (got[index] - truth[index]).abs() <= 1.959_964 * u[index];
            covered[index] += i32::from(inside);
        }
    }
    // 2.5 % of 400 are 10, with a binomial deviation of 3.1; four of them.
    assert!(rejected <= 23, "{rejected}");
    // 95 % of 400 are 380, deviation 4.4; four of them.
    for count in covered {
        assert!((363..=398).contains(&count), "{covered:?}");
    }
}

#[test]
fn monte_carlo_agrees_where_first_order_holds() {
    let points = read(&table(&TRUTH, None)).expect("points");
    let result = fit(&points, Weighting::Covariance);
    let spread = identify::propagate(&points, &result, 20_000, 3).expect("spread");
    // Relative standard error of a deviation from 20 000 trials is 0.5 %.
    for (drawn, first_order) in [
        (spread.s0.standard_uncertainty, result.u_s0),
        (spread.f0_hz.standard_uncertainty, result.u_f0_hz),
        (spread.delta.standard_uncertainty, result.u_delta),
    ] {
        assert!(
            (drawn / first_order - 1.0).abs() < 0.03,
            "{drawn} {first_order}"
        );
    }
    assert_eq!(spread.failed, 0);
}

#[test]
fn degrees_and_radians_are_one_angle() {
    let text = "f,S,phase_deg\n10,1.08,-2\n20,1.5,-6\n25,2,-10\n";
    let radians = "f,S,phase_rad\n10,1.08,-0.03490658503988659\n\
                   20,1.5,-0.10471975511965977\n25,2,-0.17453292519943295\n";
    let (a, b) = (read(text).expect("deg"), read(radians).expect("rad"));
    for (a, b) in a.points.iter().zip(&b.points) {
        assert!((a.phase_rad - b.phase_rad).abs() < 1e-15);
    }
}

#[test]
fn advice_and_faults_are_given() {
    // Up to a tenth of the resonance the sensitivity rises by 1 %.
    let low = Oscillator {
        f0_hz: 300.0,
        ..TRUTH
    };
    let result = fit(
        &read(&table(&low, None)).expect("points"),
        Weighting::Covariance,
    );
    assert!(
        result.warnings.iter().any(|w| w.contains("too low")),
        "{:?}",
        result.warnings
    );
    let near = Oscillator {
        f0_hz: 30.2,
        ..TRUTH
    };
    let result = fit(
        &read(&table(&near, None)).expect("points"),
        Weighting::Covariance,
    );
    assert!(
        result
            .warnings
            .iter()
            .any(|w| w.contains("next to the resonance"))
    );
    let cases = [
        ("", 1, "empty"),
        ("f,S,phase\n1,2,3\n2,3,4\n", 1, "unit"),
        ("f,S,phase_deg\n10,1,0\n10,1,0\n", 3, "twice"),
        ("f,S,phase_deg\n10,1,0\n-20,1,0\n", 3, "greater than zero"),
        ("f,S,phase_deg\n10,1,0\n20,nan,0\n", 3, "finite"),
        (
            "f,S,phase_deg,u_S,u_phase_deg\n10,1,0,0.1,-1\n20,1,0,1,1\n",
            2,
            "greater than zero",
        ),
        ("f,S,phase_deg,u_S\n10,1,0,0.1\n20,1,0,0.1\n", 1, "u_phase"),
        ("f,phase_deg\n10,1\n20,1\n", 1, "magnitude"),
        ("f,S,phase_deg\n10,1,0\n", 1, "one point"),
        ("f,S_db,phase_deg\n10,1,0\n20,1,0\n", 1, "in dB"),
        // Hz that say kHz made a resonance of 51 MHz.
        ("f_khz,S,phase_deg\n10,1,0\n1000,1,0\n", 3, "no exciter"),
        ("f,S,phase_rad\n10,1,0\n1000,1,-11\n", 3, "more than a turn"),
        (
            "f,S,phase_deg,u_S,u_phase_deg\n10,1,0,2,1\n20,1,0,1,1\n",
            2,
            "all of it",
        ),
    ];
    for (text, line, what) in cases {
        let error = read(text).expect_err(what);
        let message = error.to_string();
        assert!(message.starts_with(&format!("p.csv:{line}: ")), "{message}");
        assert!(message.contains(what), "{message}");
        assert!(error.hint().is_some(), "{message}");
    }
    // An inverted transducer is named as such.
    let points = read("f,S,phase_deg\n10,1,180\n20,1.1,179\n25,1.2,178\n").expect("points");
    let error = identify::identify(&points, Weighting::None, 0.05).expect_err("inverted");
    assert!(error.hint().is_some_and(|hint| hint.contains("inverted")));
}
