//! What both channels make of the motion: gains, harmonics and means.
//!
//! In the order of the signal path: the wave of the table, the mount, the
//! linear responses, the converter. Each bends the wave that reaches it, and a
//! response carries what arose before it. Where a wave is bent once only, the
//! closed forms for a cosine do; harmonics so small that a second bend does
//! nothing to them are added.

use super::balance::{Balanced, ORDERS};
use super::chain::{Chain, Transfer};
use super::predict::{Nominal, Prediction, put, size, transfer};
use super::row::{DC, DUT_HARMONICS, REF_HARMONICS, Row};
use super::wave::{Wave, mean_square};
use super::waveform::{Characteristic, REPORTED};
use crate::effects::Active;
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// Relative size below which what a bend does to arriving harmonics is left out.
const NEGLIGIBLE: f64 = 1e-7;

/// The wave of the table, and the linear responses on its way.
pub(super) struct Path<'a> {
    row: &'a Row,
    effects: &'a [Active<'a>],
    first: Transfer,
    /// Relative to the fundamental, whose phase is zero.
    table: Wave,
    /// Sum of the sizes of its harmonics.
    others: f64,
    /// Mean square of the orders above 5 over that of the fundamental.
    remainder: f64,
    /// What of it no wave holds.
    beyond: f64,
}

impl<'a> Path<'a> {
    /// The way from an exciter's motion; `None` is a sine.
    pub(super) fn new(
        row: &'a Row,
        effects: &'a [Active<'a>],
        first: Transfer,
        motion: Option<&Balanced>,
    ) -> Self {
        let mut table = [Complex64::ZERO; ORDERS + 1];
        if let Some(motion) = motion {
            table[2..REPORTED].copy_from_slice(&motion.harmonics);
            table[REPORTED..].copy_from_slice(&motion.above);
        }
        Self {
            row,
            effects,
            first,
            others: motion.map_or(0.0, |_| sizes(&table)),
            table,
            remainder: motion.map_or(0.0, |m| m.remainder),
            beyond: motion.map_or(0.0, |m| m.beyond),
        }
    }

    /// Whether the table moves without harmonics.
    fn is_sine(&self) -> bool {
        self.others == 0.0 && self.remainder == 0.0
    }

    /// Relative harmonics up to an order behind a response.
    fn carry(&self, wave: &Wave, highest: usize, of: fn(&Transfer) -> Complex64) -> Wave {
        let mut out = [Complex64::ZERO; ORDERS + 1];
        let first = of(&self.first);
        for n in (2..=highest).filter(|n| wave[*n] != Complex64::ZERO) {
            let there = transfer(self.row, self.effects, self.row.frequency_hz * n as f64);
            out[n] = wave[n] * carried(of(&there), first, n as u32);
        }
        out
    }

    /// What the reference channel receives.
    fn to_reference(&self, highest: usize) -> Wave {
        self.carry(&self.table, highest, |t| t.table * t.reference)
    }
}

/// Sum of the sizes of relative harmonics.
fn sizes(wave: &Wave) -> f64 {
    wave[2..].iter().map(|c| size(*c)).sum()
}

/// Response at order n relative to the fundamental, phase relative to n times its phase.
fn carried(at_order: Complex64, at_first: Complex64, n: u32) -> Complex64 {
    let first = size(at_first);
    at_order / first * (at_first / first).powu(n).conj()
}

/// Orders that have to be followed: all where a wave is bent twice.
fn highest(twice: bool) -> usize {
    if twice { ORDERS } else { REPORTED - 1 }
}

/// Whether a bend does to the harmonics that arrive what a sum would not.
fn mixes(bend: Option<Characteristic>, peak: f64, others: f64) -> bool {
    let strength = |bend| match bend {
        Characteristic::Polynomial { second, third } => {
            2.0 * second.abs() * peak + 3.0 * third.abs() * peak * peak
        }
        Characteristic::DeadZone { .. } => 1.0,
        Characteristic::Clip { threshold } | Characteristic::OneSided { threshold, .. } => {
            f64::from(u8::from(peak * (1.0 + others) > threshold))
        }
    };
    peak.is_finite() && bend.is_some_and(|bend| strength(bend) * others > NEGLIGIBLE)
}

/// A wave behind a characteristic.
struct Passed {
    /// Fundamental over that in front.
    gain: Complex64,
    /// Relative harmonics; phases relative to n times that of the fundamental.
    wave: Wave,
    mean: f64,
    /// Mean square of the orders that are not in the wave.
    beyond: f64,
}

/// What a characteristic makes of a fundamental of the given peak and its relative harmonics;
/// as a whole wave, or by the closed form to which the harmonics are added.
fn pass(bend: Characteristic, peak: f64, arriving: &Wave, whole: bool) -> Passed {
    if whole {
        return shaped(bend, peak, arriving);
    }
    let spectrum = bend.spectrum(peak);
    let gain = spectrum.order[1] / peak;
    let mut wave = arriving.map(|c| c / gain);
    for (n, order) in spectrum.order.iter().enumerate().skip(2) {
        wave[n] += order / spectrum.order[1];
    }
    Passed {
        gain: Complex64::from(gain),
        wave,
        mean: spectrum.order[0],
        beyond: spectrum.remainder_mean_square,
    }
}

fn shaped(bend: Characteristic, peak: f64, arriving: &Wave) -> Passed {
    let mut wave = arriving.map(|c| c * peak);
    wave[0] = Complex64::ZERO;
    wave[1] = Complex64::from(peak);
    let shaped = bend.shape(&wave);
    let first = shaped.wave[1];
    let (length, back) = (size(first), (first / size(first)).conj());
    let mut turned = back;
    let mut relative = [Complex64::ZERO; ORDERS + 1];
    for (order, there) in relative.iter_mut().zip(&shaped.wave).skip(2) {
        turned *= back;
        *order = there / length * turned;
    }
    Passed {
        gain: first / peak,
        wave: relative,
        mean: shaped.wave[0].re,
        beyond: shaped.beyond,
    }
}

/// The reference channel holds the level: what enters it follows from what it shows.
pub(super) struct Reference {
    peak_v: f64,
    gain: f64,
}

impl Reference {
    /// For a sine.
    pub(super) fn new(row: &Row, chain: &Chain) -> Self {
        let peak_v = row.ref_peak_v;
        let (peak_v, gain) = match chain.ref_adc {
            Some(adc) if peak_v.is_finite() => {
                let input_v = adc.input_for(peak_v);
                (input_v, adc.spectrum(input_v).order[1] / input_v)
            }
            _ => (peak_v, 1.0),
        };
        Self { peak_v, gain }
    }

    /// For the wave that arrives; `None` where it makes no difference.
    pub(super) fn behind(&self, chain: &Chain, path: &Path<'_>) -> Option<Self> {
        let adc = chain.ref_adc?;
        if !mixes(Some(adc), self.peak_v, path.others) {
            return None;
        }
        let arriving = path.to_reference(ORDERS);
        let shown = path.row.ref_peak_v;
        let gain = |peak: f64| size(shaped(adc, peak, &arriving).gain);
        let mut next = Self {
            peak_v: self.peak_v,
            gain: gain(self.peak_v),
        };
        // A saturating channel may not be able to show what it does: then the last try holds.
        for _ in 0..12 {
            let off = shown / (next.peak_v * next.gain) - 1.0;
            if off.abs() < 1e-10 {
                break;
            }
            // The output grows less than the input where it saturates.
            let (peak_v, step) = (next.peak_v * (1.0 + 1e-4), 1e-4);
            let growth = (peak_v * gain(peak_v)) / (next.peak_v * next.gain) - 1.0;
            let by = (off * step / growth.max(0.02 * step)).clamp(-0.5, 1.0);
            next.peak_v *= 1.0 + by;
            next.gain = gain(next.peak_v);
        }
        ((next.gain / self.gain - 1.0).abs() > NEGLIGIBLE).then_some(next)
    }

    /// Held level corrected for the channel, r.m.s.
    pub(super) fn input_ms2(&self, row: &Row) -> f64 {
        row.level_ms2 / self.gain
    }
}

/// Fills harmonics and d.c.; returns the gains of reference and device under test.
pub(super) fn channels(
    nominal: &Nominal,
    chain: &Chain,
    reference: &Reference,
    path: &Path<'_>,
    out: &mut Prediction,
) -> [Complex64; 2] {
    [
        of_reference(chain, reference, path, out),
        of_dut(nominal, chain, reference, path, out),
    ]
}

fn of_reference(
    chain: &Chain,
    reference: &Reference,
    path: &Path<'_>,
    out: &mut Prediction,
) -> Complex64 {
    let adc = chain.ref_adc.filter(|_| reference.peak_v.is_finite());
    if adc.is_none() && path.is_sine() {
        write_sine(path.row, REF_HARMONICS, out);
        return Complex64::ONE;
    }
    let whole = mixes(adc, reference.peak_v, path.others);
    let mut wave = path.to_reference(highest(whole));
    let mut gain = Complex64::ONE;
    if let Some(adc) = adc {
        let passed = pass(adc, reference.peak_v, &wave, whole);
        (gain, wave) = (passed.gain, passed.wave);
        out.value[DC] += passed.mean;
        out.remainder_v2[0] += passed.beyond;
    }
    remainder(0, path, whole, reference.peak_v * size(gain), &wave, out);
    write_harmonics(path.row, REF_HARMONICS, &wave, out);
    gain
}

fn of_dut(
    nominal: &Nominal,
    chain: &Chain,
    reference: &Reference,
    path: &Path<'_>,
    out: &mut Prediction,
) -> Complex64 {
    let (row, first) = (path.row, &path.first);
    let is_bent = chain.mount.is_some() || chain.dut_adc.is_some();
    if !is_bent && path.is_sine() && chain.dut_harmonics == [0.0; 4] {
        write_sine(row, DUT_HARMONICS, out);
        return Complex64::ONE;
    }
    let held = reference.gain * size(first.reference);
    let mut peak_v = row.dut_peak_v * nominal.dut_gain * size(first.dut) / held;
    let peak_ms2 = row.level_ms2 * SQRT_2 / held / nominal.reference_gain;
    let mount = chain.mount.filter(|_| peak_ms2.is_finite());
    let adc = chain.dut_adc.filter(|_| peak_v.is_finite());
    let lifts = mixes(mount, peak_ms2, path.others);
    // A device that has lifted off sends more than a sine to its converter.
    let bent = mount.map_or(0.0, |m| bends_by(m, peak_ms2)) + path.others;
    let added = chain.dut_harmonics.iter().map(|h| h.abs()).sum::<f64>();
    let twice = mixes(adc, peak_v, bent + added);
    let whole = lifts || twice;
    let mut wave = path.carry(&path.table, highest(whole), |t| t.table);
    let mut gain = Complex64::ONE;
    if let Some(mount) = mount {
        let passed = pass(mount, peak_ms2, &wave, whole);
        (gain, wave) = (passed.gain, passed.wave);
        out.remainder_v2[1] += passed.beyond * (peak_v / peak_ms2).powi(2);
        peak_v *= size(gain);
    }
    for (order, harmonic) in wave[2..].iter_mut().zip(&chain.dut_harmonics) {
        *order += harmonic;
    }
    wave = path.carry(&wave, highest(whole), |t| t.dut);
    if let Some(adc) = adc {
        let passed = pass(adc, peak_v, &wave, twice);
        (gain, wave) = (gain * passed.gain, passed.wave);
        out.value[DC + 1] += passed.mean;
        out.remainder_v2[1] += passed.beyond;
        peak_v *= size(passed.gain);
    }
    remainder(1, path, whole, peak_v, &wave, out);
    write_harmonics(row, DUT_HARMONICS, &wave, out);
    gain
}

/// Harmonics of a sine behind a cut, roughly: none below the threshold.
fn bends_by(bend: Characteristic, peak: f64) -> f64 {
    let spectrum = bend.spectrum(peak);
    let harmonics = spectrum.order[2..].iter().map(|c| c.abs());
    harmonics.sum::<f64>() / peak
}

/// Mean square of the orders above 5, which shows in the noise.
fn remainder(
    channel: usize,
    path: &Path<'_>,
    whole: bool,
    peak_v: f64,
    wave: &Wave,
    out: &mut Prediction,
) {
    if !peak_v.is_finite() {
        return;
    }
    let over_fundamental = if whole {
        let mut above = *wave;
        above[..REPORTED].fill(Complex64::ZERO);
        2.0 * mean_square(&above) + path.beyond
    } else {
        path.remainder
    };
    out.remainder_v2[channel] += 0.5 * peak_v * peak_v * over_fundamental;
    if path.remainder > 0.0 {
        // Orders above those of the balance, and how the channels carry them, stay open.
        out.remainder_open[channel] = 0.2;
    }
}

/// A channel that nothing has bent: amplitudes without a phase are those of noise.
fn write_sine(row: &Row, slot: usize, out: &mut Prediction) {
    if row.bare_harmonics.contains(&true) {
        write_harmonics(row, slot, &[Complex64::ZERO; ORDERS + 1], out);
    }
}

fn write_harmonics(row: &Row, slot: usize, wave: &Wave, out: &mut Prediction) {
    for (k, h) in wave[2..REPORTED].iter().enumerate() {
        let at = slot + 2 * k;
        if row.bare_harmonics[(at - REF_HARMONICS) / 2] {
            // The amplitude of pure noise has the mean u sqrt(pi/2).
            out.value[at] = (h.norm_sqr() + row.u[at] * row.u[at] * FRAC_PI_2).sqrt();
        } else {
            put(out, at, *h);
        }
    }
}

#[cfg(test)]
mod tests;
