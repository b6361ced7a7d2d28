//! Tests a channel's view of a bent wave against the wave itself sampled in time.

use super::*;
use crate::calibrator::example::{named, rig};
use crate::dataset::{ExciterParameters, Harmonic, Point};
use crate::model::memory::{Memory, Recall};
use crate::model::predict::predict;
use std::f64::consts::TAU;

const LEVEL_MS2: f64 = 10.0;

/// The effects at 20 Hz, 10 m/s2, on a reference of 10 mV and a device of 20 mV per m/s2.
fn predicted(effects: &[(&str, usize, Vec<f64>)]) -> Prediction {
    let harmonic = Harmonic {
        amplitude: 0.0,
        phase_rad: Some(0.0),
    };
    let point = Point {
        frequency_hz: 20.0,
        acceleration_ms2: Some(LEVEL_MS2),
        payload_kg: Some(0.04),
        ref_harmonics: [Some(harmonic); 4],
        dut_harmonics: [Some(harmonic); 4],
        u_harmonic: Some(1e-4),
        ..Point::default()
    };
    let row = Row::new(&point, &rig());
    let effects = effects.iter();
    let active: Vec<_> = effects
        .map(|(name, number, values)| named(name, *number, values))
        .collect();
    let nominal = Nominal {
        exciter: Some(ExciterParameters {
            moving_mass_kg: 0.05,
            stiffness_n_per_m: 8000.0,
            damping_ns_per_m: 3.0,
            force_factor_n_per_a: 7.0,
            coil_resistance_ohm: 4.0,
            coil_inductance_h: 1.2e-4,
        }),
        drive_ln: 0.01_f64.ln(),
        ratio_ln: 2.0_f64.ln(),
        dut_gain: 1.0,
        reference_gain: 1.0,
        noise_v: [1e-5; 2],
        noise_ln: [1e-5_f64.ln(); 2],
    };
    predict(
        &row,
        &nominal,
        &active,
        Recall::Keep(&mut Memory::default()),
    )
}

fn harmonics(found: &Prediction, channel: Channel) -> [Complex64; 4] {
    let value = |[re, im]: [Observable; 2]| Complex64::new(found.value[re], found.value[im]);
    Observable::harmonics(channel).map(value)
}

const SAMPLES: usize = 1 << 14;

/// One period of a fundamental with relative harmonics.
fn wave_in_time(peak: f64, harmonics: &[Complex64; 4]) -> Vec<f64> {
    let at = |i: usize| {
        let t = TAU * i as f64 / SAMPLES as f64;
        let of =
            |(k, h): (usize, &Complex64)| (h * Complex64::from_polar(1.0, (k + 2) as f64 * t)).re;
        peak * (t.cos() + harmonics.iter().enumerate().map(of).sum::<f64>())
    };
    (0..SAMPLES).map(at).collect()
}

/// Peak phasor of an order.
fn phasor(samples: &[f64], n: usize) -> Complex64 {
    let of = |(i, v): (usize, &f64)| {
        Complex64::from_polar(*v, -TAU * ((n * i) % SAMPLES) as f64 / SAMPLES as f64)
    };
    samples.iter().enumerate().map(of).sum::<Complex64>() * (2.0 / SAMPLES as f64)
}

fn relative(samples: &[f64]) -> [Complex64; 4] {
    let first = phasor(samples, 1);
    let turn = (first / first.norm()).conj();
    std::array::from_fn(|k| phasor(samples, k + 2) / first.norm() * turn.powu(k as u32 + 2))
}

fn compare(found: &[Complex64; 4], expected: &[Complex64; 4], within: f64, what: &str) {
    for (k, (a, b)) in found.iter().zip(expected).enumerate() {
        assert!((a - b).norm() < within, "{what} {}: {a} for {b}", k + 2);
    }
}

/// The table's orders above 5 (below 1e-4 here) are what the samples lack: times 3 c3 A^2 = 0.06.
#[test]
fn a_converter_bends_the_wave_of_a_bent_suspension() {
    let bent = ("suspension_asymmetry", 0, vec![3e5]);
    let table = harmonics(&predicted(std::slice::from_ref(&bent)), Channel::Reference);
    assert!(table[0].norm() > 0.05, "{table:?}");
    let cubic_per_v2 = 0.25;
    let found = predicted(&[bent, ("adc_cubic", 1, vec![cubic_per_v2])]);
    let peak_v = 0.02 * LEVEL_MS2 * SQRT_2;
    let mut samples = wave_in_time(peak_v, &table);
    samples
        .iter_mut()
        .for_each(|v| *v += cubic_per_v2 * v.powi(3));
    let expected = relative(&samples);
    compare(&harmonics(&found, Channel::Dut), &expected, 5e-6, "dut");
    compare(&harmonics(&found, Channel::Reference), &table, 1e-9, "ref");
    let gain = phasor(&samples, 1) / peak_v;
    assert!((found.value[Observable::Ratio] - (2.0 * gain.norm()).ln()).abs() < 5e-6);
    assert!((found.value[Observable::RatioPhase] - gain.arg()).abs() < 5e-6);
}

/// A kink of samples errs by (pi/N)^2, 4e-8; orders above 15 carry 1e-3 of the wave
/// into 2 c2 A = 0.06 of it and are turned by the filter: 2e-5 as a bound.
#[test]
fn what_a_loose_mount_cuts_passes_the_filter_and_then_the_converter() {
    let (threshold_ms2, corner_hz, second_per_v) = (12.0, 150.0, 0.1);
    let found = predicted(&[
        ("loose_mount", 0, vec![threshold_ms2, 1e-9]),
        ("dut_lowpass_1", 0, vec![corner_hz]),
        ("adc_quadratic", 1, vec![second_per_v]),
    ]);
    let filter = |n: usize| Complex64::new(1.0, 20.0 * n as f64 / corner_hz).inv();
    let mut cut = wave_in_time(LEVEL_MS2 * SQRT_2, &[Complex64::ZERO; 4]);
    cut.iter_mut().for_each(|a| *a = a.max(-threshold_ms2));
    // All orders to 400: the last is 1e-5 of the first behind the filter.
    let orders: Vec<Complex64> = (0..400)
        .map(|n| {
            if n == 0 {
                Complex64::ZERO
            } else {
                0.02 * phasor(&cut, n) * filter(n)
            }
        })
        .collect();
    let at = |i: usize| -> f64 {
        let turned = |(n, c): (usize, &Complex64)| {
            (c * Complex64::from_polar(1.0, TAU * ((n * i) % SAMPLES) as f64 / SAMPLES as f64)).re
        };
        orders.iter().enumerate().map(turned).sum()
    };
    let shown: Vec<f64> = (0..SAMPLES)
        .map(|i| at(i) + second_per_v * at(i).powi(2))
        .collect();
    compare(
        &harmonics(&found, Channel::Dut),
        &relative(&shown),
        2e-5,
        "dut",
    );
    let gain = phasor(&shown, 1) / (0.02 * LEVEL_MS2 * SQRT_2);
    assert!((found.value[Observable::Ratio] - (2.0 * gain.norm()).ln()).abs() < 2e-5);
    assert!((found.value[Observable::RatioPhase] - gain.arg()).abs() < 2e-5);
}

/// The level is what the reference shows: the table moves more where the channel saturates.
#[test]
fn the_level_is_held_by_what_a_saturating_reference_shows_of_a_bent_wave() {
    let bent = ("suspension_asymmetry", 0, vec![3e5]);
    let threshold_v = 0.138;
    let found = predicted(&[bent, ("adc_clipping", 0, vec![threshold_v])]);
    // The ratio tells how much more: the device shows all of it.
    let more = (found.value[Observable::Ratio]).exp() / 2.0;
    let table = harmonics(&found, Channel::Dut);
    let mut samples = wave_in_time(0.01 * LEVEL_MS2 * SQRT_2 * more, &table);
    samples
        .iter_mut()
        .for_each(|v| *v = v.clamp(-threshold_v, threshold_v));
    let shown_v = phasor(&samples, 1).norm();
    let held_v = 0.01 * LEVEL_MS2 * SQRT_2;
    // Orders above 5 of the table are missing in the samples: 1e-4 of the wave, where it is cut.
    assert!((shown_v / held_v - 1.0).abs() < 2e-5, "{shown_v} {held_v}");
    assert!(more > 1.005, "{more}");
    compare(
        &harmonics(&found, Channel::Reference),
        &relative(&samples),
        5e-5,
        "ref",
    );
    assert!(found.value[Observable::Drive].is_finite());
}

/// Dry friction alone: order n of its square wave moves the mass against spring, damping and what the
/// voltage source brakes; a filter takes its part of each order. Four orders stand for all above 15:
/// they are right to 3 % behind this filter.
#[test]
fn a_filter_takes_its_part_of_the_orders_above_five() {
    let (friction_n, corner_hz) = (0.02, 600.0);
    let friction = ("coulomb_friction", 0, vec![friction_n]);
    let found = predicted(&[friction, ("dut_lowpass_1", 0, vec![corner_hz])]);
    let orders = (7..2000).step_by(2).map(|n| {
        let frequency_hz = 20.0 * f64::from(n);
        let omega = TAU * frequency_hz;
        let brake = 7.0 * 7.0 / Complex64::new(4.0, omega * 1.2e-4) + 3.0;
        let stiff = 8000.0 - 0.09 * omega * omega + Complex64::i() * omega * brake;
        let force_n = 4.0 * friction_n / (std::f64::consts::PI * f64::from(n));
        let square = (force_n * omega * omega / stiff).norm_sqr();
        [square, square / (1.0 + (frequency_hz / corner_hz).powi(2))]
    });
    let sums = orders.fold([0.0; 2], |sum, pair| [sum[0] + pair[0], sum[1] + pair[1]]);
    let [plain, filtered] = sums.map(|sum| 0.5 * sum);
    let expected = [0.01 * 0.01 * plain, 0.02 * 0.02 * filtered];
    assert!(filtered < 0.8 * plain, "the filter shows");
    for (found, expected) in found.remainder_v2.iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 0.03, "{found} {expected}");
    }
}

/// The device's gain is that of the acceleration it feels, not of the table's: a kink of samples errs
/// by (pi/N)^2, 4e-8.
#[test]
fn a_gain_by_level_is_that_of_what_a_loose_mount_lets_through() {
    let (threshold_ms2, per_ms2) = (12.0, 1e-2);
    let found = predicted(&[
        ("loose_mount", 0, vec![threshold_ms2, 1e-9]),
        ("dut_level_nonlinearity", 0, vec![per_ms2]),
    ]);
    let mut cut = wave_in_time(LEVEL_MS2 * SQRT_2, &[Complex64::ZERO; 4]);
    cut.iter_mut().for_each(|a| *a = a.max(-threshold_ms2));
    let share = phasor(&cut, 1).norm() / (LEVEL_MS2 * SQRT_2);
    assert!(share < 0.99, "{share}");
    let expected = 2.0 * share * (1.0 + per_ms2 * LEVEL_MS2 * share);
    assert!((found.value[Observable::Ratio] - expected.ln()).abs() < 1e-6);
}
