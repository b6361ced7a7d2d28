//! Points the rig can hold, and what would be measured there.

use super::Measurement;
use super::duel::Duel;
use crate::dataset::{Harmonic, Point, Rig};
use crate::engine::evaluation::Memories;
use crate::engine::problem::Problem;
use crate::model::row::{CURRENT, DC, DRIVE, NOISE, RATIO, REF_HARMONICS, SLOTS};

/// Points in one-third octaves.
const PER_DECADE: f64 = 10.0;
/// Highest frequency over sample rate that is proposed: what anti-aliasing filters usually pass.
const BELOW_NYQUIST: f64 = 0.39;
/// Travel and coil voltage beyond what the dataset has seen.
const BEYOND: f64 = 1.1;
/// Effort of a point that needs other hands than those on the generator.
const DEAR: f64 = 1.5;
/// Effort of a point with sensors the dataset does not have.
const DEARER: f64 = 2.0;

/// One point that could be measured.
pub(super) struct Candidate {
    /// Row of [`Candidates::problem`].
    pub(super) row: usize,
    /// Slots that would be measured.
    pub(super) slots: [bool; SLOTS],
    extra: bool,
    /// Relative cost.
    pub(super) effort: f64,
}

/// All points that could be measured, in one new run.
pub(super) struct Candidates {
    /// The points as a problem with all columns.
    pub(super) problem: Problem,
    pub(super) list: Vec<Candidate>,
    points: Vec<Point>,
    reference_temperature_c: f64,
    levels_known: bool,
}

impl Candidates {
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
        let all: [bool; SLOTS] = std::array::from_fn(|s| !problem.slots[s].is_empty());
        let known: [bool; SLOTS] = std::array::from_fn(|s| !measured.slots[s].is_empty());
        let base = if all_columns { all } else { known };
        let mut list = Vec::new();
        for (row, effort) in efforts.into_iter().enumerate() {
            for (slots, extra) in [(base, false), (all, true)] {
                let cost = if extra { DEARER } else { 1.0 };
                if !extra || all != base {
                    list.push(Candidate {
                        row,
                        slots,
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
        candidate: &Candidate,
        look_at: &'static str,
        duel: &Duel,
    ) -> Measurement {
        let point = &self.points[candidate.row];
        let extra: &[&'static str] = if candidate.extra {
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

/// Frequencies times one change of condition at a time, each with its effort.
fn settings(rig: &Rig, points: &[Point], measured: &Problem) -> Vec<(Point, f64)> {
    let facts = &measured.facts;
    let warm_c = rig.environment.reference_temperature_c.unwrap_or(23.0);
    let of = |value: fn(&Point) -> Option<f64>| -> Vec<f64> {
        let mut all: Vec<f64> = points.iter().filter_map(value).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    };
    let level = |index: usize| {
        let all = of(|p| p.acceleration_ms2);
        let at = all.len().saturating_sub(1) * index / 2;
        all.get(at).copied().unwrap_or(10.0)
    };
    let payloads = of(|p| p.payload_kg);
    let usual = Point {
        run: 0,
        time_s: Some(facts.longest_s.max(0.0)),
        temperature_c: Some(warm_c),
        rotation_rad: Some(0.0),
        tilt_rad: Some(0.0),
        payload_kg: Some(payloads.get(payloads.len() / 2).copied().unwrap_or(0.04)),
        acceleration_ms2: Some(level(1)),
        ..Point::default()
    };
    let mut list = Vec::new();
    let highest_hz = rig
        .digitiser
        .sample_rate_hz
        .map_or(1.0, |rate| BELOW_NYQUIST * rate);
    let highest_hz = highest_hz.min(2.0 * facts.highest_hz).max(facts.highest_hz);
    for frequency_hz in frequencies(facts.lowest_hz, highest_hz) {
        let largest =
            facts.largest_travel_m * BEYOND * (std::f64::consts::TAU * frequency_hz).powi(2);
        let mut add = |effort: f64, change: &dyn Fn(&mut Point)| {
            let mut point = Point {
                frequency_hz,
                ..usual.clone()
            };
            change(&mut point);
            if largest.is_finite() && largest > 0.0 {
                point.acceleration_ms2 = point.acceleration_ms2.map(|a| a.min(largest));
            }
            list.push((point, effort));
        };
        add(1.0, &|_| {});
        add(1.0, &|p| p.acceleration_ms2 = Some(level(0)));
        add(1.0, &|p| p.acceleration_ms2 = Some(level(2)));
        for quarter in 1..4 {
            let angle = f64::from(quarter) * std::f64::consts::FRAC_PI_2;
            add(DEAR, &|p| p.rotation_rad = Some(angle));
        }
        add(DEAR, &|p| p.tilt_rad = Some(std::f64::consts::FRAC_PI_2));
        for payload_kg in [0.02, 0.1] {
            add(DEAR, &|p| p.payload_kg = Some(payload_kg));
        }
        for warmer_k in [-8.0, 10.0] {
            add(DEAR, &|p| p.temperature_c = Some(warm_c + warmer_k));
        }
        add(DEAR, &|p| {
            p.time_s = Some(facts.longest_s.max(0.0) + 7200.0)
        });
    }
    list
}

fn frequencies(lowest_hz: f64, highest_hz: f64) -> Vec<f64> {
    let first = (PER_DECADE * lowest_hz.log10()).round() as i32;
    let last = (PER_DECADE * highest_hz.log10()).round() as i32;
    (first..=last)
        .map(|n| 10.0_f64.powf(f64::from(n) / PER_DECADE))
        .map(|f| f.clamp(lowest_hz, highest_hz))
        .collect()
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
        BEYOND * largest
    } else {
        f64::INFINITY
    }
}

/// Gives each point the coil voltage its level needs; false where the rig cannot hold it.
fn set_voltages(nominal: &Problem, grid: &mut [Point], largest_v: f64) -> Vec<bool> {
    let mut kept = vec![true; grid.len()];
    if nominal.slots[DRIVE].is_empty() {
        return kept;
    }
    let theta = vec![0.0; nominal.free.len()];
    let memory = nominal.memory();
    nominal.predictions(&[], &theta, Memories::Look(&memory), |index, prediction| {
        let point = &mut grid[index];
        let volt = point.ref_v.unwrap_or(0.1) / prediction.value[DRIVE].exp();
        point.coil_v = Some(volt);
        kept[index] = volt <= largest_v;
    });
    kept
}

/// Observable of a slot.
pub(super) fn observable(slot: usize) -> &'static str {
    match slot {
        RATIO => "ratio",
        1 => "phase of the ratio",
        DRIVE => "drive",
        3 => "phase of the drive",
        CURRENT => "coil current",
        5 => "phase of the coil current",
        REF_HARMONICS..14 => "harmonics of the reference",
        14..DC => "harmonics of the device under test",
        DC..NOISE => "d.c.",
        _ => "noise",
    }
}
