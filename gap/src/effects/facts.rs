//! What a dataset can show at all.

use crate::model::row::{CURRENT, DC, DRIVE, DUT_HARMONICS, NOISE, RATIO, REF_HARMONICS, Row};

/// Observables and ranges of a dataset.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Facts {
    pub(crate) ratio: bool,
    pub(crate) ratio_phase: bool,
    pub(crate) drive: bool,
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
    pub(crate) frequencies_hz: Vec<f64>,
    pub(crate) warmest_k: f64,
    pub(crate) noise_v: f64,
    /// Noise of each channel beyond the healthy one, r.m.s., in the median row; 0 where it was not measured.
    pub(crate) excess_noise_v: [f64; 2],
    /// The same over the rate of change of the channel's voltage: a scatter of the sampling instants, in s.
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
fn excess_v(row: &Row, channel: usize, healthy_v: f64) -> Option<f64> {
    let slot = NOISE + channel;
    let power_v2 = (2.0 * row.value[slot]).exp() - healthy_v * healthy_v;
    // Scatter of 1 % about the healthy noise is no excess.
    let counts = power_v2 > 0.05 * healthy_v * healthy_v;
    row.u[slot]
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
    let measured = rows.iter().filter(|r| r.u[RATIO].is_finite());
    let of_row = |r: &Row| r.value[RATIO].exp() * r.ref_peak_v / r.dut_peak_v;
    let gains: Vec<f64> = measured.map(of_row).filter(|g| g.is_finite()).collect();
    if gains.is_empty() {
        return 1.0;
    }
    median(gains.into_iter())
}

impl Facts {
    /// Collects the facts of prepared rows.
    pub(crate) fn new(rows: &[Row], exciter: Option<[f64; 6]>, noise_v: f64) -> Self {
        let any = |from: usize, to: usize| {
            rows.iter()
                .any(|r| r.u[from..to].iter().any(|u| u.is_finite()))
        };
        let (lowest_hz, highest_hz) = span(rows.iter().map(|r| r.frequency_hz));
        let level = span(rows.iter().map(|r| r.level_ms2));
        let reference = span(rows.iter().map(|r| r.ref_peak_v));
        let gain = dut_gain(rows);
        let dut = span(rows.iter().map(|r| gain * r.dut_peak_v));
        let varies = |(low, high): (f64, f64), by: f64| high - low > by;
        let mut frequencies_hz: Vec<f64> = rows.iter().map(|r| r.frequency_hz).collect();
        frequencies_hz.sort_by(f64::total_cmp);
        frequencies_hz.dedup();
        Self {
            ratio: any(RATIO, RATIO + 1),
            ratio_phase: any(RATIO + 1, RATIO + 2),
            drive: any(DRIVE, DRIVE + 2),
            current: any(CURRENT, CURRENT + 2),
            ref_harmonics: any(REF_HARMONICS, DUT_HARMONICS),
            dut_harmonics: any(DUT_HARMONICS, DC),
            ref_dc: any(DC, DC + 1),
            dut_dc: any(DC + 1, DC + 2),
            ref_noise: any(NOISE, NOISE + 1),
            dut_noise: any(NOISE + 1, NOISE + 2),
            rotation_varies: varies(span(rows.iter().map(|r| r.rotation.0)), 0.05)
                || varies(span(rows.iter().map(|r| r.rotation.1)), 0.05),
            temperature_varies: varies(span(rows.iter().map(|r| r.warmer_k)), 0.05),
            payload_stated: rows.iter().any(|r| r.payload_stated),
            payload_varies: varies(span(rows.iter().map(|r| r.payload_kg)), 1e-4),
            level_known: level.1 > 0.0,
            level_varies: level.1 > 1.2 * level.0,
            lowest_hz,
            highest_hz,
            longest_s: span(rows.iter().map(|r| r.time_s)).1,
            largest_payload_kg: span(rows.iter().map(|r| r.payload_kg)).1,
            largest_level_ms2: level.1,
            largest_travel_m: span(rows.iter().map(|r| r.level_ms2 / (r.omega * r.omega))).1,
            largest_peak_v: [reference.1, dut.1],
            smallest_peak_v: [reference.0, dut.0],
            frequencies_hz,
            warmest_k: span(rows.iter().map(|r| r.warmer_k.abs())).1,
            noise_v,
            excess_noise_v: [0, 1].map(|channel| {
                median(
                    rows.iter()
                        .filter_map(|row| excess_v(row, channel, noise_v)),
                )
            }),
            excess_noise_s: median(rows.iter().filter_map(|row| {
                let rate_v_per_s = row.omega * row.ref_peak_v / std::f64::consts::SQRT_2;
                let scatter = excess_v(row, 0, noise_v)? / rate_v_per_s;
                (scatter > 0.0).then_some(scatter)
            })),
            ms2_per_v: [level.1 / reference.1, level.1 / dut.1],
            tilt_varies: varies(span(rows.iter().map(|r| r.vertical)), 0.05),
            block_known: rows.iter().any(|r| r.bin_hz.is_finite()),
            exciter_known: exciter.is_some(),
            mass_kg: exciter.map_or(f64::NAN, |e| e[0]),
            stiffness_n_per_m: exciter.map_or(f64::NAN, |e| e[1]),
            damping_ns_per_m: exciter.map_or(f64::NAN, |e| e[2]),
            largest_coil_peak_v: span(rows.iter().map(|r| r.coil_peak_v)).1,
        }
    }
}
