//! Every effect of an oscillator that has a name is found by it.

use super::sealed::oscillator::{Added, RIG, added, record, record_with};
use super::sealed::random::Random;
use calib_gap::{Answer, Options, Verdict, diagnose};
use rayon::prelude::*;

const SAMPLES: usize = 3000;
/// Records of each corner of a low-pass.
const SEEDS: u64 = 2;

fn answer(name: &str, text: &str) -> Answer {
    answer_with(name, text, &Options::default())
}

fn answer_with(name: &str, text: &str, options: &Options) -> Answer {
    answer_of_rig(name, RIG, text, options)
}

fn answer_of_rig(name: &str, rig: &str, text: &str, options: &Options) -> Answer {
    let folder =
        std::env::temp_dir().join(format!("calib-oscillator-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the record");
    std::fs::write(folder.join("rig.toml"), rig).expect("the rig is written");
    std::fs::write(folder.join("record.csv"), text).expect("the record is written");
    let answer = diagnose(&folder, options).expect("the record is good");
    let _ = std::fs::remove_dir_all(&folder);
    answer
}

#[test]
fn every_effect_of_an_oscillator_is_named() {
    // Damping that grows with speed is stated relative to the linear one, 2 x 0.03.
    let truth = [
        ("cubic_stiffness", "k3", 2.0),
        ("quadratic_stiffness", "k2", 0.5),
        ("coulomb_friction", "deflection", 0.003),
        ("quadratic_damping", "d2", 0.15 / 0.06),
        ("cubic_damping", "d3", 1.0 / 0.06),
        ("input_delay", "tau_s", 0.0004),
        ("input_saturation", "threshold", 0.08),
        ("output_highpass", "corner_hz", 1.0),
        ("output_lowpass", "corner_hz", 300.0),
        ("output_clipping", "threshold", 0.2),
        ("output_trend", "drift_per_s", 0.02),
        ("resonance_drift", "drift_per_s", 0.01),
        ("second_mode", "gain", 0.1),
        ("dead_zone", "half_width", 0.01),
        ("hysteresis", "alpha", 0.2),
    ];
    let wrong: Vec<String> = truth
        .par_iter()
        .enumerate()
        .filter_map(|(i, (name, parameter, value))| {
            let answer = answer(
                name,
                &record(&added(name), SAMPLES, &mut Random::new(900 + i as u64)),
            );
            let first = answer
                .causes
                .first()
                .map(|c| c.effects.clone())
                .unwrap_or_default();
            // 1 % for what the fit and the integration do not have in common, such as the slope
            // of friction about rest.
            let found = answer.causes[0]
                .parameters
                .get(name)
                .map(|of| of[parameter]);
            let stated = found.is_some_and(|f| (f.value - value).abs() < 5.0 * f.u + 0.01 * value);
            let right = first.first() == Some(name)
                && stated
                && answer.verdict != Verdict::Unexplained
                && answer.gap.size.closed.is_some_and(|c| c > 0.9);
            (!right).then(|| {
                let causes: Vec<_> = answer
                    .causes
                    .iter()
                    .map(|c| (&c.effects, c.probability))
                    .collect();
                format!(
                    "{name}: {found:?} {:?} p = {:e} {causes:?} {:?}",
                    answer.verdict, answer.none_of_these_p_value, answer.gap
                )
            })
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_linear_oscillator_has_no_gap() {
    let text = record(&Default::default(), SAMPLES, &mut Random::new(899));
    let answer = answer("linear", &text);
    assert_eq!(answer.verdict, Verdict::NoGap, "{:?}", answer.gap);
}

/// A converter holds what it puts out. Read as a smooth signal that is half a sample of delay, which was named, beside
/// whatever else there was.
#[test]
fn an_input_that_is_held_is_no_delay() {
    let held = Added {
        holds: true,
        ..Added::default()
    };
    let linear = record_with(&held, SAMPLES, 1e-4, &mut Random::new(870));
    let answer_to = |name: &str, text: &str| answer(&format!("held-{name}"), text);
    let linear = answer_to("linear", &linear);
    assert_eq!(linear.verdict, Verdict::NoGap, "{}", linear.summary);
    let two_samples = Added {
        delay_s: 2e-3,
        ..Added::default()
    };
    let cases = [
        ("cubic_stiffness", added("cubic_stiffness")),
        ("output_highpass", added("output_highpass")),
        ("input_delay", two_samples),
    ];
    for (name, of) in cases {
        let of = Added { holds: true, ..of };
        let answer = answer_to(name, &record(&of, SAMPLES, &mut Random::new(871)));
        assert_eq!(answer.causes[0].effects, [name], "{}", answer.summary);
        assert_eq!(answer.verdict, Verdict::Explained, "{}", answer.summary);
        assert_eq!(answer.dataset.input_held, Some(true));
    }
}

/// Force in newtons, motion in metres, and a rig that states nothing. A simulation of gain 1 began far away: play was
/// named, and a record of larger forces was refused as one that diverges.
#[test]
fn units_do_not_decide() {
    let text = record(&added("cubic_stiffness"), SAMPLES, &mut Random::new(872));
    let (force, metres) = (5e4, 1e-4);
    let scaled = |line: &str| {
        let cells: Vec<f64> = line
            .split(',')
            .map(|c| c.parse().expect("a number"))
            .collect();
        format!(
            "{},{:e},{:e}\n",
            cells[0],
            force * cells[1],
            metres * cells[2]
        )
    };
    let rows: String = text.lines().skip(1).map(scaled).collect();
    let text = format!("time_s,input,output\n{rows}");
    let answer = answer_of_rig(
        "units",
        "kind = \"oscillator\"\n",
        &text,
        &Options::default(),
    );
    assert_eq!(
        answer.causes[0].effects,
        ["cubic_stiffness"],
        "{}",
        answer.summary
    );
    let k3 = answer.causes[0].parameters["cubic_stiffness"]["k3"].value;
    assert!((k3 * metres * metres / 2.0 - 1.0).abs() < 0.01, "{k3}");
}

/// The state that a slow high-pass held back before the record still shows at its end.
#[test]
fn a_slow_high_pass_is_found() {
    let filtered = Added {
        corner_hz: 0.2,
        ..Added::default()
    };
    let answer = answer("slow", &record(&filtered, SAMPLES, &mut Random::new(879)));
    assert_eq!(answer.causes[0].effects, ["output_highpass"]);
    assert_eq!(answer.verdict, Verdict::Explained, "{:?}", answer.gap);
}

/// A corner below the resonance holds back most of the motion, one far above it delays it by a tenth of
/// a sample.
#[test]
fn a_low_pass_is_found_alone_wherever_its_corner_is() {
    let cases = [10.0, 20.0, 30.0, 1500.0];
    let cases: Vec<(u64, f64)> = cases
        .into_iter()
        .flat_map(|corner_hz| (0..SEEDS).map(move |n| (4000 + n, corner_hz)))
        .collect();
    let wrong: Vec<String> = cases
        .par_iter()
        .filter_map(|(seed, corner_hz)| {
            let filtered = Added {
                lowpass_hz: *corner_hz,
                ..Added::default()
            };
            let text = record(&filtered, SAMPLES, &mut Random::new(*seed));
            let answer = answer(&format!("lowpass-{corner_hz}-{seed}"), &text);
            let first = &answer.causes[0];
            let found = &first.parameters.get("output_lowpass");
            let found_hz = found.map_or(f64::NAN, |of| of["corner_hz"].value);
            let right = first.effects == ["output_lowpass"]
                && answer.verdict == Verdict::Explained
                && (found_hz / corner_hz - 1.0).abs() < 1e-3;
            (!right).then(|| {
                let (verdict, closed) = (answer.verdict, answer.gap.size.closed);
                format!(
                    "{corner_hz} {seed}: {:?} {found_hz} {verdict:?} {closed:?}",
                    first.effects
                )
            })
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A zero that creeps until the cable is touched is a trend in the three quarters that are fitted. In the
/// last the trend errs by more than a zero that stays, and a partner must help there too.
#[test]
fn a_trend_that_the_held_out_quarter_refutes_is_not_listed() {
    for (name, spring) in [
        ("linear", Added::default()),
        ("cubic", added("cubic_stiffness")),
    ] {
        let creeps = Added {
            drift_per_s: 0.02,
            snaps_back_s: 2.25,
            ..spring
        };
        let text = record(&creeps, SAMPLES, &mut Random::new(878));
        let answer = answer(&format!("creeps-{name}"), &text);
        let (before, after) = (answer.gap.rms_before, answer.gap.rms_after);
        assert!(after <= before, "{name}: {:?}", answer.gap);
        let trend = |c: &calib_gap::Cause| c.effects.contains(&"output_trend");
        assert!(
            !answer.causes.iter().any(trend),
            "{name}: {}",
            answer.summary
        );
        let spring = |c: &calib_gap::Cause| c.effects == ["cubic_stiffness"];
        let leads = answer.causes.first().is_some_and(spring);
        assert_eq!(leads, name == "cubic", "{}", answer.summary);
        assert_ne!(answer.verdict, Verdict::Explained, "{}", answer.summary);
    }
}

/// A record that nothing drives: pulled aside and let go. A spring changes its pitch, air its decay.
#[test]
fn a_free_decay_is_answered() {
    for (seed, name) in [
        (870, "linear"),
        (871, "cubic_stiffness"),
        (872, "quadratic_damping"),
    ] {
        let effect = match name {
            "linear" => Added::default(),
            name => added(name),
        };
        let released = Added {
            released_at: 0.4,
            ..effect
        };
        let text = record(&released, SAMPLES, &mut Random::new(seed));
        let answer = answer(&format!("decay-{name}"), &text);
        if name == "linear" {
            assert_eq!(answer.verdict, Verdict::NoGap, "{:?}", answer.gap);
        } else {
            assert_eq!(answer.causes[0].effects, [name], "{}", answer.summary);
            assert_eq!(answer.verdict, Verdict::Explained, "{:?}", answer.gap);
        }
        let values = &answer.nominal_parameters;
        assert!(!values.contains_key("gain"));
        for (value, truth) in [("resonance_hz", 61.0), ("delta", 0.03)] {
            let found = &values[value];
            assert!(
                (found.value - truth).abs() < 5.0 * found.u + 1e-4 * truth,
                "{name}: {value} {found:?}"
            );
        }
    }
}

/// Dry friction ends a decay after a few swings. How the mass then creeps, or sticks, is another matter.
#[test]
fn friction_leads_where_a_decay_ends_soon() {
    let released = Added {
        released_at: 0.4,
        ..added("coulomb_friction")
    };
    let text = record(&released, SAMPLES, &mut Random::new(873));
    let answer = answer("decay-friction", &text);
    let first = &answer.causes[0];
    assert_eq!(first.effects[0], "coulomb_friction", "{}", answer.summary);
    let found = &first.parameters["coulomb_friction"]["deflection"];
    assert!((found.value / 0.003 - 1.0).abs() < 0.01, "{found:?}");
}

/// Springs that soften as a sine, harden with the fifth power, and friction that is larger at rest: the
/// family is named, and with it most of the gap is gone.
#[test]
fn another_form_is_named_by_its_family() {
    let none = Added::default;
    let forms = [
        (
            "cubic_stiffness",
            Added {
                sine: 2.0,
                ..none()
            },
        ),
        (
            "cubic_stiffness",
            Added {
                cubic: -1.0,
                ..none()
            },
        ),
        (
            "cubic_stiffness",
            Added {
                quintic: 20.0,
                ..none()
            },
        ),
        (
            "cubic_stiffness",
            Added {
                quintic: 100.0,
                ..none()
            },
        ),
        (
            "coulomb_friction",
            Added {
                sticking: 0.5,
                ..added("coulomb_friction")
            },
        ),
    ];
    let wrong: Vec<String> = forms
        .par_iter()
        .enumerate()
        .filter_map(|(n, (family, form))| {
            let text = record(form, SAMPLES, &mut Random::new(860 + n as u64));
            let answer = answer(&format!("form-{n}"), &text);
            let named = answer
                .causes
                .first()
                .is_some_and(|c| c.effects.contains(family));
            let said = matches!(
                answer.verdict,
                Verdict::Explained | Verdict::PartlyExplained | Verdict::Ambiguous
            );
            let (verdict, closed) = (answer.verdict, answer.gap.size.closed);
            (!named || !said)
                .then(|| format!("{n} {family}: {verdict:?} {closed:?} {}", answer.summary))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The zero of a sensor and a steady force move a linear oscillator alike: their sum is its offset.
#[test]
fn offsets_of_a_linear_oscillator_are_no_gap() {
    for (seed, zero, steady) in [(883, 0.05, 0.0), (884, 0.0, -0.03), (885, -0.3, 0.02)] {
        let shifted = Added {
            zero,
            steady,
            ..Added::default()
        };
        let text = record(&shifted, SAMPLES, &mut Random::new(seed));
        let answer = answer(&format!("offset-{seed}"), &text);
        assert_eq!(answer.verdict, Verdict::NoGap, "{:?}", answer.gap);
        let offset = &answer.nominal_parameters["offset"];
        assert!(
            (offset.value - zero - steady).abs() < 5.0 * offset.u,
            "{offset:?}"
        );
    }
}

/// Errors are relative to the motion: a zero of five times the motion is none of it.
#[test]
fn the_zero_of_a_sensor_makes_no_gap_smaller() {
    let of = |zero| {
        let bent = Added {
            zero,
            ..added("cubic_stiffness")
        };
        let text = record(&bent, SAMPLES, &mut Random::new(886));
        answer(&format!("far-zero-{zero}"), &text)
    };
    let (near, far) = (of(0.0), of(0.5));
    let before = [&near, &far].map(|answer| answer.gap.size.before_rel);
    // The same motion and noise but for rounding of the file, six digits.
    assert!((before[0] / before[1] - 1.0).abs() < 0.01, "{before:?}");
    let levels = |answer: &Answer| answer.gap.by_level.last().map(|level| level.to);
    let (near, far) = (
        levels(&near).expect("levels"),
        levels(&far).expect("levels"),
    );
    assert!((near / far - 1.0).abs() < 0.01, "{near} {far}");
}

/// The spring is bent about its rest, not about the zero of the sensor.
#[test]
fn the_zero_of_a_sensor_does_not_bend_a_spring_to_one_side() {
    let shifted = Added {
        zero: 0.05,
        ..added("cubic_stiffness")
    };
    let answer = answer("zero", &record(&shifted, SAMPLES, &mut Random::new(886)));
    assert_eq!(answer.causes[0].effects, ["cubic_stiffness"]);
    assert_eq!(answer.verdict, Verdict::Explained, "{:?}", answer.causes);
    let offset = &answer.nominal_parameters["offset"];
    assert!(
        (offset.value - 0.05).abs() < 5.0 * offset.u + 1e-6,
        "{offset:?}"
    );
}

#[test]
fn a_trend_beside_a_cubic_spring_is_found_with_it() {
    let both = Added {
        drift_per_s: -0.01,
        ..added("cubic_stiffness")
    };
    let answer = answer("both", &record(&both, SAMPLES, &mut Random::new(887)));
    let first = &answer.causes[0];
    let mut effects = first.effects.clone();
    effects.sort_unstable();
    assert_eq!(effects, ["cubic_stiffness", "output_trend"]);
    assert_eq!(answer.verdict, Verdict::Explained, "{:?}", answer.gap);
    let found = &first.parameters["output_trend"]["drift_per_s"];
    assert!((found.value + 0.01).abs() < 5.0 * found.u, "{found:?}");
}

/// Play lies about the rest of the spring, wherever a steady force holds it.
#[test]
fn a_steady_force_is_found_beside_play() {
    let held = Added {
        steady: 0.03,
        ..added("dead_zone")
    };
    let answer = answer("held", &record(&held, SAMPLES, &mut Random::new(888)));
    let first = &answer.causes[0];
    let mut effects = first.effects.clone();
    effects.sort_unstable();
    assert_eq!(effects, ["dead_zone", "input_offset"], "{:?}", answer.gap);
    let found = &first.parameters["input_offset"]["offset"];
    assert!(
        (found.value - 0.03).abs() < 5.0 * found.u + 3e-4,
        "{found:?}"
    );
}

/// A cubic spring about a rest that is not its middle has a quadratic part: with the zero of the sensor
/// unknown the two are one and the same.
#[test]
fn a_steady_force_on_a_cubic_spring_may_be_an_asymmetric_spring() {
    let held = Added {
        steady: 0.05,
        ..added("cubic_stiffness")
    };
    let answer = answer("sagged", &record(&held, SAMPLES, &mut Random::new(889)));
    assert_eq!(answer.verdict, Verdict::Ambiguous, "{:?}", answer.gap);
    let listed: Vec<String> = answer.causes.iter().map(|c| c.effects.join("+")).collect();
    for expected in ["quadratic_stiffness", "input_offset"] {
        let expected = format!("cubic_stiffness+{expected}");
        assert!(listed.contains(&expected), "{listed:?}");
    }
}

#[test]
fn an_oscillator_whose_effect_has_no_name_is_unexplained() {
    let text = record(&added("second_mode"), SAMPLES, &mut Random::new(898));
    let options = Options {
        without: vec!["second_mode".into()],
        ..Options::default()
    };
    let answer = answer_with("withheld", &text, &options);
    assert_eq!(answer.verdict, Verdict::Unexplained, "{:?}", answer.gap);
    assert!(
        answer.none_of_these_p_value < 1e-6,
        "{:e}",
        answer.none_of_these_p_value
    );
}

/// At a noise of 1e-5 of the motion an integration that errs by more hides a spring that moves
/// it by as little, or shows as a delay where there is nothing.
#[test]
fn a_faint_spring_is_found_at_little_noise() {
    let faint = Added {
        quadratic: 2e-4,
        ..Added::default()
    };
    let quiet = |added: &Added, seed| record_with(added, SAMPLES, 1e-6, &mut Random::new(seed));
    let found = answer("faint", &quiet(&faint, 897));
    assert_eq!(found.causes[0].effects, ["quadratic_stiffness"]);
    assert_eq!(found.verdict, Verdict::Explained, "{:?}", found.gap);
    let none = answer("quiet", &quiet(&Added::default(), 895));
    assert_eq!(none.verdict, Verdict::NoGap, "{:?}", none.gap);
}

/// A spring whose stiffness half doubles at the amplitude of the record: the resonance of the
/// linear fit is a quarter above that of small motion.
#[test]
fn a_spring_that_hardens_grossly_is_found() {
    let gross = Added {
        cubic: 15.0,
        ..Added::default()
    };
    let answer = answer("gross", &record(&gross, SAMPLES, &mut Random::new(896)));
    let first = &answer.causes[0];
    assert_eq!(first.effects, ["cubic_stiffness"], "{:?}", answer.gap);
    assert_eq!(answer.verdict, Verdict::Explained, "{:?}", answer.gap);
    let found = &first.parameters["cubic_stiffness"]["k3"];
    assert!((found.value / 15.0 - 1.0).abs() < 1e-3, "{found:?}");
}

/// A pendulum that swings to 1.5 rad, and beyond the top in the quarter of the record that takes no
/// part: the cubic spring that describes the first three has no way back from there.
#[test]
fn a_record_on_which_a_fitted_spring_runs_away_is_answered() {
    let pendulum = Added {
        sine: 4.0,
        louder: 1.8,
        ..Added::default()
    };
    let answer = answer(
        "pendulum",
        &record(&pendulum, SAMPLES, &mut Random::new(894)),
    );
    assert_eq!(answer.verdict, Verdict::Unexplained, "{:?}", answer.gap);
    assert!(answer.gap.rms_after.is_some_and(f64::is_finite));
}
