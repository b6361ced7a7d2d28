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
        2.0 * mean_square(&above)
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
mod tests {
    use super::*;
    use crate::dataset::{Harmonic, Point, Rig};
    use crate::effects::library;
    use crate::model::memory::{Memory, Recall};
    use crate::model::predict::predict;
    use crate::model::row::{DRIVE, RATIO};
    use std::f64::consts::TAU;

    const RIG: &str = r#"
kind = "calibrator"
[reference]
sensitivity_v_per_ms2 = { value = 0.01, u = 0.0 }
[dut]
sensitivity_v_per_ms2 = { value = 0.02, u = 0.0 }
[exciter]
moving_mass_kg = { value = 0.05, u = 0.0 }
stiffness_n_per_m = { value = 8000.0, u = 0.0 }
damping_ns_per_m = { value = 3.0, u = 0.0 }
force_factor_n_per_a = { value = 7.0, u = 0.0 }
coil_resistance_ohm = { value = 4.0, u = 0.0 }
coil_inductance_h = { value = 0.00012, u = 0.0 }
"#;
    const LEVEL_MS2: f64 = 10.0;

    /// The effects at 20 Hz, 10 m/s2, on a reference of 10 mV and a device of 20 mV per m/s2.
    fn predicted(effects: &[(&str, usize, Vec<f64>)]) -> Prediction {
        let rig: Rig = toml::from_str(RIG).expect("the rig is good");
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
        let row = Row::new(&point, &rig);
        let active: Vec<Active<'_>> = effects
            .iter()
            .map(|(name, variant, parameters)| {
                let entries = library().iter().enumerate();
                let mut named = entries.filter(|(_, e)| e.about().id == *name);
                let (entry, effect) = named.nth(*variant).expect("an entry of the library");
                Active {
                    entry,
                    effect: *effect,
                    parameters: parameters.clone(),
                    unit: vec![1.0; parameters.len()],
                }
            })
            .collect();
        let nominal = Nominal {
            exciter: Some([0.05, 8000.0, 3.0, 7.0, 4.0, 1.2e-4]),
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

    fn harmonics(found: &Prediction, slot: usize) -> [Complex64; 4] {
        std::array::from_fn(|k| {
            Complex64::new(found.value[slot + 2 * k], found.value[slot + 2 * k + 1])
        })
    }

    const SAMPLES: usize = 1 << 14;

    /// One period of a fundamental with relative harmonics.
    fn wave_in_time(peak: f64, harmonics: &[Complex64; 4]) -> Vec<f64> {
        let at = |i: usize| {
            let t = TAU * i as f64 / SAMPLES as f64;
            let of = |(k, h): (usize, &Complex64)| {
                (h * Complex64::from_polar(1.0, (k + 2) as f64 * t)).re
            };
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
        let table = harmonics(&predicted(std::slice::from_ref(&bent)), REF_HARMONICS);
        assert!(table[0].norm() > 0.05, "{table:?}");
        let cubic_per_v2 = 0.25;
        let found = predicted(&[bent, ("adc_cubic", 1, vec![cubic_per_v2])]);
        let peak_v = 0.02 * LEVEL_MS2 * SQRT_2;
        let mut samples = wave_in_time(peak_v, &table);
        samples
            .iter_mut()
            .for_each(|v| *v += cubic_per_v2 * v.powi(3));
        let expected = relative(&samples);
        compare(&harmonics(&found, DUT_HARMONICS), &expected, 5e-6, "dut");
        compare(&harmonics(&found, REF_HARMONICS), &table, 1e-9, "ref");
        let gain = phasor(&samples, 1) / peak_v;
        assert!((found.value[RATIO] - (2.0 * gain.norm()).ln()).abs() < 5e-6);
        assert!((found.value[RATIO + 1] - gain.arg()).abs() < 5e-6);
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
                (c * Complex64::from_polar(1.0, TAU * ((n * i) % SAMPLES) as f64 / SAMPLES as f64))
                    .re
            };
            orders.iter().enumerate().map(turned).sum()
        };
        let shown: Vec<f64> = (0..SAMPLES)
            .map(|i| at(i) + second_per_v * at(i).powi(2))
            .collect();
        compare(
            &harmonics(&found, DUT_HARMONICS),
            &relative(&shown),
            2e-5,
            "dut",
        );
        let gain = phasor(&shown, 1) / (0.02 * LEVEL_MS2 * SQRT_2);
        assert!((found.value[RATIO] - (2.0 * gain.norm()).ln()).abs() < 2e-5);
        assert!((found.value[RATIO + 1] - gain.arg()).abs() < 2e-5);
    }

    /// The level is what the reference shows: the table moves more where the channel saturates.
    #[test]
    fn the_level_is_held_by_what_a_saturating_reference_shows_of_a_bent_wave() {
        let bent = ("suspension_asymmetry", 0, vec![3e5]);
        let threshold_v = 0.138;
        let found = predicted(&[bent, ("adc_clipping", 0, vec![threshold_v])]);
        // The ratio tells how much more: the device shows all of it.
        let more = (found.value[RATIO]).exp() / 2.0;
        let table = harmonics(&found, DUT_HARMONICS);
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
            &harmonics(&found, REF_HARMONICS),
            &relative(&samples),
            5e-5,
            "ref",
        );
        assert!(found.value[DRIVE].is_finite());
    }
}
