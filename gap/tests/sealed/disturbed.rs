//! Noise, and what of it falls on the frequency of a row.

use super::design::Condition;
use super::random::Random;
use super::steady::Steady;
use super::truth::Truth;
use num_complex::Complex64 as C;
use std::f64::consts::{PI, SQRT_2, TAU};

/// Length of a block, s.
const BLOCK_S: f64 = 16_384.0 / 51_200.0;
const MAINS_HZ: f64 = 50.02;

/// A row with its disturbances, before the noise of repetition.
pub(crate) struct Disturbed {
    /// Device over reference.
    pub(crate) ratio: C,
    /// Reference over coil voltage.
    pub(crate) drive: C,
    /// Coil current over coil voltage.
    pub(crate) current: C,
    /// Of reference and device, r.m.s., V.
    pub(crate) noise_rms_v: [f64; 2],
}

/// Adds what moves or hums, in a phase of its own in each row.
pub(crate) fn disturbed(
    truth: &Truth,
    row: &Condition,
    steady: &Steady,
    random: &mut Random,
) -> Disturbed {
    let drift = 1.0 + truth.or("amplifier_gain_drift.b", 0.0) * row.time_s;
    let ratio = steady.dut_v[1] / steady.reference_v[1];
    let drive = steady.reference_v[1] / steady.coil_v * drift;
    let dut_rms_v = steady.dut_v[1].norm() / SQRT_2;
    Disturbed {
        ratio: ratio * hum(truth, row, dut_rms_v, random),
        drive: drive * neighbour(truth, row, random),
        current: steady.coil_a / steady.coil_v,
        noise_rms_v: noise_rms_v(truth, row, steady),
    }
}

/// Response of a block to a tone away from its own.
fn leakage(offset_hz: f64) -> f64 {
    let x = PI * offset_hz * BLOCK_S;
    if x.abs() < 1e-9 { 1.0 } else { x.sin() / x }
}

/// Leakage of the mains and its harmonics into the device's fundamental.
fn hum(truth: &Truth, row: &Condition, dut_rms_v: f64, random: &mut Random) -> C {
    truth.factor("mains_pickup.v", |hum_rms_v| {
        let lines = [(1.0, 0.8), (2.0, 0.36), (3.0, 0.48)];
        let line = |(n, share): (f64, f64)| {
            let offset_hz = row.frequency_hz - n * MAINS_HZ;
            let size = hum_rms_v * share * leakage(offset_hz) / dut_rms_v;
            C::ONE + C::from_polar(size, TAU * random.uniform())
        };
        lines.into_iter().map(line).product::<C>()
    })
}

/// Action of a neighbouring machine on the drive, where its tone is near.
fn neighbour(truth: &Truth, row: &Condition, random: &mut Random) -> C {
    truth.factor("ambient_vibration.tone", |tone_ms2| {
        let offset_hz = row.frequency_hz - truth.or("ambient_vibration.f", 10.0);
        if (offset_hz * BLOCK_S).abs() >= 1.0 {
            return C::ONE;
        }
        let size = tone_ms2 * leakage(offset_hz) / row.acceleration_rms_ms2;
        C::ONE + C::from_polar(size, TAU * random.uniform())
    })
}

fn noise_rms_v(truth: &Truth, row: &Condition, steady: &Steady) -> [f64; 2] {
    let jitter_rad = TAU * row.frequency_hz * truth.or("sampling_jitter.s", 0.0);
    let moving_ms2 = truth
        .or("ambient_vibration.a", 0.0)
        .hypot(truth.or("ambient_vibration.tone", 0.0));
    let rattle_ms2 = truth.get("loose_mount.t").map_or(0.0, |lifts_ms2| {
        let beyond_ms2 = (row.acceleration_rms_ms2 * SQRT_2 - lifts_ms2).max(0.0);
        truth.or("loose_mount.noise", 0.0) * beyond_ms2
    });
    let hum_v = truth.or("mains_pickup.v", 0.0);
    let of = |n: usize, fundamental: C, rattle_ms2: f64, hum_v: f64| {
        let jitter_v = jitter_rad * fundamental.norm() / SQRT_2;
        let motion_v = moving_ms2.hypot(rattle_ms2) * truth.sensitivity_v_per_ms2[n];
        let parts = [truth.noise_rms_v, jitter_v, motion_v, hum_v];
        parts.iter().map(|v| v * v).sum::<f64>().sqrt()
    };
    [
        of(0, steady.reference_v[1], 0.0, 0.0),
        of(1, steady.dut_v[1], rattle_ms2, hum_v),
    ]
}
