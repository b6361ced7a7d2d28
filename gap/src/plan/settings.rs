//! Settings of the generator, and of what takes other hands, that a rig can hold.

use crate::calibrator::problem::Problem;
use crate::dataset::{Point, Rig};
use crate::thresholds;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Frequencies times one change of condition at a time, each with its effort.
pub(super) fn settings(rig: &Rig, points: &[Point], measured: &Problem) -> Vec<(Point, f64)> {
    let facts = &measured.facts;
    let conditions = conditions(rig, points, facts.longest_s.max(0.0));
    let highest_hz = rig
        .digitiser
        .sample_rate_hz
        .map_or(1.0, |rate| thresholds::BELOW_NYQUIST * rate);
    let highest_hz = highest_hz.min(2.0 * facts.highest_hz).max(facts.highest_hz);
    let mut list = Vec::new();
    for frequency_hz in frequencies(facts.lowest_hz, highest_hz) {
        let largest_ms2 =
            facts.largest_travel_m * thresholds::BEYOND_SEEN * (TAU * frequency_hz).powi(2);
        for (point, effort) in &conditions {
            let mut point = Point {
                frequency_hz,
                ..point.clone()
            };
            if largest_ms2.is_finite() && largest_ms2 > 0.0 {
                point.acceleration_ms2 = point.acceleration_ms2.map(|a| a.min(largest_ms2));
            }
            list.push((point, *effort));
        }
    }
    list
}

/// The usual conditions, then those that differ from them in one respect; without a frequency.
fn conditions(rig: &Rig, points: &[Point], now_s: f64) -> Vec<(Point, f64)> {
    let warm_c = rig.environment.reference_temperature_c.unwrap_or(23.0);
    let levels = stated(points, |p| p.acceleration_ms2);
    let level = |index: usize| {
        let at = levels.len().saturating_sub(1) * index / 2;
        levels.get(at).copied().unwrap_or(10.0)
    };
    let payloads = stated(points, |p| p.payload_kg);
    let usual = Point {
        run: 0,
        time_s: Some(now_s),
        temperature_c: Some(warm_c),
        rotation_rad: Some(0.0),
        tilt_rad: Some(0.0),
        payload_kg: Some(payloads.get(payloads.len() / 2).copied().unwrap_or(0.04)),
        acceleration_ms2: Some(level(1)),
        ..Point::default()
    };
    let mut list = Vec::new();
    let mut add = |effort: f64, change: &dyn Fn(&mut Point)| {
        let mut point = usual.clone();
        change(&mut point);
        list.push((point, effort));
    };
    add(1.0, &|_| {});
    add(1.0, &|p| p.acceleration_ms2 = Some(level(0)));
    add(1.0, &|p| p.acceleration_ms2 = Some(level(2)));
    for quarter in 1..4 {
        add(thresholds::EFFORT_OF_HANDS, &|p| {
            p.rotation_rad = Some(f64::from(quarter) * FRAC_PI_2);
        });
    }
    add(thresholds::EFFORT_OF_HANDS, &|p| {
        p.tilt_rad = Some(FRAC_PI_2)
    });
    for payload_kg in [0.02, 0.1] {
        add(thresholds::EFFORT_OF_HANDS, &|p| {
            p.payload_kg = Some(payload_kg)
        });
    }
    for warmer_k in [-8.0, 10.0] {
        add(thresholds::EFFORT_OF_HANDS, &|p| {
            p.temperature_c = Some(warm_c + warmer_k)
        });
    }
    add(thresholds::EFFORT_OF_HANDS, &|p| {
        p.time_s = Some(now_s + thresholds::LATER_S)
    });
    list
}

/// Values of a condition that the dataset states, each once, ascending.
fn stated(points: &[Point], value: fn(&Point) -> Option<f64>) -> Vec<f64> {
    let mut all: Vec<f64> = points.iter().filter_map(value).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// Preferred frequencies of one-third octaves within the range.
fn frequencies(lowest_hz: f64, highest_hz: f64) -> Vec<f64> {
    let first = (thresholds::POINTS_PER_DECADE * lowest_hz.log10()).round() as i32;
    let last = (thresholds::POINTS_PER_DECADE * highest_hz.log10()).round() as i32;
    (first..=last)
        .map(|n| 10.0_f64.powf(f64::from(n) / thresholds::POINTS_PER_DECADE))
        .map(|f| f.clamp(lowest_hz, highest_hz))
        .collect()
}
