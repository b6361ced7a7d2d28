//! Signals of both channels: gains, harmonics and means.
//!
//! In the order of the signal path: the wave of the table, the mount, the
//! linear responses, the converter. Each bends the wave that reaches it, and a
//! response carries what arose before it.

use super::chain::Chain;
use super::grid::{ORDERS, Wave, mean_square, size};
use super::held::Held;
use super::path::{Above, Path, distortion, highest, mixes, pass};
use super::prediction::{Nominal, Prediction};
use super::row::Row;
use super::waveform::{Characteristic, REPORTED};
use crate::observable::{Channel, Observable};
use crate::thresholds;
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// Fills harmonics and d.c.; returns the gains of reference and device under test.
pub(super) fn channels(
    nominal: &Nominal,
    chain: &Chain,
    held: &Held<'_>,
    out: &mut Prediction,
) -> [Complex64; 2] {
    [
        of_reference(chain, held, out),
        of_dut(nominal, chain, held, out),
    ]
}

fn of_reference(chain: &Chain, held: &Held<'_>, out: &mut Prediction) -> Complex64 {
    let (path, peak_v) = (&held.path, held.reference.peak_v);
    let adc = chain.ref_adc.filter(|_| peak_v.is_finite());
    if adc.is_none() && path.is_sine() {
        write_sine(path.transfers.row, Channel::Reference, out);
        return Complex64::ONE;
    }
    let whole = mixes(adc, peak_v, path.others);
    let mut signal = Signal {
        channel: Channel::Reference,
        peak_v,
        wave: path.to_reference(highest(whole)),
    };
    let gain = match adc {
        Some(adc) => signal.convert(adc, whole, out),
        None => Complex64::ONE,
    };
    signal.write(path, &path.above(|t| t.table * t.reference), whole, out);
    gain
}

fn of_dut(nominal: &Nominal, chain: &Chain, held: &Held<'_>, out: &mut Prediction) -> Complex64 {
    let path = &held.path;
    let (row, first) = (path.transfers.row, &path.transfers.first);
    let is_bent = chain.mount.is_some() || chain.dut_adc.is_some();
    if !is_bent && path.is_sine() && chain.dut_harmonics == [0.0; 4] {
        write_sine(row, Channel::Dut, out);
        return Complex64::ONE;
    }
    let shown = held.reference.gain * size(first.reference);
    let peak_v = row.dut_peak_v * nominal.dut_gain * size(first.dut) / shown;
    let peak_ms2 = row.level_ms2 * SQRT_2 / shown / nominal.reference_gain;
    let mount = chain.mount.filter(|_| peak_ms2.is_finite());
    let adc = chain.dut_adc.filter(|_| peak_v.is_finite());
    let twice = mixes(
        adc,
        peak_v,
        others_at_converter(chain, mount, peak_ms2, path),
    );
    let whole = mixes(mount, peak_ms2, path.others) || twice;
    let mut signal = Signal {
        channel: Channel::Dut,
        peak_v,
        wave: path.carry(&path.table, highest(whole), |t| t.table),
    };
    let mut gain = Complex64::ONE;
    if let Some(mount) = mount {
        gain = signal.lift(mount, peak_ms2, (path, whole), out);
        gain *= signal.feel(chain.dut_level_per_ms2, peak_ms2 / SQRT_2, size(gain));
    }
    // They grow with what the device feels.
    for (order, harmonic) in signal.wave[2..].iter_mut().zip(&chain.dut_harmonics) {
        *order += harmonic * size(gain);
    }
    signal.wave = path.carry(&signal.wave, highest(whole), |t| t.dut);
    if let Some(adc) = adc {
        gain *= signal.convert(adc, twice, out);
    }
    signal.write(path, &path.above(|t| t.table * t.dut), whole, out);
    gain
}

/// Sum of the sizes of the relative harmonics that reach the converter of the device, roughly: one
/// that has lifted off sends more than a sine.
fn others_at_converter(
    chain: &Chain,
    mount: Option<Characteristic>,
    peak_ms2: f64,
    path: &Path<'_>,
) -> f64 {
    let bent = mount.map_or(0.0, |m| distortion(m, peak_ms2)) + path.others;
    bent + chain.dut_harmonics.iter().map(|h| h.abs()).sum::<f64>()
}

/// The signal of a channel on its way.
struct Signal {
    channel: Channel,
    /// Of the fundamental.
    peak_v: f64,
    /// Relative harmonics.
    wave: Wave,
}

impl Signal {
    /// The mount bends the motion, of the given peak, as a whole wave or not; returns its gain.
    fn lift(
        &mut self,
        mount: Characteristic,
        peak_ms2: f64,
        (path, whole): (&Path<'_>, bool),
        out: &mut Prediction,
    ) -> Complex64 {
        let passed = pass(mount, peak_ms2, &self.wave, whole);
        let v_per_ms2 = self.peak_v / peak_ms2;
        if passed.beyond > 0.0 {
            let carried = path.carries_kink(|t| t.dut, whole);
            out.remainder_v2[self.channel as usize] += passed.beyond * v_per_ms2.powi(2) * carried;
        }
        self.peak_v *= size(passed.gain);
        self.wave = passed.wave;
        passed.gain
    }

    /// A gain that depends on the level (r.m.s.) is that of the level the device feels, a share of
    /// that of the table; returns what that changes.
    fn feel(&mut self, per_ms2: f64, level_ms2: f64, share: f64) -> f64 {
        let gain = (1.0 + per_ms2 * level_ms2 * share) / (1.0 + per_ms2 * level_ms2);
        self.peak_v *= gain;
        gain
    }

    /// The converter bends the voltage; returns its gain.
    fn convert(&mut self, adc: Characteristic, whole: bool, out: &mut Prediction) -> Complex64 {
        let passed = pass(adc, self.peak_v, &self.wave, whole);
        out.value[Observable::dc(self.channel)] += passed.mean;
        out.remainder_v2[self.channel as usize] += passed.beyond;
        self.peak_v *= size(passed.gain);
        self.wave = passed.wave;
        passed.gain
    }

    /// Writes the harmonics, and the orders above them, which show in the noise.
    fn write(&self, path: &Path<'_>, above: &Above, whole: bool, out: &mut Prediction) {
        if self.peak_v.is_finite() {
            self.write_remainder(path, above, whole, out);
        }
        write_harmonics(path.transfers.row, self.channel, &self.wave, out);
    }

    fn write_remainder(&self, path: &Path<'_>, above: &Above, whole: bool, out: &mut Prediction) {
        let over_fundamental = if whole {
            let mut wave = self.wave;
            wave[..REPORTED].fill(Complex64::ZERO);
            2.0 * mean_square(&wave) + above.beyond
        } else {
            above.remainder
        };
        out.remainder_v2[self.channel as usize] +=
            0.5 * self.peak_v * self.peak_v * over_fundamental;
        if path.remainder > 0.0 {
            let carried = (above.beyond - path.beyond).abs() / above.remainder;
            out.remainder_carried[self.channel as usize] = carried;
            out.remainder_open[self.channel as usize] = thresholds::REMAINDER_OPEN.max(carried);
        }
    }
}

/// A channel that nothing has bent: amplitudes without a phase are those of noise.
fn write_sine(row: &Row, channel: Channel, out: &mut Prediction) {
    if row.bare_harmonics[channel as usize].contains(&true) {
        write_harmonics(row, channel, &[Complex64::ZERO; ORDERS + 1], out);
    }
}

fn write_harmonics(row: &Row, channel: Channel, wave: &Wave, out: &mut Prediction) {
    let bare = row.bare_harmonics[channel as usize].iter();
    let observables = Observable::harmonics(channel).into_iter().zip(bare);
    for ((parts, bare), h) in observables.zip(&wave[2..REPORTED]) {
        if *bare {
            // The amplitude of pure noise has the mean u sqrt(pi/2).
            let [at, _] = parts;
            out.value[at] = (h.norm_sqr() + row.u[at] * row.u[at] * FRAC_PI_2).sqrt();
        } else {
            out.put(parts, *h);
        }
    }
}

#[cfg(test)]
mod tests;
