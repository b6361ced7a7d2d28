//! Datasets against what is stated about them.

use std::collections::BTreeMap;

use super::*;
use crate::effects::ActiveEffect;
use crate::model::Section;

fn made(effects: &[&str], options: &Options) -> Generated {
    let nominal = Nominal::standard();
    let effects: Vec<ActiveEffect> = effects
        .iter()
        .map(|text| text.parse().expect("known"))
        .collect();
    generate(&nominal, &standard_design(&nominal), &effects, options)
}

#[test]
fn a_dataset_without_effects_is_the_nominal_simulation() {
    // Off by nothing: what is left is the stated scatter of the rows and of the runs.
    let options = Options {
        parameters_off_by: Some(0.0),
        seed: 3,
        ..Options::default()
    };
    let generated = made(&[], &options);
    assert_eq!((generated.points.len(), generated.left_out), (214, 0));
    let nominal = Nominal::standard();
    let (mut sums, mut count) = ([0.0; 6], 0.0);
    for point in &generated.points {
        let omega = std::f64::consts::TAU * point.frequency_hz;
        let coil = nominal.exciter.model(point.payload_kg.expect("stated"));
        let [current, travel] = coil.linear_response(omega, 0.0);
        let value = |cell: Option<f64>| cell.expect("measured");
        let drive =
            value(point.ref_v) / value(point.coil_v) / (0.0102 * travel.norm() * omega * omega)
                - 1.0;
        let turn =
            (value(point.ref_deg) - (-travel).arg().to_degrees() + 540.0).rem_euclid(360.0) - 180.0;
        let ratio = value(point.dut_v) / value(point.ref_v) / (0.0100 / 0.0102) - 1.0;
        let second = point.dut_harmonics.expect("measured")[0];
        let errors = [
            drive / 5e-4_f64.hypot(2e-4),
            turn.to_radians() / 5e-4,
            ratio / 2e-4 / 3.0_f64.sqrt(),
            value(point.dut_deg) / 0.02,
            (value(point.coil_a) / value(point.coil_v) / current.norm() - 1.0) / 5e-4,
            second.amplitude * second.phase_deg.to_radians().cos() / 5e-5,
        ];
        for (sum, error) in sums.iter_mut().zip(errors) {
            *sum += error * error;
        }
        count += 1.0;
    }
    for (index, sum) in sums.into_iter().enumerate() {
        // Mean squares of 214 rows scatter by sqrt(2/214) = 10 %, those with ten runs' gains (a
        // third of drive's and two thirds of ratio's variance) by up to 35 %: four of each.
        let bound = if index == 2 { 1.4 } else { 0.45 };
        assert!(
            (sum / count - 1.0).abs() < bound,
            "{index}: {}",
            sum / count
        );
    }
}

#[test]
fn the_same_seed_gives_the_same_dataset() {
    let options = |seed| Options {
        seed,
        ..Options::default()
    };
    let csv =
        |seed| points_csv(&made(&["suspension_cubic", "mains_pickup"], &options(seed)).points);
    assert_eq!(csv(5), csv(5));
    assert_ne!(csv(5), csv(6));
}

/// Between two datasets of one seed nothing differs but the effect: its shape is seen bare.
#[test]
fn an_effect_is_the_only_difference_between_two_datasets_of_one_seed() {
    let options = Options::default();
    let plain = made(&[], &options);
    let bent = made(&["dut_resonance=resonance_hz:30000,quality:25"], &options);
    let resonance = Section::SecondOrder(crate::model::SecondOrder::low_pass(30e3, 25.0));
    for (plain, bent) in plain.points.iter().zip(&bent.points) {
        let ratio = |point: &Point| point.dut_v.expect("measured") / point.ref_v.expect("measured");
        let expected = resonance.response(plain.frequency_hz).norm();
        assert!((ratio(bent) / ratio(plain) / expected - 1.0).abs() < 1e-9);
        assert_eq!(plain.coil_v, bent.coil_v);
    }
}

/// The noise of a row is its own: rows that a clipped amplifier cannot hold are left out, and those
/// below its threshold stay as they were.
#[test]
fn rows_left_out_do_not_change_the_noise_of_the_others() {
    let options = Options::default();
    let plain = made(&[], &options);
    let clipped = made(&["amplifier_clipping=threshold_v:5"], &options);
    assert!(clipped.left_out > plain.left_out, "{}", clipped.left_out);
    let mut count = 0;
    for point in &clipped.points {
        let same = |p: &&Point| (p.time_s, p.frequency_hz) == (point.time_s, point.frequency_hz);
        let without = plain
            .points
            .iter()
            .find(same)
            .expect("held without clipping");
        if point.coil_v.is_some_and(|v| v > 3.0) {
            continue;
        }
        let noise = |p: &Point| p.ref_noise_v.zip(p.dut_dc_v).expect("measured");
        let (here, there) = (noise(point), noise(without));
        assert!((here.0 / there.0 - 1.0).abs() < 1e-9, "{here:?} {there:?}");
        assert!((here.1 - there.1).abs() < 1e-12, "{here:?} {there:?}");
        count += 1;
    }
    assert!(count > 100, "{count}");
}

#[test]
fn rows_of_one_run_share_their_gains() {
    let sharp = Uncertainties {
        ratio: 0.0,
        phase_deg: 0.0,
        ..Uncertainties::default()
    };
    let generated = made(
        &[],
        &Options {
            uncertainties: sharp,
            ..Options::default()
        },
    );
    let mut runs: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    for point in &generated.points {
        let ratio = point.dut_v.expect("measured") / point.ref_v.expect("measured");
        runs.entry(point.run).or_default().push(ratio);
    }
    let mut firsts: Vec<f64> = runs.values().map(|run| run[0]).collect();
    assert!(
        runs.values()
            .all(|run| run.iter().all(|ratio| (ratio / run[0] - 1.0).abs() < 1e-12))
    );
    firsts.dedup();
    assert_eq!(firsts.len(), 10);
}

#[test]
fn unlocked_sources_are_seen_as_noise_and_leak_into_their_neighbours() {
    let generated = made(
        &["mains_pickup=pickup_v:0.001,second_v:0,third_v:0"],
        &Options::default(),
    );
    let far = generated
        .points
        .iter()
        .find(|point| point.frequency_hz == 1000.0)
        .expect("in the design");
    // sqrt(1 mV^2 + 40 uV^2), scattered by 1 %.
    assert!((far.dut_noise_v.expect("measured") / 0.0010008 - 1.0).abs() < 0.05);
    assert!(far.ref_noise_v.expect("measured") < 5e-5);
    // At 50 Hz the line is taken for signal: the ratio scatters by 1 mV / 0.1 V and the noise is gone.
    let on_line: Vec<&Point> = generated
        .points
        .iter()
        .filter(|point| point.frequency_hz == 50.0)
        .collect();
    assert!(
        on_line
            .iter()
            .all(|point| point.dut_noise_v.expect("measured") < 1e-4)
    );
    let worst = on_line.iter().map(|point| {
        (point.dut_v.expect("measured") / point.ref_v.expect("measured") / 0.98 - 1.0).abs()
    });
    assert!(worst.fold(0.0, f64::max) > 1e-3);
}

#[test]
fn columns_that_are_not_measured_are_not_written() {
    let options = Options {
        columns: Columns::RatioOnly,
        ..Options::default()
    };
    let text = points_csv(&made(&[], &options).points);
    let header = text.lines().next().expect("a header");
    assert!(header.contains("ratio") && !header.contains("coil_v") && !header.contains("ref_v"));
    assert_eq!(text.lines().count(), 215);
    let width = header.split(',').count();
    assert!(text.lines().all(|line| line.split(',').count() == width));
    let drift = points_csv(&made(&["amplifier_gain_drift"], &Options::default()).points);
    assert!(!drift.contains("coil_a") && drift.contains("coil_v"));
}

#[test]
fn a_written_rig_is_read_back() {
    let nominal = Nominal::standard();
    let text = nominal.to_toml().expect("plain numbers");
    assert_eq!(
        Nominal::parse(&text, "rig.toml").expect("own text"),
        nominal
    );
    let bad = text.replace("mains_hz = 50.0", "mains_hz = -50.0");
    let message = Nominal::parse(&bad, "my.toml")
        .expect_err("refused")
        .to_string();
    assert!(
        message.contains("my.toml") && message.contains("mains_hz"),
        "{message}"
    );
}

#[test]
fn a_record_is_the_response_to_its_input() {
    let options = RecordOptions {
        samples: 2048,
        noise_rel: 0.0,
        ..RecordOptions::default()
    };
    let nominal = NominalOscillator::standard();
    let plain = nominal.record(&[], &options);
    let bent = nominal.record(&["cubic_stiffness=k3:3".parse().expect("known")], &options);
    assert_eq!(plain.input, bent.input);
    let rms =
        |values: &[f64]| (values.iter().map(|y| y * y).sum::<f64>() / values.len() as f64).sqrt();
    let change: Vec<f64> = plain
        .output
        .iter()
        .zip(&bent.output)
        .map(|(a, b)| a - b)
        .collect();
    // 3 x^2 of the stiffness at some 40 mV r.m.s. is 0.5 %, and resonance makes Q times that of it.
    let share = rms(&change) / rms(&plain.output);
    assert!((0.01..1.0).contains(&share), "{share}");
    assert_eq!(plain.csv().lines().count(), 2049);
    assert!(
        (rms(&plain.input) / 0.02 - 1.0).abs() < 0.15,
        "{}",
        rms(&plain.input)
    );
}
