//! An armature that strikes its stop: a weak spring, a wrong payload, too much travel.

use super::super::{Effect, Parameter, Stage};
use super::FaultEffect;
use crate::faults::BodyFault;
/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "armature_stop",
    stage: Stage::Exciter,
    formula: "travel ends at a stop, velocity comes back with restitution",
    parameters: &[
        Parameter::new("travel_m", "m", [1e-6, 1.0], 5e-4),
        Parameter::new("restitution", "1", [0.0, 1.0], 0.4),
    ],
    apply: |values, faults| {
        faults.body.push(BodyFault::Stop {
            travel_m: values[0],
            restitution: values[1],
        });
    },
};
