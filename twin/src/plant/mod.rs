//! The plant: everything analogue between the drive converter and the input converters.
//!
//! ```text
//! drive code -> hold -> reconstruction low-pass -> power amplifier -> moving coil -> acceleration
//!    acceleration -> reference -> conditioner -> anti-alias -> + noise -> 16-bit code
//!    acceleration -> device    -> conditioner -> anti-alias -> + noise -> 16-bit code
//! ```
//!
//! Time domain, f64. The linear part is one state space, stepped exactly for an input that is held
//! between two conversions, which it is: no integration error at any frequency. Effects that are
//! linear change that state space; nonlinear ones drive it as further inputs (`bends`), in
//! steps of a quarter of a sample period.

mod bends;
mod codes;
pub mod network;
mod realise;
mod sampler;
mod simulation;
mod stepper;
mod wiring;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rigless::snapshot::{Error, Reader, Writer};

use self::codes::{input_code, input_v};
use self::sampler::{Sampled, Sampler};
use self::simulation::Simulation;
use crate::converters::{self, Dithering, DriveConverter, InputConverter, Sheet};
use crate::faults::{BodyFault, Faults};
use crate::model::Model;
use crate::rig::Rig;
use crate::rig_port::{AIR_C, Conversions, Dither, INPUT_CHANNELS, RigPort, SELF_HEATING_K};

/// A simulated rig at work.
///
/// # Timing
/// One hold of a sample period and one sample take about 0.2 us on a present-day core: `./run bench
/// speed`. With nonlinear effects about 2 us.
#[derive(Clone, Debug)]
pub struct Plant {
    rig: Rig,
    simulation: Simulation,
    samplers: [Sampler; INPUT_CHANNELS],
    drive: DriveConverter,
    conversions: Conversions,
    dithering: Dithering,
    noise: ChaCha8Rng,
    /// Faults, and the body as it is by now.
    faults: Faults,
    model: Model,
}

impl Plant {
    /// The rig with its effects, at rest, its drive at 0 V for ever; time goes on from that of its
    /// surroundings.
    pub fn new(rig: &Rig) -> Self {
        let model = rig.model();
        let start_s = rig.surroundings.time_s;
        let mut faults = Faults::default();
        for fault in &rig.faults {
            fault.add_to(&mut faults);
        }
        let parts = &rig.converter;
        let sheet = Sheet::new(parts.errors);
        let sampler = |nth, channel, sensing| {
            let full_scale_peak_v = parts.input_full_scale_peak_v;
            let converter =
                InputConverter::new(sheet, parts.shape, full_scale_peak_v, parts.unit, nth);
            Sampler::new(&model, channel, sensing, converter, start_s)
        };
        Self {
            simulation: Simulation::new(&model, &rig.converter, start_s, rig.noise_seed),
            samplers: [
                sampler(0, &model.reference, &rig.reference),
                sampler(1, &model.dut, &rig.dut),
            ],
            drive: DriveConverter::new(sheet, rig.amplifier.full_scale_peak_v, parts.unit),
            conversions: Conversions::default(),
            dithering: Dithering::new(parts.dither_peak_v),
            noise: ChaCha8Rng::seed_from_u64(rig.noise_seed),
            rig: rig.clone(),
            faults,
            model,
        }
    }

    /// The rig this plant simulates.
    pub fn rig(&self) -> &Rig {
        &self.rig
    }

    /// Voltage at the coil at this instant, V.
    pub fn coil_v(&self) -> f64 {
        self.simulation.coil_v()
    }

    /// Coil current at this instant, A.
    pub fn current_a(&self) -> f64 {
        self.simulation.instant().current_a
    }

    /// Travel of the armature from its unloaded position at this instant, m.
    pub fn travel_m(&self) -> f64 {
        self.simulation.instant().travel_m
    }

    /// Acceleration of the table at this instant, m/s2.
    pub fn acceleration_ms2(&self) -> f64 {
        self.simulation.acceleration_ms2()
    }

    /// Volts at both input converters at this instant, without noise and offset.
    pub fn converter_v(&self) -> [f64; INPUT_CHANNELS] {
        self.simulation.converters_v()
    }

    /// As [`RigPort::hold`] with the voltage of an ideal drive converter.
    pub fn hold_volt(&mut self, drive_v: f64, duration_ns: u64) {
        let elapsed_s = self.simulation.elapsed_s();
        self.change_body(elapsed_s);
        self.dithering.advance(duration_ns);
        let coil_v = self.faults.drive_v(drive_v, elapsed_s);
        self.simulation.hold(coil_v, duration_ns);
        for fault in &self.faults.body {
            if let &BodyFault::Stop {
                travel_m,
                restitution,
            } = fault
            {
                self.simulation.stop_at(travel_m, restitution);
            }
        }
    }

    /// The body becomes another one where a fault is due.
    fn change_body(&mut self, elapsed_s: f64) {
        let due = |fault: &BodyFault| fault.at_s().is_some_and(|at_s| elapsed_s >= at_s);
        let Some(index) = self.faults.body.iter().position(due) else {
            return;
        };
        let fault = self.faults.body.remove(index);
        fault.change(&mut self.model, self.rig.exciter.payload_kg);
        let rig = &self.rig;
        let start_s = rig.surroundings.time_s;
        let mut changed = Simulation::new(&self.model, &rig.converter, start_s, rig.noise_seed);
        changed.succeed(&self.simulation);
        changed.average_over(self.conversions);
        self.simulation = changed;
    }

    /// Faults that are still to change the body of the rig as it was built.
    fn rig_body_faults(&self) -> usize {
        let mut faults = Faults::default();
        for fault in &self.rig.faults {
            fault.add_to(&mut faults);
        }
        faults.body.len()
    }

    /// Code of a channel after its faults.
    fn faulty_code(&self, channel: usize, code: u16, elapsed_s: f64) -> u16 {
        let faults = &self.faults.channels[channel];
        if faults.is_none() {
            return code;
        }
        let volt = faults.volt(input_v(&self.rig.converter, code), elapsed_s);
        input_code(&self.rig.converter, volt)
    }
}

impl RigPort for Plant {
    fn hold(&mut self, drive_code: u16, duration_ns: u64) {
        let drive_v = self.drive.volt(drive_code);
        self.hold_volt(drive_v, duration_ns);
    }

    fn set_conversions(&mut self, conversions: Conversions) {
        self.conversions = conversions;
        self.simulation.average_over(conversions);
        for sampler in &mut self.samplers {
            sampler.set_conversions(conversions);
        }
    }

    fn set_dither(&mut self, dither: Option<Dither>) {
        self.dithering.set(dither);
    }

    fn set_drive_buffer(&mut self, on: bool) {
        self.drive.buffer(on);
    }

    fn sample(&mut self) -> [u16; INPUT_CHANNELS] {
        let simulation = &self.simulation;
        let elapsed_s = simulation.elapsed_s();
        let dither_v = self.dithering.at(self.conversions);
        let volts = simulation.converters_v();
        let slopes = match self.samplers.iter().any(Sampler::needs_slope) {
            true => simulation.converters_v_per_s(),
            false => [0.0; INPUT_CHANNELS],
        };
        let ripple = converters::ripple(self.samplers[0].time_s(elapsed_s));
        let mut codes = [0; INPUT_CHANNELS];
        for (channel, code) in codes.iter_mut().enumerate() {
            let sampler = &mut self.samplers[channel];
            let sampled = Sampled {
                volt: volts[channel],
                volt_per_s: match sampler.needs_slope() {
                    true => slopes[channel],
                    false => 0.0,
                },
                face_m2s4: simulation.face_m2s4(channel),
                other_v: volts[1 - channel],
                ripple,
            };
            *code = sampler.code(sampled, dither_v, elapsed_s, &mut self.noise);
        }
        std::array::from_fn(|channel| self.faulty_code(channel, codes[channel], elapsed_s))
    }

    fn store(&self, to: &mut Writer) -> Result<(), Error> {
        if self.faults.body.len() != self.rig_body_faults() {
            return Err(Error::Unsaved("a rig whose body has become another one"));
        }
        to.put(&self.noise.get_word_pos())?;
        to.put(&self.dithering.played())?;
        to.put(&self.simulation.motion())
    }

    fn load(&mut self, from: &mut Reader) -> Result<(), Error> {
        self.noise.set_word_pos(from.take()?);
        self.dithering.set(from.take()?);
        self.simulation.go_on(from.take()?);
        Ok(())
    }

    fn processor_c(&self) -> f64 {
        let elapsed_s = self.simulation.elapsed_s();
        match self.faults.processor_c {
            Some((at_s, celsius)) if elapsed_s >= at_s => celsius,
            _ => AIR_C + self.rig.surroundings.warmer_k + SELF_HEATING_K,
        }
    }
}

#[cfg(test)]
mod effect_tests;
#[cfg(test)]
mod tests;
