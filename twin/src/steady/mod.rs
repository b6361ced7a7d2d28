//! A calibrator in steady state at one frequency: what a model does once all has settled.
//!
//! The moving coil is integrated in time (`coil`), memoryless elements act on samples of one
//! period, and linear elements after them on its harmonics. The level is held as a calibrator holds
//! it: by the fundamental of the reference channel.

mod coil;
mod dry;
mod spectrum;
mod stepping;

use nalgebra::Complex;

use self::coil::SteadyCoil;
use self::spectrum::{Grid, HARMONICS, SILENCE, Spectrum};
use self::stepping::STEPS;
use crate::model::{Channel, Conditions, Model, Section};

/// Highest harmonic that is reported.
pub const REPORTED: usize = 5;

/// Samples per period for static characteristics: a kink is placed to 1/2048 of a period.
const FINE: usize = 2048;

/// Steady state of a channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChannelState {
    /// Mean, V.
    pub mean_v: f64,
    /// Harmonics 1 to 5, V peak, as `Re c e^{j h w t}`.
    pub harmonics_v: [Complex<f64>; REPORTED],
    /// Remainder of the periodic signal after mean and those harmonics, V r.m.s.
    pub remainder_rms_v: f64,
    /// Noise the motion makes, V r.m.s.
    pub noise_rms_v: f64,
}

/// A calibrator in steady state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyState {
    /// Demanded voltage, V peak; its phase is 0.
    pub demand_v: f64,
    /// Fundamental of the coil voltage, V peak.
    pub coil_v: Complex<f64>,
    /// Fundamental of the coil current, A peak.
    pub coil_a: Complex<f64>,
    /// Reference channel.
    pub reference: ChannelState,
    /// Device under test.
    pub dut: ChannelState,
}

/// Why there is no steady state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SteadyError {
    /// The motion does not repeat from period to period.
    #[error(
        "the motion of the exciter does not become periodic at this point; lower the level or the effect"
    )]
    Unsteady,
    /// The level cannot be held.
    #[error("the level cannot be reached at this point; lower the level or the effect")]
    Unreachable,
}

/// Grids shared by all points.
#[derive(Clone, Debug)]
pub struct Solver {
    coarse: Grid,
    fine: Grid,
}

impl Default for Solver {
    fn default() -> Self {
        Self {
            coarse: Grid::new(STEPS),
            fine: Grid::new(FINE),
        }
    }
}

/// Level error that is left, relative. The true level is reported, so it only has to be near.
const LEVEL_TOLERANCE: f64 = 1e-4;
/// Attempts to reach the level.
const LEVEL_ATTEMPTS: usize = 16;

impl Solver {
    /// The steady state at which the reference channel shows `reference_rms_v` at `frequency_hz`.
    ///
    /// # Errors
    /// [`SteadyError`] where the exciter cannot do that.
    pub fn hold(
        &self,
        model: &Model,
        conditions: &Conditions,
        frequency_hz: f64,
        reference_rms_v: f64,
    ) -> Result<SteadyState, SteadyError> {
        let mut point = Point::new(self, model, conditions, frequency_hz)?;
        let target_v = reference_rms_v * std::f64::consts::SQRT_2;
        let mut demand_v = target_v / point.small_signal_gain();
        let mut last: Option<(f64, f64)> = None;
        for _ in 0..LEVEL_ATTEMPTS {
            let state = point.at(demand_v)?;
            let error = (state.reference.harmonics_v[0].norm() / target_v).ln();
            if error.abs() < LEVEL_TOLERANCE {
                return Ok(state);
            }
            let position = demand_v.ln();
            // Secant in logarithms, bounded: a saturated output answers to nothing.
            let slope = last.map_or(1.0, |(before, was)| (error - was) / (position - before));
            let step = -error / slope.clamp(0.1, 10.0);
            last = Some((position, error));
            demand_v = (position + step.clamp(-1.0, 1.0)).exp();
        }
        Err(SteadyError::Unreachable)
    }
}

/// A calibrator at one frequency.
struct Point<'a> {
    solver: &'a Solver,
    model: &'a Model,
    conditions: &'a Conditions,
    frequency_hz: f64,
    coil: SteadyCoil<'a>,
}

impl<'a> Point<'a> {
    fn new(
        solver: &'a Solver,
        model: &'a Model,
        conditions: &'a Conditions,
        frequency_hz: f64,
    ) -> Result<Self, SteadyError> {
        let coil = SteadyCoil::new(&model.coil, frequency_hz, conditions.time_s);
        Ok(Self {
            solver,
            model,
            conditions,
            frequency_hz,
            coil: coil.ok_or(SteadyError::Unsteady)?,
        })
    }

    /// Volts of the reference per volt of demand, without nonlinear terms.
    fn small_signal_gain(&self) -> f64 {
        let omega = std::f64::consts::TAU * self.frequency_hz;
        let [_, travel] = self
            .model
            .coil
            .linear_response(omega, self.conditions.time_s);
        let reference = &self.model.reference;
        let sections = [&self.model.table, &reference.motion, &reference.response];
        let response: f64 = sections
            .iter()
            .map(|list| Section::chain(list, self.frequency_hz).norm())
            .product();
        travel.norm() * omega * omega * response * reference.sensitivity_v_per_ms2 * reference.gain
    }

    /// The steady state at a demanded voltage.
    fn at(&mut self, demand_v: f64) -> Result<SteadyState, SteadyError> {
        let voltage = self.voltage(demand_v);
        let motion = self.coil.motion(&voltage, &self.solver.coarse);
        let motion = motion.ok_or(SteadyError::Unsteady)?;
        let mut table = SILENCE;
        for (order, value) in table.iter_mut().enumerate().skip(1) {
            let omega = std::f64::consts::TAU * self.frequency_hz * order as f64;
            let response = self.response(&self.model.table, order);
            *value = motion.position[order] * response * (-omega * omega);
        }
        Ok(SteadyState {
            demand_v,
            coil_v: voltage[1],
            coil_a: motion.current[1],
            reference: self.channel(&self.model.reference, &table),
            dut: self.channel(&self.model.dut, &table),
        })
    }

    fn response(&self, sections: &[Section], order: usize) -> Complex<f64> {
        Section::chain(sections, self.frequency_hz * order as f64)
    }

    /// Coil voltage for a demand; the output is a.c. coupled.
    fn voltage(&self, demand_v: f64) -> Spectrum {
        let amplifier = &self.model.amplifier;
        let gain = 1.0 + amplifier.drift_per_s * self.conditions.time_s;
        let mut voltage = SILENCE;
        voltage[1].re = demand_v * gain;
        if amplifier.is_linear() {
            return voltage;
        }
        let fine = &self.solver.fine;
        let bend = |volt: &f64| amplifier.output_v(*volt);
        let samples: Vec<f64> = fine.samples(&voltage).iter().map(bend).collect();
        let mut bent = fine.spectrum(&samples, HARMONICS);
        bent[0].re = 0.0;
        bent
    }

    fn channel(&self, channel: &Channel, table: &Spectrum) -> ChannelState {
        let (motion, noise_ms2) = self.motion(channel, table);
        let level_rms_ms2 = motion[1].norm() / std::f64::consts::SQRT_2;
        let mut volt = self.respond(channel, &motion, level_rms_ms2);
        let (mean_v, remainder_rms_v) = self.convert(channel, &mut volt);
        // Jitter turns a share of the signal into noise.
        let omega = std::f64::consts::TAU * self.frequency_hz;
        let kept = (-0.5 * (omega * self.model.jitter_s).powi(2)).exp();
        let jitter_rms_v = volt[1].norm() * ((1.0 - kept * kept) / 2.0).sqrt();
        let mut harmonics_v = [Complex::new(0.0, 0.0); REPORTED];
        for (order, value) in harmonics_v.iter_mut().enumerate() {
            let share = kept.powi(i32::try_from((order + 1).pow(2)).unwrap_or(i32::MAX));
            *value = volt[order + 1] * share;
        }
        let gain = channel.sensitivity_v_per_ms2 * channel.gain;
        ChannelState {
            mean_v,
            harmonics_v,
            remainder_rms_v: remainder_rms_v.hypot(self.dry_beyond_v2(channel).sqrt()),
            noise_rms_v: jitter_rms_v.hypot(noise_ms2 * gain.abs()),
        }
    }

    /// Motion of a transducer and the noise of its impacts, m/s2.
    fn motion(&self, channel: &Channel, table: &Spectrum) -> (Spectrum, f64) {
        let mut motion = SILENCE;
        for (order, value) in motion.iter_mut().enumerate().skip(1) {
            *value = table[order] * self.response(&channel.motion, order);
        }
        let Some(separation) = channel.separation else {
            return (motion, 0.0);
        };
        let fine = &self.solver.fine;
        let mut samples = fine.samples(&motion);
        let excess_ms2 = separation.excess_ms2(motion[1].norm());
        samples
            .iter_mut()
            .for_each(|sample| *sample = separation.motion_ms2(*sample));
        (
            fine.spectrum(&samples, HARMONICS),
            separation.impact_noise * excess_ms2,
        )
    }

    /// Volts at the converter.
    fn respond(&self, channel: &Channel, motion: &Spectrum, level_rms_ms2: f64) -> Spectrum {
        let time_s = self.conditions.time_s;
        let gain = channel.sensitivity_v_per_ms2
            * channel.gain
            * channel.gain_at(time_s)
            * (1.0 + channel.level_gain_per_ms2 * level_rms_ms2);
        let mut felt = *motion;
        // A squared cosine has its second harmonic at twice the phase.
        let turn = motion[1] / motion[1].norm().max(f64::MIN_POSITIVE);
        felt[2] += motion[1] * turn * (channel.level_second_per_ms2 * level_rms_ms2);
        let clock = Section::Delay(channel.clock_delta * time_s);
        let mut volt = SILENCE;
        for (order, value) in volt.iter_mut().enumerate().skip(1) {
            if felt[order] != Complex::new(0.0, 0.0) {
                let late = clock.response(self.frequency_hz * order as f64);
                *value = felt[order] * self.response(&channel.response, order) * late * gain;
            }
        }
        volt
    }

    /// Passes the converter; returns mean and what lies beyond the reported harmonics.
    fn convert(&self, channel: &Channel, volt: &mut Spectrum) -> (f64, f64) {
        let beyond = |spectrum: &Spectrum| {
            let squares = spectrum
                .iter()
                .skip(REPORTED + 1)
                .map(|value| value.norm_sqr());
            (squares.sum::<f64>() / 2.0).sqrt()
        };
        let range = channel.range_gain(volt[1].norm());
        if range != 1.0 {
            volt.iter_mut().for_each(|value| *value *= range);
        }
        if channel.converter == crate::model::Characteristic::IDEAL {
            return (0.0, beyond(volt));
        }
        let fine = &self.solver.fine;
        let bend = |sample: &f64| channel.converter.output_v(*sample);
        let samples: Vec<f64> = fine.samples(volt).iter().map(bend).collect();
        let total = samples.iter().map(|sample| sample * sample).sum::<f64>() / FINE as f64;
        *volt = fine.spectrum(&samples, REPORTED);
        let mean_v = volt[0].re;
        let reported = volt
            .iter()
            .skip(1)
            .map(|value| value.norm_sqr() / 2.0)
            .sum::<f64>();
        (mean_v, (total - mean_v * mean_v - reported).max(0.0).sqrt())
    }
}

#[cfg(test)]
mod tests;
