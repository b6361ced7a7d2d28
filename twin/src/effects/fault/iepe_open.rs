//! An IEPE cable that opens: the supply's compliance voltage takes the bias's place.

use super::super::{Effect, Parameter, Stage};
use super::{AT_S, CHANNEL, FaultEffect};
use crate::faults::Surge;
/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "iepe_open",
    stage: Stage::Conditioning,
    formula: "signal gone at at_s, bias jumps up and decays",
    parameters: &[
        CHANNEL,
        AT_S,
        Parameter::new("jump_v", "V", [0.0, 30.0], 12.0),
        Parameter::new("decay_s", "s", [1e-3, 100.0], 1.0),
    ],
    apply: |values, faults| {
        faults.channel(values[0]).surge = Some(Surge {
            at_s: values[1],
            volt: values[2],
            time_constant_s: values[3],
        });
    },
};
