//! One point, prepared for the model: conditions and measured values.

use super::scatter::{leaked_mains, taken_mains};
use crate::dataset::{Harmonic, Point, Rig, Transducer};
use crate::observable::{Channel, Complex, Observable, Table};
use crate::thresholds;
use std::f64::consts::{SQRT_2, TAU};

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
    /// Power that mains lines leak into d.c. over their power.
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
    /// Whether only the amplitude is known, by channel, of harmonics 2 to 5.
    pub(crate) bare_harmonics: [[bool; 4]; 2],
    /// Measured values.
    pub(crate) value: Table<f64>,
    /// Their standard uncertainties; infinite where nothing was measured.
    pub(crate) u: Table<f64>,
}

impl Row {
    /// Cosine and sine of twice the rotation.
    pub(crate) fn rotation_twice(&self) -> (f64, f64) {
        let (cos, sin) = self.rotation;
        (cos * cos - sin * sin, 2.0 * sin * cos)
    }

    /// Whether another row was measured under the same conditions, as far as they are set.
    pub(crate) fn repeats(&self, other: &Self) -> bool {
        let is_near =
            |a: f64, b: f64, by: f64| a == b || (a - b).abs() <= by * a.abs().max(b.abs());
        let same_level = self.level_ms2.is_nan() && other.level_ms2.is_nan()
            || is_near(self.level_ms2, other.level_ms2, thresholds::LEVEL_REPEATED);
        same_level
            && is_near(self.frequency_hz, other.frequency_hz, 1e-6)
            && is_near(self.payload_kg, other.payload_kg, 1e-6)
            && self.rotation == other.rotation
            && self.vertical == other.vertical
            && (self.warmer_k - other.warmer_k).abs() < thresholds::REPEATED_K
    }

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
            bare_harmonics: [[false; 4]; 2],
            value: Table::filled(0.0),
            u: Table::filled(f64::INFINITY),
        };
        row.fill(point, rig);
        row
    }

    /// Travel of the table, r.m.s., in m; NaN if the level is unknown.
    pub(crate) fn travel_m(&self) -> f64 {
        self.level_ms2 / (self.omega * self.omega)
    }

    fn set(&mut self, observable: Observable, value: Option<f64>, u: Option<f64>) {
        if let (Some(value), Some(u)) = (value, u) {
            self.value[observable] = value;
            self.u[observable] = u;
        }
    }

    fn fill(&mut self, p: &Point, rig: &Rig) {
        let quotient = |a: Option<f64>, b: Option<f64>| Some((a? / b?).ln());
        let ratio = p.ratio.map(f64::ln).or_else(|| quotient(p.dut_v, p.ref_v));
        self.set(Observable::Ratio, ratio, p.u_ratio);
        self.set(Observable::RatioPhase, p.dut_rad, p.u_phase_rad);
        if rig.exciter.is_some_and(|e| e.complete().is_some()) {
            let (drive, current) = (quotient(p.ref_v, p.coil_v), quotient(p.coil_a, p.coil_v));
            self.set(Observable::Drive, drive, p.u_drive);
            self.set(Observable::DrivePhase, p.ref_rad, p.u_drive);
            self.set(Observable::Current, current, p.u_current);
            self.set(Observable::CurrentPhase, p.coil_a_rad, p.u_current);
        }
        let harmonics = [p.ref_harmonics, p.dut_harmonics];
        for (channel, harmonics) in Channel::BOTH.into_iter().zip(harmonics) {
            let observables = Observable::harmonics(channel).into_iter();
            for (k, (parts, harmonic)) in observables.zip(harmonics).enumerate() {
                if let Some(harmonic) = harmonic {
                    self.bare_harmonics[channel as usize][k] = harmonic.phase_rad.is_none();
                    self.set_harmonic(parts, harmonic, p.u_harmonic);
                }
            }
        }
        self.set(Observable::RefDc, p.ref_dc_v, p.u_dc_v);
        self.set(Observable::DutDc, p.dut_dc_v, p.u_dc_v);
        if rig.digitiser.noise_v.is_some() {
            let (reference, dut) = (p.ref_noise_v.map(f64::ln), p.dut_noise_v.map(f64::ln));
            self.set(
                Observable::RefNoise,
                reference,
                Some(thresholds::NOISE_SCATTER),
            );
            self.set(Observable::DutNoise, dut, Some(thresholds::NOISE_SCATTER));
        }
    }

    fn set_harmonic(&mut self, [real, imaginary]: Complex, harmonic: Harmonic, u: Option<f64>) {
        if let Some(value) = harmonic.complex() {
            self.set(real, Some(value.re), u);
            self.set(imaginary, Some(value.im), u);
        } else {
            self.set(real, Some(harmonic.amplitude), u);
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
