//! A device under test that falls off: the moving mass changes, its signal ends.

use super::super::{Effect, Stage};
use super::{AT_S, FaultEffect};
use crate::faults::BodyFault;
/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "dut_falls_off",
    stage: Stage::Mount,
    formula: "payload gone and its signal 0 from at_s on",
    parameters: &[AT_S],
    apply: |values, faults| {
        faults.body.push(BodyFault::FallsOff { at_s: values[0] });
        faults.channels[1].dead_from_s = Some(values[0]);
    },
};
