//! A power amplifier that loses its supply: its output saturates.

use super::super::{Effect, Parameter, Stage};
use super::{AT_S, FaultEffect};
use crate::faults::DriveFault;
/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "amplifier_rail",
    stage: Stage::Amplifier,
    formula: "coil voltage saturates at a threshold from at_s on",
    parameters: &[AT_S, Parameter::new("threshold_v", "V", [0.0, 100.0], 0.5)],
    apply: |values, faults| {
        faults.drive.push(DriveFault::Clipping {
            at_s: values[0],
            threshold_v: values[1],
        });
    },
};
