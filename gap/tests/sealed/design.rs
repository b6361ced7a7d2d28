//! The conditions of the rows of a case.

use super::random::Random;
use std::f64::consts::TAU;

/// Conditions of one row.
#[derive(Clone, Copy)]
pub(crate) struct Condition {
    pub(crate) frequency_hz: f64,
    pub(crate) acceleration_rms_ms2: f64,
    pub(crate) run: usize,
    pub(crate) time_s: f64,
    pub(crate) temperature_c: f64,
    pub(crate) rotation_deg: f64,
    pub(crate) tilt_deg: f64,
    pub(crate) payload_kg: f64,
}

impl Condition {
    /// An ordinary row: upright, 40 g, 23 degC, as much of 10 m/s2 as the travel allows.
    fn usual(frequency_hz: f64) -> Self {
        Self {
            frequency_hz,
            acceleration_rms_ms2: within_travel(frequency_hz, 10.0),
            run: 0,
            time_s: 0.0,
            temperature_c: 23.0,
            rotation_deg: 0.0,
            tilt_deg: 0.0,
            payload_kg: 0.04,
        }
    }
}

/// The level, or what 1.2 mm r.m.s. of travel allow.
fn within_travel(frequency_hz: f64, acceleration_rms_ms2: f64) -> f64 {
    acceleration_rms_ms2.min(0.0012 * (TAU * frequency_hz).powi(2))
}

/// 5 Hz to 10 kHz in equal ratios.
fn grid(points: usize) -> impl Iterator<Item = f64> + Clone {
    (0..points).map(move |n| 5.0 * 2000.0_f64.powf(n as f64 / (points - 1) as f64))
}

/// 210 rows: four runs over frequency, four levels, six orientations.
pub(crate) fn full() -> Vec<Condition> {
    let mut rows: Vec<Condition> = runs().chain(levels()).chain(orientations()).collect();
    for (n, row) in rows.iter_mut().enumerate() {
        row.time_s = 20.0 * (n + 1) as f64;
    }
    rows
}

fn runs() -> impl Iterator<Item = Condition> {
    let warmer_c = [0.0, 4.0, -3.0, 8.0];
    let payloads_kg = [0.02, 0.04, 0.1, 0.02];
    (0..4).flat_map(move |run| {
        grid(26).map(move |frequency_hz| Condition {
            run,
            temperature_c: 23.0 + warmer_c[run],
            rotation_deg: 90.0 * run as f64,
            payload_kg: payloads_kg[run],
            ..Condition::usual(frequency_hz)
        })
    })
}

fn levels() -> impl Iterator<Item = Condition> {
    grid(26).step_by(2).flat_map(|frequency_hz| {
        [1.0, 3.0, 30.0, 60.0].map(|level_ms2| Condition {
            acceleration_rms_ms2: within_travel(frequency_hz, level_ms2),
            run: 1,
            temperature_c: 24.0,
            ..Condition::usual(frequency_hz)
        })
    })
}

fn orientations() -> impl Iterator<Item = Condition> {
    let rotation_and_tilt_deg = [
        (0.0, 90.0),
        (45.0, 0.0),
        (180.0, 0.0),
        (270.0, 45.0),
        (135.0, 0.0),
        (0.0, 0.0),
    ];
    grid(26).step_by(3).flat_map(move |frequency_hz| {
        rotation_and_tilt_deg.map(|(rotation_deg, tilt_deg)| Condition {
            run: 3,
            rotation_deg,
            tilt_deg,
            ..Condition::usual(frequency_hz)
        })
    })
}

/// A certificate: two mountings over frequency.
pub(crate) fn ratio_only(random: &mut Random) -> Vec<Condition> {
    let rows = (0..2).flat_map(|run| grid(30).map(move |frequency_hz| (run, frequency_hz)));
    let row = |(n, (run, frequency_hz)): (usize, (usize, f64))| Condition {
        run,
        time_s: 20.0 * n as f64,
        temperature_c: 23.0 + random.between(-2.0, 2.0),
        rotation_deg: 90.0 * run as f64,
        payload_kg: [0.02, 0.06][run],
        ..Condition::usual(frequency_hz)
    };
    rows.enumerate().map(row).collect()
}
