//! A calibrator of four numbers, by Newton and Ohm: no other code than this forms its readings.

use super::*;
use num_complex::Complex64;
use std::f64::consts::TAU;

const FREQUENCIES_HZ: [f64; 15] = [
    40.0, 50.0, 63.0, 80.0, 100.0, 125.0, 160.0, 200.0, 250.0, 315.0, 400.0, 500.0, 630.0, 800.0,
    1000.0,
];
const SENSITIVITY: f64 = 0.0102;
const PHASE_RAD: f64 = -0.01;

/// One run of the calibrator.
#[derive(Clone, Copy)]
struct Case {
    mass_kg: f64,
    divider: bool,
    /// Coil, ohm.
    resistance_ohm: f64,
    /// Seat, m/N.
    seat_m_per_n: f64,
    sensitivity: f64,
    stiffness: f64,
}

const BARE: Case = Case {
    mass_kg: 0.0,
    divider: false,
    resistance_ohm: 4.0,
    seat_m_per_n: 0.0,
    sensitivity: SENSITIVITY,
    stiffness: 8000.0,
};

/// Amplitudes for a velocity of 1 m/s of the table: force over Bl is the current, and the voltage has e.m.f., coil
/// and shunt.
fn reading(case: Case, frequency_hz: f64) -> Reading {
    let w = TAU * frequency_hz;
    let acceleration = Complex64::new(0.0, w);
    let travel = Complex64::new(0.0, -1.0 / w);
    // A mass on a spring moves by 1/(1 - w^2 m C) of its seat.
    let carried = case.mass_kg / (1.0 - w * w * case.mass_kg * case.seat_m_per_n);
    let force = acceleration * (0.05 + carried) + 3.0 + travel * case.stiffness;
    let current = force / 7.0;
    let voltage = current * Complex64::new(case.resistance_ohm + 1.0, w * 1.2e-4) + 7.0;
    let reference = acceleration * Complex64::from_polar(case.sensitivity, PHASE_RAD);
    let device = if case.divider { 0.5 * voltage } else { current };
    Reading {
        frequency_hz,
        ratio: device / reference,
        scatter_rel: 1e-5,
        acceleration_rms_ms2: 20.0,
    }
}

fn certified() -> Vec<Certified> {
    let line = |_| Certified {
        sensitivity_v_per_ms2: SENSITIVITY,
        phase_rad: PHASE_RAD,
        expanded_uncertainty_rel: 0.005,
        ratio_standard_rel: 2.5e-4,
    };
    FREQUENCIES_HZ.iter().map(line).collect()
}

/// The ten runs of a calibrator, as `change` makes them of what is usual at each step.
fn runs_of(change: impl Fn(usize, Case) -> Case) -> Runs {
    let run = |place: usize| {
        let loaded = (2..8).contains(&place);
        let usual = Case {
            mass_kg: if loaded { 0.05 } else { 0.0 },
            divider: place % 2 == 1,
            ..BARE
        };
        let case = change(place, usual);
        FREQUENCIES_HZ.iter().map(|hz| reading(case, *hz)).collect()
    };
    Runs::new((0..10).map(run).collect(), certified()).expect("ten runs")
}

/// A mass that is rigid and bare.
fn rigid() -> Equipment {
    Equipment {
        film_kg: 0.0,
        seat_m_per_n: [0.0, 0.0],
        ..Equipment::default()
    }
}

#[test]
fn a_calibrator_by_hand_gives_its_sensitivity() {
    let found = evaluate(&runs_of(|_, case| case), &rigid()).expect("a check");
    for point in &found.points {
        // Rounding of 1e-16, 65 times larger in a difference of impedances.
        assert!(
            (point.sensitivity_v_per_ms2 / SENSITIVITY - 1.0).abs() < 1e-10,
            "{point:?}"
        );
        assert!(
            (point.phase_deg - PHASE_RAD.to_degrees()).abs() < 1e-7,
            "{point:?}"
        );
    }
    let exciter = found.exciter;
    for (found, expected) in [
        (exciter.moving_mass_kg, 0.05),
        (exciter.stiffness_n_per_m, 8000.0),
        (exciter.damping_ns_per_m, 3.0),
        (exciter.force_factor_n_per_a, 7.0),
    ] {
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    }
}

/// A constant in both impedances cancels: leads, a blocked impedance of any kind.
#[test]
fn the_blocked_impedance_cancels() {
    let found = evaluate(
        &runs_of(|_, case| Case {
            resistance_ohm: 11.0,
            ..case
        }),
        &rigid(),
    );
    for point in found.expect("a check").points {
        assert!(point.change_rel.abs() < 1e-9, "{point:?}");
    }
}

/// 20 mohm of the coil lie across the difference of the impedances at 1 kHz, 0.078 ohm: its magnitude grows to
/// sqrt(1 + 0.26^2), so |S1| would be 1.6 % off; near the resonance they lie along it. The fit takes both away.
#[test]
fn a_coil_that_is_warmer_with_the_mass_is_seen_in_the_phase_and_taken_away() {
    let warmer = |place: usize, case: Case| Case {
        resistance_ohm: 4.0 + if (2..8).contains(&place) { 0.02 } else { 0.0 },
        ..case
    };
    let runs = runs_of(warmer);
    let found = evaluate(&runs, &rigid()).expect("a check");
    assert!(
        (found.exciter.warmer_ohm - 0.02).abs() < 1e-3,
        "{:?}",
        found.exciter
    );
    for point in &found.points {
        // What is left of 20 mohm is below the 1 mohm of the budget.
        let row = found
            .budget
            .iter()
            .find(|row| row.what == "warming of the coil");
        assert!(row.is_some());
        assert!(point.change_rel.abs() < 5e-4, "{point:?}");
    }
}

/// 50 g on 3e8 N/m: w^2 m C/2 = 0.33 % at 1 kHz.
#[test]
fn the_seat_is_corrected_for_its_mean() {
    let on_a_seat = |_, case: Case| Case {
        seat_m_per_n: 1.0 / 3e8,
        ..case
    };
    let runs = runs_of(on_a_seat);
    let raw = evaluate(&runs, &rigid()).expect("a check");
    let expected = (TAU * 1000.0).powi(2) * 0.05 / 3e8 / 2.0;
    assert!(
        (raw.points[14].change_rel + expected).abs() < 2e-5,
        "{:?}",
        raw.points[14]
    );
    let known = Equipment {
        seat_m_per_n: [1.0 / 3e8, 1e-10],
        ..rigid()
    };
    let corrected = evaluate(&runs, &known).expect("a check");
    assert!(corrected.points[14].change_rel.abs() < 1e-9);
}

/// The row of noise is the derivative by every reading, by finite differences.
#[test]
fn noise_is_amplified_as_the_budget_says() {
    let equipment = rigid();
    let untouched = evaluate(&runs_of(|_, case| case), &equipment).expect("a check");
    let noise = untouched
        .budget
        .iter()
        .find(|row| row.what == "noise")
        .expect("a row");
    const STEP: f64 = 1e-8;
    for index in [2, 6, 9, 14] {
        let mut variance = 0.0;
        for place in 0..10 {
            for part in [Complex64::new(1.0, 0.0), Complex64::new(0.0, 1.0)] {
                let mut runs = runs_of(|_, case| case);
                let pairs = runs.bare.iter_mut().take(1).chain(&mut runs.loaded);
                let mut all: Vec<_> = pairs
                    .flat_map(|pair| [&mut pair.shunt, &mut pair.divider])
                    .collect();
                let Some(run) = all.get_mut(place) else {
                    continue;
                };
                run[index].ratio *= 1.0 + part * STEP;
                let moved = evaluate(&runs, &equipment).expect("a check").points[index];
                let slope = (moved.sensitivity_v_per_ms2
                    / untouched.points[index].sensitivity_v_per_ms2
                    - 1.0)
                    / STEP;
                // The last bare pair has the slope of the first.
                let alike = if place < 2 { 2.0 } else { 1.0 };
                variance += alike * (slope * 1e-5).powi(2);
            }
        }
        let expected = variance.sqrt();
        // The fit of the warmth moves with a reading as well, a little.
        assert!(
            (noise.standard_rel[index] / expected - 1.0).abs() < 0.1,
            "{index}: {} {expected}",
            noise.standard_rel[index]
        );
    }
}

#[test]
fn data_that_speak_against_the_model_are_refused() {
    let refusal = |change: &dyn Fn(usize, Case) -> Case| {
        evaluate(&runs_of(change), &rigid())
            .expect_err("refused")
            .to_string()
    };
    let moved = refusal(&|place, case| Case {
        sensitivity: SENSITIVITY * if place > 7 { 1.01 } else { 1.0 },
        ..case
    });
    assert!(moved.contains("after it against before"), "{moved}");
    let loose = refusal(&|place, case| Case {
        mass_kg: if (4..6).contains(&place) {
            0.047
        } else {
            case.mass_kg
        },
        ..case
    });
    assert!(loose.contains("is it seated"), "{loose}");
    // A suspension that is stiffer with the mass is not that of one exciter.
    let stiffer = refusal(&|place, case| Case {
        stiffness: if (2..8).contains(&place) {
            9500.0
        } else {
            8000.0
        },
        ..case
    });
    assert!(
        stiffer.contains("mass on a spring") || stiffer.contains("reciprocal model"),
        "{stiffer}"
    );
    // A divider in the shunt's place and the other way round.
    let exchanged = refusal(&|_, case| Case {
        divider: !case.divider,
        ..case
    });
    assert!(!exchanged.is_empty());
    // A result that bends over frequency: a seat ten times softer than stated.
    let soft = refusal(&|_, case| Case {
        seat_m_per_n: 1.0 / 6e6,
        ..case
    });
    assert!(!soft.is_empty());
}

#[test]
fn a_change_is_told_from_a_difference_to_the_certificate() {
    let of = |sensitivity: f64| {
        evaluate(
            &runs_of(|_, case| Case {
                sensitivity,
                ..case
            }),
            &rigid(),
        )
        .expect("a check")
    };
    let (baseline, now) = (of(SENSITIVITY), of(SENSITIVITY * 0.995));
    let found = change(&now, &baseline).expect("seven frequencies");
    // The logarithm of means against the mean of logarithms: nothing here, all are alike.
    assert!(
        (found.change_rel + 0.005).abs() < 1e-9 && found.significant,
        "{found:?}"
    );
    assert_eq!((found.frequencies, found.against), (7, Against::Baseline));
    assert!(
        found.words().starts_with("changed by -0.50 %"),
        "{}",
        found.words()
    );
    assert!(!change(&baseline, &baseline).expect("seven").significant);
    let found = from_certificate(&now).expect("seven");
    assert!(
        !found.significant && found.expanded_rel > 0.005,
        "{found:?}"
    );
    assert!(
        found
            .words()
            .starts_with("agrees with the certificate: -0.50 %")
    );
    let far = from_certificate(&of(SENSITIVITY * 1.02)).expect("seven");
    assert!(
        far.significant
            && far
                .words()
                .starts_with("differs from the certificate by +2.00 %")
    );
}

/// 12 K of at most 0.02 %/K, even: 12 * 2e-4 / sqrt 3 = 0.14 % beside what else is in U of the change.
#[test]
fn a_check_at_another_temperature_counts_what_the_coefficient_may_be() {
    let at = |temperature_c, sensitivity: f64| {
        let runs = Runs {
            temperature_c,
            ..runs_of(|_, case| Case {
                sensitivity,
                ..case
            })
        };
        evaluate(&runs, &rigid()).expect("a check")
    };
    let baseline = at(Some(23.0), SENSITIVITY);
    let since = |now: &Evaluation| change(now, &baseline).expect("seven");
    let same = since(&at(Some(23.0), SENSITIVITY * 0.998));
    let warm = since(&at(Some(35.0), SENSITIVITY * 0.998));
    let expected = (2.0 * 12.0 * 2e-4 / 3.0_f64.sqrt()).hypot(same.expanded_rel);
    assert!(
        (warm.expanded_rel / expected - 1.0).abs() < 1e-9,
        "{warm:?}"
    );
    // 0.2 % is a change at one temperature, and may be the temperature at two.
    assert!(same.significant && !warm.significant);
    // Nobody told: 10 K to either side, even, of a coefficient that is even as well.
    let untold = since(&at(None, SENSITIVITY * 0.998));
    let expected = (2.0 * 10.0 * 2e-4 / 3.0_f64).hypot(same.expanded_rel);
    assert!(
        (untold.expanded_rel / expected - 1.0).abs() < 1e-9,
        "{untold:?}"
    );

    // A coefficient that is known is taken out: 0.01 %/K more of 12 K.
    let known = Equipment {
        reference_per_k: [1e-4, 0.0],
        ..rigid()
    };
    let runs = Runs {
        temperature_c: Some(35.0),
        ..runs_of(|_, case| Case {
            sensitivity: SENSITIVITY * 1.0012,
            ..case
        })
    };
    let found = evaluate(&runs, &known).expect("a check");
    let off = found.points[6].sensitivity_v_per_ms2 / SENSITIVITY - 1.0;
    assert!(off.abs() < 1e-10, "{off}");
}

/// The channels change as the reference may: a check says what it does not know of them.
#[test]
fn what_the_ratio_of_the_channels_leaves_open_is_said() {
    let row = |frequency_hz, magnitude, expanded_uncertainty_rel| RatioRow {
        frequency_hz,
        magnitude,
        phase_rad: 0.0,
        expanded_uncertainty_rel,
    };
    let with = |ratio: &[RatioRow]| {
        let mut runs = runs_of(|_, case| case);
        runs.ratio = ratio.to_vec();
        evaluate(&runs, &rigid()).expect("a check")
    };
    let baseline = with(&[row(160.0, 1.001, 4e-4)]);
    for (ratio, expected) in [
        (&[][..], Some("was never measured")),
        (
            &[row(160.0, 1.001, 4e-4)],
            Some("is still that of the baseline"),
        ),
        (&[row(160.0, 1.0012, 23e-4)], Some("is known to 0.23 %")),
        (&[row(160.0, 1.0012, 4e-4), row(2000.0, 1.0, 1e-2)], None),
    ] {
        let said = about_the_ratio(&with(ratio), Some(&baseline));
        match (said, expected) {
            (Some(said), Some(expected)) => assert!(said.contains(expected), "{said}"),
            (said, expected) => assert_eq!(said.as_deref(), expected),
        }
    }
    assert_eq!(about_the_ratio(&baseline, None), None);
}

#[test]
fn runs_that_are_none_are_told() {
    let run = || -> Vec<Reading> { FREQUENCIES_HZ.iter().map(|hz| reading(BARE, *hz)).collect() };
    let told = |runs| Runs::new(runs, certified()).expect_err("none").to_string();
    assert!(told(vec![run(); 9]).contains("has 10 runs, and these are 9"));
    let mut shorter = vec![run(); 10];
    shorter[4].pop();
    assert!(told(shorter).contains("run 5 has other frequencies"));
    let mut silent = vec![run(); 10];
    silent[2][3].ratio = Complex64::new(0.0, 0.0);
    assert!(told(silent).contains("run 3 holds a value that is no number"));
}
