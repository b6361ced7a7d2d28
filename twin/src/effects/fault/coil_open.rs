//! A broken coil or plug: no current, and the armature swings freely.

use super::super::{Effect, Stage};
use super::{AT_S, FaultEffect};
use crate::faults::BodyFault;
/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "coil_open",
    stage: Stage::Exciter,
    formula: "no current, no force from at_s on",
    parameters: &[AT_S],
    apply: |values, faults| {
        faults.body.push(BodyFault::CoilOpens { at_s: values[0] });
    },
};
