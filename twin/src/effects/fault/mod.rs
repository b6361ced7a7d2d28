//! What breaks on site: one file per fault.
//!
//! Faults are given like effects, as `NAME=PARAM:VALUE,...`, in the list `faults` of a rig file. They
//! act on the rig in time only: no steady state has them. `at_s` counts from the instant the rig was
//! connected.

mod amplifier_gain;
mod amplifier_off;
mod amplifier_rail;
mod armature_stop;
mod cable_intermittent;
mod coil_open;
mod coil_short;
mod dut_falls_off;
mod iepe;
mod iepe_open;
mod iepe_short;
mod instrument_temperature;
mod transducer_dead;
mod transducer_fading;
mod transducer_saturated;

use super::{ActiveEffect, Effect, Library, Parameter};
use crate::faults::Faults;

/// What a fault does; values are in the order of its parameters.
pub type FaultAction = fn(&[f64], &mut Faults);

/// A fault of the library.
pub type FaultEffect = Effect<FaultAction>;

/// A fault with its values.
pub type ActiveFault = ActiveEffect<FaultAction>;

/// When it happens.
const AT_S: Parameter = Parameter::new("at_s", "s", [0.0, 1e6], 0.0);
/// Which channel it happens to: 0 reference, 1 device under test.
const CHANNEL: Parameter = Parameter::new("channel", "0 or 1", [0.0, 1.0], 1.0);

/// All faults, by name.
pub static FAULTS: [FaultEffect; 14] = [
    amplifier_gain::EFFECT,
    amplifier_off::EFFECT,
    amplifier_rail::EFFECT,
    armature_stop::EFFECT,
    cable_intermittent::EFFECT,
    coil_open::EFFECT,
    coil_short::EFFECT,
    dut_falls_off::EFFECT,
    iepe_open::EFFECT,
    iepe_short::EFFECT,
    instrument_temperature::EFFECT,
    transducer_dead::EFFECT,
    transducer_fading::EFFECT,
    transducer_saturated::EFFECT,
];

impl Library for FaultAction {
    fn effects() -> &'static [Effect<Self>] {
        &FAULTS
    }
}

impl ActiveFault {
    /// Adds this fault to `faults`.
    pub fn add_to(&self, faults: &mut Faults) {
        (self.effect.apply)(&self.values, faults);
    }
}
