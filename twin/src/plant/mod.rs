//! The plant: everything analogue between the drive converter and the input converters.
//!
//! ```text
//! drive code -> hold -> reconstruction low-pass -> power amplifier -> moving coil -> acceleration
//!    acceleration -> reference -> conditioner -> anti-alias -> + noise -> 16-bit code
//!    acceleration -> device    -> conditioner -> anti-alias -> + noise -> 16-bit code
//! ```
//!
//! Time domain, f64. The linear part is one state space, stepped exactly for an input that is held
//! between two conversions, which it is: no integration error at any frequency.

mod codes;
pub mod network;
mod stepper;
mod wiring;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use self::codes::{drive_v, input_code};
use self::network::Signal;
use self::stepper::Stepper;
use self::wiring::{DRIVE_INPUT, Wiring};
use crate::rig::Rig;
use crate::rig_port::{INPUT_CHANNELS, RigPort};

/// A simulated rig at work.
///
/// # Timing
/// One hold of a sample period and one sample take about 0.2 us on a present-day core: test
/// `a_second_of_plant_takes_a_fraction_of_a_second`.
#[derive(Clone, Debug)]
pub struct Plant {
    rig: Rig,
    stepper: Stepper,
    current: Tap,
    travel: Tap,
    acceleration: Tap,
    converter: [Tap; INPUT_CHANNELS],
    noise: ChaCha8Rng,
}

/// Non-zero coefficients of a signal over (states, inputs).
type Tap = Vec<(usize, f64)>;

impl Plant {
    /// The rig at rest, its drive at 0 V for ever.
    pub fn new(rig: &Rig) -> Self {
        let wiring = Wiring::new(rig);
        let tap = |signal: &Signal| wiring.network.columns(signal);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "1 us..1 ms"
        )]
        let tick_ns = (1e9 / rig.converter.sample_rate_hz).round() as u64;
        Self {
            stepper: Stepper::new(wiring.network.matrix(), tick_ns),
            current: tap(&wiring.current),
            travel: tap(&wiring.travel),
            acceleration: tap(&wiring.acceleration),
            converter: [tap(&wiring.converter[0]), tap(&wiring.converter[1])],
            noise: ChaCha8Rng::seed_from_u64(rig.noise_seed),
            rig: rig.clone(),
        }
    }

    /// The rig this plant simulates.
    pub fn rig(&self) -> &Rig {
        &self.rig
    }

    /// Coil current at this instant, A.
    pub fn current_a(&self) -> f64 {
        self.read(&self.current)
    }

    /// Travel of the table from rest at this instant, m.
    pub fn travel_m(&self) -> f64 {
        self.read(&self.travel)
    }

    /// Acceleration of the table at this instant, m/s2.
    pub fn acceleration_ms2(&self) -> f64 {
        self.read(&self.acceleration)
    }

    /// Volts at both input converters at this instant, without noise and offset.
    pub fn converter_v(&self) -> [f64; INPUT_CHANNELS] {
        [self.read(&self.converter[0]), self.read(&self.converter[1])]
    }

    /// As [`RigPort::hold`] with the voltage of an ideal drive converter.
    pub fn hold_volt(&mut self, drive_v: f64, duration_ns: u64) {
        self.stepper.set_input(DRIVE_INPUT, drive_v);
        self.stepper.advance(duration_ns);
    }

    fn read(&self, tap: &Tap) -> f64 {
        let source = self.stepper.source();
        tap.iter()
            .map(|&(column, factor)| factor * source[column])
            .sum()
    }
}

impl RigPort for Plant {
    fn hold(&mut self, drive_code: u16, duration_ns: u64) {
        self.hold_volt(drive_v(self.rig.amplifier, drive_code), duration_ns);
    }

    fn sample(&mut self) -> [u16; INPUT_CHANNELS] {
        let [reference_v, dut_v] = self.converter_v();
        let mut digitise = |volt: f64, noise_rms_v: f64, offset_v: f64| {
            let unit: f64 = StandardNormal.sample(&mut self.noise);
            input_code(&self.rig.converter, volt + offset_v + noise_rms_v * unit)
        };
        let (reference, dut) = (&self.rig.reference, &self.rig.dut);
        [
            digitise(reference_v, reference.noise_rms_v, reference.offset_v),
            digitise(dut_v, dut.noise_rms_v, dut.offset_v),
        ]
    }
}

#[cfg(test)]
mod tests;
