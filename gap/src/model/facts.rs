//! Facts about a dataset: which effects it can show at all.

use super::row::Row;
use crate::dataset::ExciterParameters;
use crate::observable::{Channel, Group, Observable};
use crate::thresholds;
use std::f64::consts::SQRT_2;

/// Observables and ranges of a dataset.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Facts {
    pub(crate) ratio: bool,
    pub(crate) ratio_phase: bool,
    pub(crate) drive: bool,
    /// Of the drive, its modulus: what a gain shows in.
    pub(crate) drive_modulus: bool,
    pub(crate) current: bool,
    pub(crate) ref_harmonics: bool,
    pub(crate) dut_harmonics: bool,
    pub(crate) ref_dc: bool,
    pub(crate) dut_dc: bool,
    pub(crate) ref_noise: bool,
    pub(crate) dut_noise: bool,
    pub(crate) rotation_varies: bool,
    pub(crate) temperature_varies: bool,
    pub(crate) payload_stated: bool,
    pub(crate) payload_varies: bool,
    pub(crate) level_known: bool,
    pub(crate) level_varies: bool,
    pub(crate) lowest_hz: f64,
    pub(crate) highest_hz: f64,
    pub(crate) longest_s: f64,
    pub(crate) largest_payload_kg: f64,
    pub(crate) largest_level_ms2: f64,
    pub(crate) largest_travel_m: f64,
    pub(crate) largest_peak_v: [f64; 2],
    pub(crate) smallest_peak_v: [f64; 2],
    /// Peak voltages of each channel between which no row lies, a range of the input apart or more.
    pub(crate) between_v: [Vec<f64>; 2],
    pub(crate) frequencies_hz: Vec<f64>,
    pub(crate) warmest_k: f64,
    pub(crate) noise_v: f64,
    /// Noise of each channel beyond the healthy one, r.m.s., in the median row; 0 where it was not measured.
    pub(crate) excess_noise_v: [f64; 2],
    /// Excess noise over the rate of change of the channel's voltage: a scatter of the sampling instants, in s.
    pub(crate) excess_noise_s: f64,
    /// Level over peak voltage of reference and device under test, in (m/s2)/V r.m.s.
    pub(crate) ms2_per_v: [f64; 2],
    pub(crate) tilt_varies: bool,
    pub(crate) block_known: bool,
    pub(crate) exciter_known: bool,
    pub(crate) mass_kg: f64,
    pub(crate) stiffness_n_per_m: f64,
    pub(crate) damping_ns_per_m: f64,
    pub(crate) largest_coil_peak_v: f64,
}

fn span(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
            (a.min(v), b.max(v))
        })
}

/// Noise of a channel in a row beyond the healthy one, in V.
fn excess_v(row: &Row, channel: Channel, healthy_v: f64) -> Option<f64> {
    let noise = Observable::noise(channel);
    let power_v2 = (2.0 * row.value[noise]).exp() - healthy_v * healthy_v;
    let counts = power_v2 > thresholds::NOISE_EXCESS * healthy_v * healthy_v;
    row.u[noise]
        .is_finite()
        .then_some(if counts { power_v2.sqrt() } else { 0.0 })
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = values.filter(|v| v.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

/// Sensitivity of the device over its nominal one: that is 5 % off easily, and a
/// threshold just below the largest output lies above the nominal one then.
fn dut_gain(rows: &[Row]) -> f64 {
    let measured = rows.iter().filter(|r| r.u[Observable::Ratio].is_finite());
    let of_row = |r: &Row| r.value[Observable::Ratio].exp() * r.ref_peak_v / r.dut_peak_v;
    let gains: Vec<f64> = measured.map(of_row).filter(|g| g.is_finite()).collect();
    if gains.is_empty() {
        return 1.0;
    }
    median(gains.into_iter())
}

/// Noise of a channel beyond the healthy one in the median row, in V.
fn excess_noise_v(rows: &[Row], channel: Channel, healthy_v: f64) -> f64 {
    let excess = rows.iter();
    median(excess.filter_map(|row| excess_v(row, channel, healthy_v)))
}

/// Excess noise of the reference over the rate of change of its voltage, in s.
fn excess_noise_s(rows: &[Row], healthy_v: f64) -> f64 {
    let scatter_s = rows.iter().filter_map(|row| {
        let rate_v_per_s = row.omega * row.ref_peak_v / std::f64::consts::SQRT_2;
        let scatter = excess_v(row, Channel::Reference, healthy_v)? / rate_v_per_s;
        (scatter > 0.0).then_some(scatter)
    });
    median(scatter_s)
}

/// Places between voltages that are kept, those of the widest gaps.
const MOST_PLACES: usize = 16;

/// Middles of the gaps between the peak voltages of a channel.
fn between_v(rows: &[Row], channel: Channel) -> Vec<f64> {
    let peaks = rows.iter().map(|row| row.seen_v[channel as usize] * SQRT_2);
    let mut peaks_v: Vec<f64> = peaks.filter(|v| *v > 0.0).collect();
    peaks_v.sort_by(f64::total_cmp);
    let gaps = peaks_v.windows(2).map(|pair| (pair[1] / pair[0], pair[0]));
    let mut gaps: Vec<(f64, f64)> = gaps
        .filter(|(ratio, _)| *ratio > thresholds::APART)
        .collect();
    gaps.sort_by(|a, b| b.0.total_cmp(&a.0));
    gaps.truncate(MOST_PLACES);
    gaps.iter()
        .map(|(ratio, below)| below * ratio.sqrt())
        .collect()
}

/// Frequencies of the rows, each once, ascending.
fn frequencies_hz(rows: &[Row]) -> Vec<f64> {
    let mut frequencies_hz: Vec<f64> = rows.iter().map(|r| r.frequency_hz).collect();
    frequencies_hz.sort_by(f64::total_cmp);
    frequencies_hz.dedup();
    frequencies_hz
}

impl Facts {
    /// Collects the facts of prepared rows.
    pub(crate) fn new(rows: &[Row], exciter: Option<ExciterParameters<f64>>, noise_v: f64) -> Self {
        let any = |observable| rows.iter().any(|r| r.u[observable].is_finite());
        let any_of = |group: Group| group.observables().any(any);
        let over = |value: fn(&Row) -> f64| span(rows.iter().map(value));
        let varies = |value: fn(&Row) -> f64, by: f64| {
            let (low, high) = over(value);
            high - low > by
        };
        let (lowest_hz, highest_hz) = over(|r| r.frequency_hz);
        let (lowest_ms2, highest_ms2) = over(|r| r.level_ms2);
        let reference_v = over(|r| r.ref_peak_v);
        let gain = dut_gain(rows);
        let dut_v = span(rows.iter().map(|r| gain * r.dut_peak_v));
        let of_exciter = |value: fn(ExciterParameters<f64>) -> f64| exciter.map_or(f64::NAN, value);
        Self {
            ratio: any(Observable::Ratio),
            ratio_phase: any(Observable::RatioPhase),
            drive: any_of(Group::Drive),
            drive_modulus: any(Observable::Drive),
            current: any_of(Group::Current),
            ref_harmonics: any_of(Group::RefHarmonics),
            dut_harmonics: any_of(Group::DutHarmonics),
            ref_dc: any(Observable::RefDc),
            dut_dc: any(Observable::DutDc),
            ref_noise: any(Observable::RefNoise),
            dut_noise: any(Observable::DutNoise),
            rotation_varies: varies(|r| r.rotation.0, thresholds::VARIES)
                || varies(|r| r.rotation.1, thresholds::VARIES),
            temperature_varies: varies(|r| r.warmer_k, thresholds::VARIES),
            payload_stated: rows.iter().any(|r| r.payload_stated),
            payload_varies: varies(|r| r.payload_kg, 1e-4),
            level_known: highest_ms2 > 0.0,
            level_varies: highest_ms2 > thresholds::LEVELS_VARY * lowest_ms2,
            lowest_hz,
            highest_hz,
            longest_s: over(|r| r.time_s).1,
            largest_payload_kg: over(|r| r.payload_kg).1,
            largest_level_ms2: highest_ms2,
            largest_travel_m: over(Row::travel_m).1,
            largest_peak_v: [reference_v.1, dut_v.1],
            smallest_peak_v: [reference_v.0, dut_v.0],
            between_v: Channel::BOTH.map(|channel| between_v(rows, channel)),
            frequencies_hz: frequencies_hz(rows),
            warmest_k: over(|r| r.warmer_k.abs()).1,
            noise_v,
            excess_noise_v: Channel::BOTH.map(|channel| excess_noise_v(rows, channel, noise_v)),
            excess_noise_s: excess_noise_s(rows, noise_v),
            ms2_per_v: [highest_ms2 / reference_v.1, highest_ms2 / dut_v.1],
            tilt_varies: varies(|r| r.vertical, thresholds::VARIES),
            block_known: rows.iter().any(|r| r.bin_hz.is_finite()),
            exciter_known: exciter.is_some(),
            mass_kg: of_exciter(|e| e.moving_mass_kg),
            stiffness_n_per_m: of_exciter(|e| e.stiffness_n_per_m),
            damping_ns_per_m: of_exciter(|e| e.damping_ns_per_m),
            largest_coil_peak_v: over(|r| r.coil_peak_v).1,
        }
    }
}
