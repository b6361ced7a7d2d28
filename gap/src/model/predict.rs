//! From nominal values and effects to every observable of a row.

use super::balance::{Balanced, Bend, Motion, ORDERS, Purpose, balance};
use super::chain::{Chain, Transfer};
use super::exciter::{Added, Exciter, Linear};
use super::row::{CURRENT, DC, DRIVE, DUT_HARMONICS, NOISE, RATIO, REF_HARMONICS, Row, SLOTS};
use crate::effects::Active;
use num_complex::Complex64;
use std::f64::consts::SQRT_2;

/// Nominal values of a rig as a fit moves them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Nominal {
    /// Mass, stiffness, damping, force factor, resistance, inductance.
    pub(crate) exciter: Option<[f64; 6]>,
    /// ln of reference sensitivity (0 if unknown), and of DUT over reference sensitivity.
    pub(crate) drive_ln: f64,
    pub(crate) ratio_ln: f64,
    /// Gain of the device under test relative to its nominal value.
    pub(crate) dut_gain: f64,
    /// Sensitivity of the reference relative to its nominal value: the level is held by it.
    pub(crate) reference_gain: f64,
    /// Noise of a healthy channel: reference, device under test, in V.
    pub(crate) noise_v: [f64; 2],
}

/// What the simulation says about one row.
#[derive(Debug, Clone)]
pub(crate) struct Prediction {
    /// Value of each slot.
    pub(crate) value: [f64; SLOTS],
    /// Variance that the effects leave open, per slot.
    pub(crate) open: [f64; SLOTS],
    /// Slopes of drive and current against the six exciter values, relative.
    pub(crate) slopes: Option<([Complex64; 6], [Complex64; 6])>,
    /// Mean square of the harmonics above 5 in each channel, in V^2.
    pub(crate) remainder_v2: [f64; 2],
    /// Share of it that is not known better.
    pub(crate) remainder_open: [f64; 2],
    /// Noise power of each channel without it, in V^2.
    pub(crate) noise_power_v2: [f64; 2],
    /// Share of the healthy noise in the noise power of each channel.
    pub(crate) noise_share: [f64; 2],
    /// The balance of a nonlinear exciter was not reached.
    pub(crate) diverged: bool,
}

/// Memory of the harmonic balance of one row between evaluations.
#[derive(Debug, Clone)]
pub(crate) struct Memory {
    motion: Motion,
    /// What was balanced last, and the result: many effects leave the exciter as it was.
    last: Option<(Exciter, Bend, f64, Balanced)>,
}

impl Default for Memory {
    fn default() -> Self {
        Self {
            motion: [Complex64::ZERO; ORDERS + 1],
            last: None,
        }
    }
}

/// How an evaluation uses the memory of a row.
pub(crate) enum Recall<'a> {
    /// Starts from it, and leaves its own solution there.
    Keep(&'a mut Memory),
    /// Starts from it and leaves it as it is: for a small step aside.
    Look(&'a Memory),
}

impl Recall<'_> {
    fn balance(self, exciter: &Exciter, bend: &Bend, omega: f64, peak_ms2: f64) -> Balanced {
        let memory = match &self {
            Self::Keep(memory) => &**memory,
            Self::Look(memory) => memory,
        };
        if let Some((e, b, level, balanced)) = &memory.last
            && (e, b, level) == (exciter, bend, &peak_ms2)
        {
            return *balanced;
        }
        let mut motion = memory.motion;
        // Only from a balance nearby is the first correction the size of the step aside.
        let purpose = match (&self, &memory.last) {
            (Self::Look(_), Some((.., near))) if near.converged => Purpose::Slope,
            _ => Purpose::Value,
        };
        let balanced = balance(exciter, bend, omega, peak_ms2, &mut motion, purpose);
        if let Self::Keep(memory) = self {
            memory.motion = motion;
            memory.last = Some((*exciter, *bend, peak_ms2, balanced));
        }
        balanced
    }
}

/// Simulates one row.
pub(crate) fn predict(
    row: &Row,
    nominal: &Nominal,
    effects: &[Active<'_>],
    memory: Recall<'_>,
) -> Prediction {
    let mut chain = Chain {
        dut_gain: nominal.dut_gain,
        ..Chain::default()
    };
    for effect in effects {
        effect.chain(row, &mut chain);
    }
    let first = transfer(row, effects, row.frequency_hz);
    let mut out = Prediction {
        value: [0.0; SLOTS],
        open: [0.0; SLOTS],
        slopes: None,
        remainder_v2: [0.0; 2],
        remainder_open: [0.0; 2],
        noise_power_v2: [0.0; 2],
        noise_share: [1.0; 2],
        diverged: false,
    };
    let reference = ReferenceInput::new(row, &chain);
    let motion = nominal.exciter.map(|values| {
        let level =
            reference.input_ms2(row) / size(first.reference * first.table) / nominal.reference_gain;
        drive(row, &values, &chain, level, memory)
    });
    let balanced = motion.as_ref().and_then(|m| m.balanced);
    let table = balanced.map_or([Complex64::ZERO; 4], |b| b.harmonics);
    let harmonics = Harmonics {
        table,
        remainder: balanced.map_or(0.0, |b| b.remainder),
        row,
        effects,
        first,
    };
    let (ref_gain, dut_gain) = channels(row, nominal, &chain, &reference, &harmonics, &mut out);
    let ratio = ln(first.dut / first.reference * dut_gain / ref_gain);
    put(&mut out, RATIO, ratio + nominal.ratio_ln);
    if let Some(motion) = motion {
        let per_v = motion.linear.acceleration_per_v
            * first.table
            * first.reference
            * first.drive
            * ref_gain;
        put(&mut out, DRIVE, ln(per_v) + nominal.drive_ln);
        put(&mut out, CURRENT, ln(motion.linear.admittance));
        out.slopes = Some((motion.linear.drive_slope, motion.linear.current_slope));
        out.diverged = motion.balanced.is_some_and(|b| !b.converged);
    }
    noise(nominal, &chain, &mut out);
    leakage(row, &chain, &mut out);
    out
}

/// Logarithm without the care for overflow that the library's takes: no value here is near it.
fn ln(value: Complex64) -> Complex64 {
    Complex64::new(0.5 * value.norm_sqr().ln(), value.im.atan2(value.re))
}

/// Size of a value, likewise.
fn size(value: Complex64) -> f64 {
    value.norm_sqr().sqrt()
}

fn put(out: &mut Prediction, slot: usize, value: Complex64) {
    out.value[slot] = value.re;
    out.value[slot + 1] = value.im;
}

fn transfer(row: &Row, effects: &[Active<'_>], frequency_hz: f64) -> Transfer {
    let mut transfer = Transfer::default();
    for effect in effects {
        effect.transfer(row, frequency_hz, &mut transfer);
    }
    transfer
}

/// The reference channel holds the level: what enters it follows from what it shows.
struct ReferenceInput {
    peak_v: f64,
    gain: f64,
    spectrum: Option<super::waveform::Spectrum>,
}

impl ReferenceInput {
    fn new(row: &Row, chain: &Chain) -> Self {
        match chain.ref_adc {
            Some(adc) if row.ref_peak_v.is_finite() => {
                let peak_v = adc.input_for(row.ref_peak_v);
                let spectrum = adc.spectrum(peak_v);
                Self {
                    peak_v,
                    gain: spectrum.order[1] / peak_v,
                    spectrum: Some(spectrum),
                }
            }
            _ => Self {
                peak_v: row.ref_peak_v,
                gain: 1.0,
                spectrum: None,
            },
        }
    }

    /// Held level corrected for the channel, r.m.s.
    fn input_ms2(&self, row: &Row) -> f64 {
        row.level_ms2 / self.gain
    }
}

struct Drive {
    linear: Linear,
    balanced: Option<Balanced>,
}

fn drive(row: &Row, values: &[f64; 6], chain: &Chain, level_ms2: f64, memory: Recall<'_>) -> Drive {
    let exciter = Exciter {
        mass_kg: values[0] + row.payload_kg + chain.mass_kg,
        stiffness_n_per_m: values[1],
        damping_ns_per_m: values[2] + chain.damping_ns_per_m,
        force_factor_n_per_a: values[3],
        resistance_ohm: values[4] * chain.resistance,
        inductance_h: values[5],
        emf_ratio: chain.emf,
        inductance_exponent: chain.inductance_exponent,
    };
    let added = Added {
        mass_kg: row.payload_kg + chain.mass_kg,
        damping_ns_per_m: chain.damping_ns_per_m,
    };
    let mut stiffness = exciter.dynamic_stiffness(row.omega);
    if chain.bend.is_linear()
        || !level_ms2.is_finite()
        || is_negligible(row, &exciter, chain, level_ms2)
    {
        return Drive {
            linear: exciter.linear(row.omega, added, stiffness),
            balanced: None,
        };
    }
    let balanced = memory.balance(&exciter, &chain.bend, row.omega, level_ms2 * SQRT_2);
    stiffness = balanced.stiffness;
    let mut linear = exciter.linear(row.omega, added, stiffness);
    linear.acceleration_per_v = balanced.acceleration_per_v;
    linear.admittance = balanced.admittance;
    Drive {
        linear,
        balanced: Some(balanced),
    }
}

/// At high frequency the travel is too small to bend anything; the row is then linear to 1e-7.
fn is_negligible(row: &Row, exciter: &Exciter, chain: &Chain, level_ms2: f64) -> bool {
    let bend = &chain.bend;
    if bend.friction_n != 0.0 || bend.even_per_v != 0.0 {
        return false;
    }
    if let Some(threshold) = bend.clip_v {
        let stiffness = exciter.dynamic_stiffness(row.omega);
        let per_v = exciter
            .linear(row.omega, Added::default(), stiffness)
            .acceleration_per_v
            .norm();
        if level_ms2 * SQRT_2 / per_v > 0.75 * threshold {
            return false;
        }
    }
    let sag = bend.gravity_ms2.abs() * exciter.mass_kg / exciter.stiffness_n_per_m;
    let travel = level_ms2 * SQRT_2 / (row.omega * row.omega);
    let slope = 2.0 * bend.quadratic_n_per_m2.abs() * (travel + sag)
        + 3.0 * bend.cubic_n_per_m3.abs() * travel * travel;
    slope < 1e-7 * exciter.dynamic_stiffness(row.omega).norm()
        && bend.droop_per_m2.abs() * travel * travel < 1e-7
}

/// Harmonics of the table as the channels receive them.
struct Harmonics<'a> {
    table: [Complex64; 4],
    /// Mean square of what the table moves beyond them, over that of the fundamental.
    remainder: f64,
    row: &'a Row,
    effects: &'a [Active<'a>],
    first: Transfer,
}

impl Harmonics<'_> {
    fn moving(&self) -> bool {
        self.table.iter().any(|h| *h != Complex64::ZERO)
    }

    /// Relative harmonics after the linear part of reference and DUT chain.
    fn received(&self) -> [[Complex64; 4]; 2] {
        if !self.moving() {
            return [[Complex64::ZERO; 4]; 2];
        }
        let mut out = [[Complex64::ZERO; 4]; 2];
        let (first_ref, first_dut) = (
            self.first.table * self.first.reference,
            self.first.table * self.first.dut,
        );
        let [to_ref, to_dut] = &mut out;
        for (k, (to_ref, to_dut)) in to_ref.iter_mut().zip(to_dut).enumerate() {
            let n = k as u32 + 2;
            let t = transfer(self.row, self.effects, self.row.frequency_hz * f64::from(n));
            *to_ref = self.table[k] * carried(t.table * t.reference, first_ref, n);
            *to_dut = self.table[k] * carried(t.table * t.dut, first_dut, n);
        }
        out
    }

    /// What the linear DUT chain makes of harmonics that arise at its mount.
    fn through_dut(&self, relative: [f64; 4]) -> [Complex64; 4] {
        std::array::from_fn(|k| {
            if relative[k] == 0.0 {
                return Complex64::ZERO;
            }
            let n = k as u32 + 2;
            let t = transfer(self.row, self.effects, self.row.frequency_hz * f64::from(n));
            carried(t.dut, self.first.dut, n) * relative[k]
        })
    }
}

/// Response at order n relative to the fundamental, phase relative to n times its phase.
fn carried(at_order: Complex64, at_first: Complex64, n: u32) -> Complex64 {
    let first = size(at_first);
    at_order / first * (at_first / first).powu(n).conj()
}

/// Fills harmonics and d.c.; returns the complex gains of both channels.
fn channels(
    row: &Row,
    nominal: &Nominal,
    chain: &Chain,
    reference: &ReferenceInput,
    harmonics: &Harmonics<'_>,
    out: &mut Prediction,
) -> (f64, f64) {
    let [mut in_ref, mut in_dut] = harmonics.received();
    let mut dut_gain = 1.0;
    let mut dut_peak_v = row.dut_peak_v * nominal.dut_gain * size(harmonics.first.dut)
        / size(harmonics.first.reference)
        / reference.gain;
    for (channel, peak_v) in [(0, reference.peak_v), (1, dut_peak_v)] {
        if harmonics.remainder > 0.0 && peak_v.is_finite() {
            let mean_square_v2 = 0.5 * peak_v * peak_v * harmonics.remainder;
            out.remainder_v2[channel] += mean_square_v2;
            // Orders above those of the balance, and how the channels carry them, stay open.
            out.remainder_open[channel] = 0.2;
        }
    }
    if let (Some(mount), true) = (chain.mount, row.level_ms2.is_finite()) {
        let peak_ms2 = row.level_ms2 * SQRT_2 / reference.gain / size(harmonics.first.reference);
        let spectrum = mount.spectrum(peak_ms2);
        dut_gain *= spectrum.order[1] / peak_ms2;
        let relative = std::array::from_fn(|k| spectrum.order[k + 2] / spectrum.order[1]);
        for (sum, added) in in_dut.iter_mut().zip(harmonics.through_dut(relative)) {
            *sum += added;
        }
        let v_per_ms2 = dut_peak_v / peak_ms2;
        out.remainder_v2[1] += spectrum.remainder_mean_square * v_per_ms2 * v_per_ms2;
        dut_peak_v *= dut_gain;
    }
    for (sum, added) in in_dut
        .iter_mut()
        .zip(harmonics.through_dut(chain.dut_harmonics))
    {
        *sum += added;
    }
    let mut ref_gain = 1.0;
    if let Some(spectrum) = &reference.spectrum {
        ref_gain = reference.gain;
        digitise(0, spectrum, reference.peak_v, &mut in_ref, out);
    }
    if let (Some(adc), true) = (chain.dut_adc, dut_peak_v.is_finite()) {
        let spectrum = adc.spectrum(dut_peak_v);
        dut_gain *= spectrum.order[1] / dut_peak_v;
        digitise(1, &spectrum, dut_peak_v, &mut in_dut, out);
    }
    write_harmonics(row, REF_HARMONICS, &in_ref, out);
    write_harmonics(row, DUT_HARMONICS, &in_dut, out);
    (ref_gain, dut_gain)
}

/// Adds what a bent converter does to harmonics and d.c.
fn digitise(
    channel: usize,
    spectrum: &super::waveform::Spectrum,
    peak_v: f64,
    harmonics: &mut [Complex64; 4],
    out: &mut Prediction,
) {
    let gain = spectrum.order[1] / peak_v;
    for (k, h) in harmonics.iter_mut().enumerate() {
        *h = *h / gain + spectrum.order[k + 2] / spectrum.order[1];
    }
    out.value[DC + channel] += spectrum.order[0];
    out.remainder_v2[channel] += spectrum.remainder_mean_square;
}

fn write_harmonics(row: &Row, slot: usize, harmonics: &[Complex64; 4], out: &mut Prediction) {
    for (k, h) in harmonics.iter().enumerate() {
        let at = slot + 2 * k;
        if row.bare_harmonics[(at - REF_HARMONICS) / 2] {
            // The amplitude of pure noise has the mean u sqrt(pi/2).
            out.value[at] =
                (h.norm_sqr() + row.u[at] * row.u[at] * std::f64::consts::FRAC_PI_2).sqrt();
        } else {
            put(out, at, *h);
        }
    }
}

fn noise(nominal: &Nominal, chain: &Chain, out: &mut Prediction) {
    for channel in 0..2 {
        let healthy = nominal.noise_v[channel] * nominal.noise_v[channel];
        let (power, open) = chain.noise(channel, healthy);
        if power > 0.0 {
            out.value[NOISE + channel] = 0.5 * power.ln();
            out.noise_power_v2[channel] = power;
            out.noise_share[channel] = healthy / power;
        }
        out.open[NOISE + channel] += open;
    }
}

fn leakage(row: &Row, chain: &Chain, out: &mut Prediction) {
    for part in 0..2 {
        out.open[RATIO + part] += chain.leakage[0];
        out.open[DRIVE + part] += chain.leakage[1];
    }
    for (channel, slot) in [(0, REF_HARMONICS), (1, DUT_HARMONICS)] {
        for k in 0..4 {
            for part in 0..2 {
                out.open[slot + 2 * k + part] += chain.harmonic_leakage[channel][k];
            }
        }
    }
    for (channel, v2) in chain.dc_leakage_v2.iter().enumerate() {
        out.open[DC + channel] += v2;
    }
    for slot in 0..SLOTS {
        if row.u[slot].is_infinite() {
            out.open[slot] = 0.0;
        }
    }
}
