//! The instrument: what it writes down of a steady state, with its noise.

use std::f64::consts::{SQRT_2, TAU};

use nalgebra::Complex;
use rand::RngExt;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, StandardNormal};

use super::Setting;
use super::nominal::Nominal;
use super::point::{Harmonic, Point};
use super::unlocked::UnlockedTone;
use crate::model::{Channel, Model};
use crate::steady::{ChannelState, REPORTED, SteadyState};

/// Relative scatter of the noise columns.
const NOISE_SCATTER: f64 = 0.01;

/// Standard uncertainties of the random part of each row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uncertainties {
    /// Ratio, relative.
    pub ratio: f64,
    /// Its phase, degrees.
    pub phase_deg: f64,
    /// Reference over coil voltage, relative and in rad.
    pub drive: f64,
    /// Coil current over coil voltage, relative and in rad.
    pub current: f64,
    /// Real and imaginary part of each relative harmonic.
    pub harmonic: f64,
    /// Mean, V.
    pub dc_v: f64,
}

impl Default for Uncertainties {
    /// A good laboratory instrument.
    fn default() -> Self {
        Self {
            ratio: 2e-4,
            phase_deg: 0.02,
            drive: 5e-4,
            current: 5e-4,
            harmonic: 5e-5,
            dc_v: 2e-5,
        }
    }
}

/// A channel as seen over one block.
struct Seen {
    /// Harmonics 1 to 5, V peak.
    harmonics_v: [Complex<f64>; REPORTED],
    mean_v: f64,
    noise_rms_v: f64,
}

/// The instrument that writes the rows.
pub(super) struct Instrument {
    reference_v_per_ms2: f64,
    noise_rms_v: f64,
    block_s: f64,
    uncertainties: Uncertainties,
    random: ChaCha12Rng,
}

impl Instrument {
    pub(super) fn new(
        nominal: &Nominal,
        uncertainties: Uncertainties,
        random: ChaCha12Rng,
    ) -> Self {
        let digitiser = &nominal.digitiser;
        let mut instrument = Self {
            reference_v_per_ms2: nominal.reference.sensitivity_v_per_ms2.value,
            noise_rms_v: digitiser.noise_v.value,
            block_s: digitiser.block_samples / digitiser.sample_rate_hz,
            uncertainties,
            random,
        };
        instrument.noise_rms_v += digitiser.noise_v.u * instrument.normal();
        instrument
    }

    /// Turns to the row of setting `index`: its noise depends on no other row, nor on rows left out.
    pub(super) fn begin_row(&mut self, index: usize) {
        self.random.set_stream(1 + index as u64);
        self.random.set_word_pos(0);
    }

    fn normal(&mut self) -> f64 {
        StandardNormal.sample(&mut self.random)
    }

    /// A factor near 1: relative error of the magnitude and error of the phase.
    fn scatter(&mut self, relative: f64, phase_rad: f64) -> Complex<f64> {
        let magnitude = 1.0 + relative * self.normal();
        Complex::from_polar(magnitude, phase_rad * self.normal())
    }

    /// The row of one point.
    pub(super) fn observe(
        &mut self,
        model: &Model,
        setting: &Setting,
        state: &SteadyState,
    ) -> Point {
        let ambient = self.ambient_tone(model);
        let lines = self.mains_lines(&model.dut);
        let reference = self.see(
            &model.reference,
            model,
            &state.reference,
            setting,
            &[ambient],
        );
        let all = [ambient, lines[0], lines[1], lines[2]];
        let dut = self.see(&model.dut, model, &state.dut, setting, &all);
        let coil_v = if model.amplifier.drift_per_s == 0.0 {
            state.coil_v
        } else {
            Complex::new(state.demand_v, 0.0)
        };
        let u = self.uncertainties;
        let drive = reference.harmonics_v[0] / coil_v * self.scatter(u.drive, u.drive);
        let current = state.coil_a / coil_v * self.scatter(u.current, u.current);
        let ratio = dut.harmonics_v[0] / reference.harmonics_v[0]
            * self.scatter(u.ratio, u.phase_deg.to_radians());
        let mut point = conditions_of(setting);
        self.write_fundamentals(&mut point, &reference, drive, current, ratio);
        self.write_rest(&mut point, &reference, &dut);
        point
    }

    fn write_fundamentals(
        &self,
        point: &mut Point,
        reference: &Seen,
        drive: Complex<f64>,
        current: Complex<f64>,
        ratio: Complex<f64>,
    ) {
        let ref_v = reference.harmonics_v[0].norm() / SQRT_2;
        let coil_v = ref_v / drive.norm();
        point.acceleration_ms2 = Some(ref_v / self.reference_v_per_ms2);
        point.coil_v = Some(coil_v);
        point.coil_a = Some(coil_v * current.norm());
        point.coil_a_deg = Some(current.arg().to_degrees());
        point.ref_v = Some(ref_v);
        point.ref_deg = Some(drive.arg().to_degrees());
        point.dut_v = Some(ref_v * ratio.norm());
        point.dut_deg = Some(ratio.arg().to_degrees());
    }

    fn write_rest(&mut self, point: &mut Point, reference: &Seen, dut: &Seen) {
        let u = self.uncertainties;
        point.ref_harmonics = Some(self.harmonics(reference));
        point.dut_harmonics = Some(self.harmonics(dut));
        point.ref_dc_v = Some(reference.mean_v + u.dc_v * self.normal());
        point.dut_dc_v = Some(dut.mean_v + u.dc_v * self.normal());
        point.ref_noise_v = Some(reference.noise_rms_v * (1.0 + NOISE_SCATTER * self.normal()));
        point.dut_noise_v = Some(dut.noise_rms_v * (1.0 + NOISE_SCATTER * self.normal()));
        point.u_ratio = Some(u.ratio);
        point.u_phase_deg = Some(u.phase_deg);
        point.u_drive = Some(u.drive);
        point.u_current = Some(u.current);
        point.u_harmonic = Some(u.harmonic);
        point.u_dc_v = Some(u.dc_v);
    }

    /// Harmonics 2 to 5 over the fundamental, relative to its phase.
    fn harmonics(&mut self, seen: &Seen) -> [Harmonic; REPORTED - 1] {
        let fundamental = seen.harmonics_v[0];
        let turn = (fundamental / fundamental.norm()).conj();
        let mut turned = turn;
        let mut list = [Harmonic {
            amplitude: 0.0,
            phase_deg: 0.0,
        }; REPORTED - 1];
        for (harmonic, value) in list.iter_mut().zip(&seen.harmonics_v[1..]) {
            turned *= turn;
            let (re, im) = (self.normal(), self.normal());
            let noise = Complex::new(re, im) * self.uncertainties.harmonic;
            let relative = value / fundamental.norm() * turned + noise;
            *harmonic = Harmonic {
                amplitude: relative.norm(),
                phase_deg: relative.arg().to_degrees(),
            };
        }
        list
    }

    /// The tone of the base's motion, m/s2, in this block.
    fn ambient_tone(&mut self, model: &Model) -> UnlockedTone {
        UnlockedTone {
            rms: model.ambient.tone_rms_ms2,
            frequency_hz: model.ambient.tone_hz,
            phase_rad: self.random.random_range(0.0..TAU),
        }
    }

    /// Lines of the mains in this block, V.
    fn mains_lines(&mut self, channel: &Channel) -> [UnlockedTone; 3] {
        let pickup = channel.pickup;
        std::array::from_fn(|index| UnlockedTone {
            rms: pickup.lines_rms_v[index],
            frequency_hz: pickup.mains_hz * (index + 1) as f64,
            phase_rad: self.random.random_range(0.0..TAU),
        })
    }

    /// A channel over one block: locked part, what leaks of `tones` (the first one in m/s2, the
    /// others in V), and what is left as noise.
    fn see(
        &self,
        channel: &Channel,
        model: &Model,
        state: &ChannelState,
        setting: &Setting,
        tones: &[UnlockedTone],
    ) -> Seen {
        let v_per_ms2 = channel.sensitivity_v_per_ms2 * channel.gain;
        let broadband_v = model.ambient.broadband_rms_ms2 * v_per_ms2;
        let mut power = self.noise_rms_v.powi(2)
            + state.noise_rms_v.powi(2)
            + state.remainder_rms_v.powi(2)
            + broadband_v * broadband_v;
        let mut seen = Seen {
            harmonics_v: state.harmonics_v,
            mean_v: state.mean_v,
            noise_rms_v: 0.0,
        };
        for (index, tone) in tones.iter().enumerate().filter(|(_, tone)| tone.rms > 0.0) {
            let scale = if index == 0 { v_per_ms2 } else { 1.0 };
            let mut left = tone.rms.powi(2);
            for (order, value) in seen.harmonics_v.iter_mut().enumerate() {
                let component_hz = setting.frequency_hz * (order + 1) as f64;
                let leaked = tone.leaked(component_hz, self.block_s);
                *value += leaked * scale;
                left -= leaked.norm_sqr() / 2.0;
            }
            let mean = tone.mean(self.block_s);
            seen.mean_v += mean * scale;
            left -= mean * mean;
            power += left.max(0.0) * scale * scale;
        }
        seen.noise_rms_v = power.sqrt();
        seen
    }
}

fn conditions_of(setting: &Setting) -> Point {
    Point {
        run: setting.run,
        frequency_hz: setting.frequency_hz,
        time_s: Some(setting.time_s),
        temperature_c: Some(setting.temperature_c),
        rotation_deg: Some(setting.rotation_deg),
        tilt_deg: Some(setting.tilt_deg),
        payload_kg: Some(setting.payload_kg),
        ..Point::default()
    }
}
