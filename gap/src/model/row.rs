//! One point, prepared for the model: conditions and measured values by slot.

use super::leakage::{leaked_mains, taken_mains};
use crate::dataset::{Harmonic, Point, Rig, Transducer};
use std::f64::consts::{SQRT_2, TAU};

/// Scalar observables of one row. Logarithms make gains additive.
///
/// | slot | value |
/// |---|---|
/// | 0, 1 | ln of the ratio, its phase |
/// | 2, 3 | ln of reference/coil voltage, its phase |
/// | 4, 5 | ln of coil current/voltage, its phase |
/// | 6..14 | harmonics 2..5 of the reference, real and imaginary |
/// | 14..22 | harmonics 2..5 of the device under test |
/// | 22, 23 | d.c. of reference and device under test, in V |
/// | 24, 25 | ln of the noise of reference and device under test |
pub(crate) const SLOTS: usize = 26;
/// First slot of the ratio.
pub(crate) const RATIO: usize = 0;
/// First slot of the drive.
pub(crate) const DRIVE: usize = 2;
/// First slot of the current.
pub(crate) const CURRENT: usize = 4;
/// First slot of the reference channel's harmonics.
pub(crate) const REF_HARMONICS: usize = 6;
/// First slot of the harmonics of the device under test.
pub(crate) const DUT_HARMONICS: usize = 14;
/// First slot of the d.c. values.
pub(crate) const DC: usize = 22;
/// First slot of the noise.
pub(crate) const NOISE: usize = 24;

/// Scatter of one noise value about its expectation, relative.
pub(crate) const NOISE_SCATTER: f64 = 0.01;

/// Conditions of a point; what was not stated has a neutral value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Row {
    pub(crate) frequency_hz: f64,
    pub(crate) omega: f64,
    pub(crate) run: usize,
    /// Since the first point, in s.
    pub(crate) time_s: f64,
    /// Temperature minus the reference temperature, in K.
    pub(crate) warmer_k: f64,
    /// Cosine and sine of the rotation.
    pub(crate) rotation: (f64, f64),
    /// Cosine of the tilt.
    pub(crate) vertical: f64,
    pub(crate) payload_kg: f64,
    pub(crate) payload_stated: bool,
    /// Power that mains lines leak into orders 1..5 over their power; 0 where the block is unknown.
    pub(crate) mains_leak: [f64; 5],
    /// The same for d.c.
    pub(crate) mains_leak_dc: f64,
    /// Measured coil voltage, peak; NaN if unknown.
    pub(crate) coil_peak_v: f64,
    /// Held level, r.m.s., in m/s2; NaN if unknown.
    pub(crate) level_ms2: f64,
    /// Peak voltages at the digitiser as the nominal simulation has them; NaN if unknown.
    pub(crate) ref_peak_v: f64,
    pub(crate) dut_peak_v: f64,
    /// Measured r.m.s. voltages of both channels where there are any, else the nominal ones; NaN if unknown.
    pub(crate) seen_v: [f64; 2],
    /// Share of a mains line that the components of the block take: the nearest line's, orders 1..5 and d.c.
    pub(crate) mains_taken: f64,
    /// Width of one bin of the block, in Hz; NaN if unknown.
    pub(crate) bin_hz: f64,
    /// Only the amplitude of the harmonics is known.
    pub(crate) bare_harmonics: [bool; 8],
    /// Measured value of each slot.
    pub(crate) value: [f64; SLOTS],
    /// Standard uncertainty of each slot; infinite where nothing was measured.
    pub(crate) u: [f64; SLOTS],
}

impl Row {
    /// Prepares a point.
    pub(crate) fn new(point: &Point, rig: &Rig) -> Self {
        let sizes = Sizes::new(point, rig);
        let peak_v = |v: Option<f64>| v.map_or(f64::NAN, |v| v * SQRT_2);
        let rotation = point.rotation_rad.unwrap_or(0.0);
        let reference_c = rig.environment.reference_temperature_c.unwrap_or(23.0);
        let bin_hz = bin_hz(rig);
        let mains_hz = rig.environment.mains_hz.unwrap_or(50.0);
        let leaked = |hz: f64| bin_hz.map_or(0.0, |bin| leaked_mains(hz, mains_hz, bin));
        let taken = |bin| taken_mains(point.frequency_hz, mains_hz, bin);
        let mut row = Self {
            frequency_hz: point.frequency_hz,
            omega: TAU * point.frequency_hz,
            run: point.run,
            time_s: point.time_s.unwrap_or(0.0),
            warmer_k: point.temperature_c.map_or(0.0, |t| t - reference_c),
            rotation: (rotation.cos(), rotation.sin()),
            vertical: point.tilt_rad.unwrap_or(0.0).cos(),
            payload_kg: point.payload_kg.unwrap_or(0.0),
            payload_stated: point.payload_kg.is_some(),
            mains_leak: std::array::from_fn(|k| leaked(point.frequency_hz * (k + 1) as f64)),
            mains_leak_dc: leaked(0.0),
            coil_peak_v: peak_v(point.coil_v),
            level_ms2: sizes.level_ms2.unwrap_or(f64::NAN),
            ref_peak_v: peak_v(sizes.ref_v),
            dut_peak_v: peak_v(sizes.dut_v),
            seen_v: sizes.seen_v.map(|v| v.unwrap_or(f64::NAN)),
            mains_taken: bin_hz.map_or(0.0, taken),
            bin_hz: bin_hz.unwrap_or(f64::NAN),
            bare_harmonics: [false; 8],
            value: [0.0; SLOTS],
            u: [f64::INFINITY; SLOTS],
        };
        row.fill(point, rig);
        row
    }

    fn set(&mut self, slot: usize, value: Option<f64>, u: Option<f64>) {
        if let (Some(value), Some(u)) = (value, u) {
            self.value[slot] = value;
            self.u[slot] = u;
        }
    }

    fn fill(&mut self, p: &Point, rig: &Rig) {
        let quotient = |a: Option<f64>, b: Option<f64>| Some((a? / b?).ln());
        self.set(
            RATIO,
            p.ratio.map(f64::ln).or_else(|| quotient(p.dut_v, p.ref_v)),
            p.u_ratio,
        );
        self.set(RATIO + 1, p.dut_rad, p.u_phase_rad);
        if rig.exciter.is_some_and(|e| e.complete().is_some()) {
            self.set(DRIVE, quotient(p.ref_v, p.coil_v), p.u_drive);
            self.set(DRIVE + 1, p.ref_rad, p.u_drive);
            self.set(CURRENT, quotient(p.coil_a, p.coil_v), p.u_current);
            self.set(CURRENT + 1, p.coil_a_rad, p.u_current);
        }
        for (k, harmonic) in p.ref_harmonics.iter().chain(&p.dut_harmonics).enumerate() {
            if let Some(harmonic) = harmonic {
                self.set_harmonic(k, *harmonic, p.u_harmonic);
            }
        }
        self.set(DC, p.ref_dc_v, p.u_dc_v);
        self.set(DC + 1, p.dut_dc_v, p.u_dc_v);
        if rig.digitiser.noise_v.is_some() {
            self.set(NOISE, p.ref_noise_v.map(f64::ln), Some(NOISE_SCATTER));
            self.set(NOISE + 1, p.dut_noise_v.map(f64::ln), Some(NOISE_SCATTER));
        }
    }

    fn set_harmonic(&mut self, k: usize, harmonic: Harmonic, u: Option<f64>) {
        let slot = REF_HARMONICS + 2 * k;
        if let Some(value) = harmonic.complex() {
            self.set(slot, Some(value.re), u);
            self.set(slot + 1, Some(value.im), u);
        } else {
            self.set(slot, Some(harmonic.amplitude), u);
            self.bare_harmonics[k] = true;
        }
    }
}

/// Level and voltages of a point, r.m.s.; none where they do not follow from what is stated.
struct Sizes {
    level_ms2: Option<f64>,
    /// As the nominal simulation has them.
    ref_v: Option<f64>,
    dut_v: Option<f64>,
    /// As measured where they were, else the nominal ones.
    seen_v: [Option<f64>; 2],
}

impl Sizes {
    fn new(point: &Point, rig: &Rig) -> Self {
        let sensitivity = |t: Option<Transducer>| Some(t?.sensitivity_v_per_ms2?.value);
        let (s1, s2) = (sensitivity(rig.reference), sensitivity(rig.dut));
        let from_ref = || Some(point.ref_v? / s1?);
        let level_ms2 = point.acceleration_ms2.or_else(from_ref);
        let ref_v = level_ms2.and_then(|a| Some(a * s1?)).or(point.ref_v);
        let dut_v = level_ms2
            .and_then(|a| Some(a * s2?))
            .or(point.dut_v)
            .or_else(|| Some(point.ratio? * point.ref_v?));
        let seen_ref_v = point.ref_v.or(ref_v);
        let seen_dut_v = point.dut_v.or_else(|| Some(point.ratio? * seen_ref_v?));
        Self {
            level_ms2,
            ref_v,
            dut_v,
            seen_v: [seen_ref_v, seen_dut_v.or(dut_v)],
        }
    }
}

/// Width of one bin of the block, in Hz.
fn bin_hz(rig: &Rig) -> Option<f64> {
    Some(rig.digitiser.sample_rate_hz? / rig.digitiser.block_samples?)
}
