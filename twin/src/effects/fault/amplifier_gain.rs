//! A power amplifier whose gain is wrong: another range, a failed feedback.

use super::super::{Effect, Parameter, Stage};
use super::{AT_S, FaultEffect};
use crate::faults::DriveFault;
/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "amplifier_gain",
    stage: Stage::Amplifier,
    formula: "coil voltage times factor from at_s on",
    parameters: &[AT_S, Parameter::new("factor", "1", [0.0, 10.0], 2.0)],
    apply: |values, faults| {
        faults.drive.push(DriveFault::Gain {
            at_s: values[0],
            factor: values[1],
        });
    },
};
