//! Points the rig can hold, what would be measured there, and a chosen one in words.

use super::duel::Duel;
use crate::calibrator::evaluate::Memories;
use crate::calibrator::problem::Problem;
use crate::dataset::{Harmonic, Point, Rig};
use crate::observable::{Observable, Table};
use crate::thresholds;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::{FRAC_PI_2, TAU};

/// One point that could be measured.
pub(super) struct Proposal {
    /// Row of [`Proposals::problem`].
    pub(super) row: usize,
    /// Whether each observable would be measured.
    pub(super) known: Table<bool>,
    extra: bool,
    /// Relative cost.
    pub(super) effort: f64,
}

/// All points that could be measured, in one new run.
pub(super) struct Proposals {
    /// The points as a problem with all columns.
    pub(super) problem: Problem,
    pub(super) list: Vec<Proposal>,
    points: Vec<Point>,
    reference_temperature_c: f64,
    levels_known: bool,
}

impl Proposals {
    pub(super) fn new(rig: &Rig, points: &[Point], measured: &Problem, all_columns: bool) -> Self {
        let mut efforts = Vec::new();
        let mut grid = Vec::new();
        for (point, effort) in settings(rig, points, measured) {
            grid.push(with_columns(point, rig, points));
            efforts.push(effort);
        }
        let nominal = Problem::new(rig, &grid);
        let kept = set_voltages(&nominal, &mut grid, largest_coil_v(points));
        let keep = |list: Vec<f64>| -> Vec<f64> {
            list.iter()
                .zip(&kept)
                .filter(|k| *k.1)
                .map(|k| *k.0)
                .collect()
        };
        let efforts = keep(efforts);
        let mut at = kept.iter();
        grid.retain(|_| *at.next().unwrap_or(&false));
        let problem = Problem::new(rig, &grid);
        let all = Table::from_fn(|o| !problem.data_of(o).is_empty());
        let now = Table::from_fn(|o| !measured.data_of(o).is_empty());
        let base = if all_columns { all } else { now };
        let mut list = Vec::new();
        for (row, effort) in efforts.into_iter().enumerate() {
            for (known, extra) in [(base, false), (all, true)] {
                let cost = if extra {
                    thresholds::EFFORT_OF_SENSORS
                } else {
                    1.0
                };
                if !extra || all != base {
                    list.push(Proposal {
                        row,
                        known,
                        extra,
                        effort: effort * cost,
                    });
                }
            }
        }
        Self {
            problem,
            list,
            points: grid,
            reference_temperature_c: rig.environment.reference_temperature_c.unwrap_or(23.0),
            levels_known: measured.facts.level_known,
        }
    }

    /// A chosen point in words.
    pub(super) fn describe(
        &self,
        proposal: &Proposal,
        look_at: &'static str,
        duel: &Duel,
    ) -> Measurement {
        let point = &self.points[proposal.row];
        let extra: &[&'static str] = if proposal.extra {
            &["coil_v", "coil_a", "harmonics"]
        } else {
            &[]
        };
        Measurement {
            frequency_hz: point.frequency_hz,
            acceleration_ms2: point.acceleration_ms2.filter(|_| self.levels_known),
            rotation_deg: point.rotation_rad.unwrap_or(0.0).to_degrees().round(),
            tilt_deg: point.tilt_rad.unwrap_or(0.0).to_degrees().round(),
            payload_kg: point.payload_kg.unwrap_or(0.0),
            temperature_c: point.temperature_c.unwrap_or(self.reference_temperature_c),
            time_s: point.time_s.unwrap_or(0.0),
            extra_columns: extra.to_vec(),
            look_at,
            separates: [duel.truth.clone(), duel.rival.clone()],
            sigma: duel.sigma(),
        }
    }
}

/// Uncertainties as the dataset states them, else those of a good instrument.
fn with_columns(mut point: Point, rig: &Rig, points: &[Point]) -> Point {
    let median = |value: fn(&Point) -> Option<f64>, usual: f64| {
        let mut all: Vec<f64> = points.iter().filter_map(value).collect();
        all.sort_by(f64::total_cmp);
        Some(all.get(all.len() / 2).copied().unwrap_or(usual))
    };
    point.u_ratio = median(|p| p.u_ratio, 2e-4);
    point.u_phase_rad = median(|p| p.u_phase_rad, 0.02_f64.to_radians());
    point.u_drive = median(|p| p.u_drive, 5e-4);
    point.u_current = median(|p| p.u_current, 5e-4);
    point.u_harmonic = median(|p| p.u_harmonic, 5e-5);
    point.u_dc_v = median(|p| p.u_dc_v, 2e-5);
    let s1 = rig.reference.and_then(|t| t.sensitivity_v_per_ms2);
    let reference_v = s1.map_or(0.01, |q| q.value) * point.acceleration_ms2.unwrap_or(10.0);
    point.ratio = Some(1.0);
    point.dut_rad = Some(0.0);
    point.ref_v = Some(reference_v);
    point.ref_rad = Some(0.0);
    point.coil_v = Some(1.0);
    point.coil_a = Some(1.0);
    point.coil_a_rad = Some(0.0);
    let silent = Some(Harmonic {
        amplitude: 0.0,
        phase_rad: Some(0.0),
    });
    point.ref_harmonics = [silent; 4];
    point.dut_harmonics = [silent; 4];
    (point.ref_dc_v, point.dut_dc_v) = (Some(0.0), Some(0.0));
    (point.ref_noise_v, point.dut_noise_v) = (Some(1e-4), Some(1e-4));
    point
}

fn largest_coil_v(points: &[Point]) -> f64 {
    let known = points.iter().filter_map(|p| p.coil_v);
    let largest = known.fold(0.0_f64, f64::max);
    if largest > 0.0 {
        thresholds::BEYOND_SEEN * largest
    } else {
        f64::INFINITY
    }
}

/// Gives each point the coil voltage its level needs; false where the rig cannot hold it.
fn set_voltages(nominal: &Problem, grid: &mut [Point], largest_v: f64) -> Vec<bool> {
    let mut kept = vec![true; grid.len()];
    if nominal.data_of(Observable::Drive).is_empty() {
        return kept;
    }
    let theta = vec![0.0; nominal.free.len()];
    let memory = nominal.memory();
    nominal.predictions(&[], &theta, Memories::Look(&memory), |index, prediction| {
        let point = &mut grid[index];
        let volt = point.ref_v.unwrap_or(0.1) / prediction.value[Observable::Drive].exp();
        point.coil_v = Some(volt);
        kept[index] = volt <= largest_v;
    });
    kept
}

/// A point that is worth measuring.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Measurement {
    /// Excitation frequency.
    pub frequency_hz: f64,
    /// Level, r.m.s.; null where levels were never stated.
    #[serde(rename = "set_acceleration_rms_ms2")]
    pub acceleration_ms2: Option<f64>,
    /// Rotation of the device under test.
    pub rotation_deg: f64,
    /// Angle between the axis of motion and the vertical.
    pub tilt_deg: f64,
    /// Mass on the armature.
    pub payload_kg: f64,
    /// Transducer temperature.
    pub temperature_c: f64,
    /// Since the first point.
    pub time_s: f64,
    /// Columns beyond those of the dataset; `harmonics` stands for all of both channels.
    pub extra_columns: Vec<&'static str>,
    /// Observable in which the pair it helps most differs most.
    pub look_at: &'static str,
    /// The pair it helps most.
    pub separates: [Vec<&'static str>; 2],
    /// Separation of that pair after it.
    pub sigma: f64,
}

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
