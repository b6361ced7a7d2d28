//! A transducer that gives nothing any more.

use super::super::{Effect, Stage};
use super::{AT_S, CHANNEL, FaultEffect};

/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "transducer_dead",
    stage: Stage::Reference,
    formula: "signal 0 from at_s on",
    parameters: &[CHANNEL, AT_S],
    apply: |values, faults| {
        faults.channel(values[0]).dead_from_s = Some(values[1]);
    },
};
