//! A short circuit at the exciter's terminals: the amplifier limits, the coil sees no voltage.

use super::super::{Effect, Stage};
use super::{AT_S, FaultEffect};
use crate::faults::DriveFault;
/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "coil_short",
    stage: Stage::Exciter,
    formula: "coil voltage 0 from at_s on, the coil brakes through its own resistance",
    parameters: &[AT_S],
    apply: |values, faults| {
        faults.drive.push(DriveFault::Gain {
            at_s: values[0],
            factor: 0.0,
        });
    },
};
