//! A power amplifier that switches off.

use super::super::{Effect, Stage};
use super::{AT_S, FaultEffect};
use crate::faults::DriveFault;
/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "amplifier_off",
    stage: Stage::Amplifier,
    formula: "coil voltage 0 from at_s on",
    parameters: &[AT_S],
    apply: |values, faults| {
        faults.drive.push(DriveFault::Gain {
            at_s: values[0],
            factor: 0.0,
        });
    },
};
