//! Actions of what breaks on site.
//!
//! Faults are given like effects, as `NAME=PARAM:VALUE,...`, in the list `faults` of a rig file. They
//! act on the rig in time only: no steady state has them.

use super::active::ActiveEffect;
use super::effect::{Effect, Library};
use crate::faults::{BodyFault, Contact, DriveFault, Fade, Faults, Surge};
use calib_effects::fault;

/// Action of a fault; values are in the order of its parameters.
pub type FaultAction = fn(&[f64], &mut Faults);

/// A fault of the library.
pub type FaultEffect = Effect<FaultAction>;

/// A fault with its values.
pub type ActiveFault = ActiveEffect<FaultAction>;

static FAULTS: [FaultEffect; 14] = [
    Effect::new(&fault::AMPLIFIER_GAIN, |values, faults| {
        faults.drive.push(DriveFault::Gain {
            at_s: values[0],
            factor: values[1],
        });
    }),
    Effect::new(&fault::AMPLIFIER_OFF, no_voltage),
    Effect::new(&fault::AMPLIFIER_RAIL, |values, faults| {
        faults.drive.push(DriveFault::Clipping {
            at_s: values[0],
            threshold_v: values[1],
        });
    }),
    Effect::new(&fault::ARMATURE_STOP, |values, faults| {
        faults.body.push(BodyFault::Stop {
            travel_m: values[0],
            restitution: values[1],
        });
    }),
    Effect::new(&fault::CABLE_INTERMITTENT, |values, faults| {
        faults.channel(values[0]).contact = Some(Contact {
            at_s: values[1],
            rate_hz: values[2],
            open_fraction: values[3],
        });
    }),
    Effect::new(&fault::COIL_OPEN, |values, faults| {
        faults.body.push(BodyFault::CoilOpens { at_s: values[0] });
    }),
    Effect::new(&fault::COIL_SHORT, no_voltage),
    Effect::new(&fault::DUT_FALLS_OFF, |values, faults| {
        faults.body.push(BodyFault::FallsOff { at_s: values[0] });
        faults.channels[1].dead_from_s = Some(values[0]);
    }),
    Effect::new(&fault::IEPE_OPEN, |values, faults| {
        surge(values, 1.0, faults)
    }),
    Effect::new(&fault::IEPE_SHORT, |values, faults| {
        surge(values, -1.0, faults);
    }),
    Effect::new(&fault::INSTRUMENT_TEMPERATURE, |values, faults| {
        faults.processor_c = Some((values[0], values[1]));
    }),
    Effect::new(&fault::TRANSDUCER_DEAD, |values, faults| {
        faults.channel(values[0]).dead_from_s = Some(values[1]);
    }),
    Effect::new(&fault::TRANSDUCER_FADING, |values, faults| {
        faults.channel(values[0]).fade = Some(Fade {
            at_s: values[1],
            per_s: values[2],
        });
    }),
    Effect::new(&fault::TRANSDUCER_SATURATED, |values, faults| {
        faults.channel(values[0]).saturation = Some((values[2], values[1]));
    }),
];

/// The coil sees no voltage from an instant on.
fn no_voltage(values: &[f64], faults: &mut Faults) {
    faults.drive.push(DriveFault::Gain {
        at_s: values[0],
        factor: 0.0,
    });
}

/// The bias of an IEPE supply jumps up (`direction` 1) or down (-1).
fn surge(values: &[f64], direction: f64, faults: &mut Faults) {
    faults.channel(values[0]).surge = Some(Surge {
        at_s: values[1],
        volt: direction * values[2],
        time_constant_s: values[3],
    });
}

impl Library for FaultAction {
    const OF: calib_effects::Of = calib_effects::Of::Fault;

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
