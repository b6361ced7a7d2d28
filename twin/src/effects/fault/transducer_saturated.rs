//! A transducer or its amplifier driven beyond its range, far from the converter's.

use super::super::{Effect, Parameter, Stage};
use super::{AT_S, CHANNEL, FaultEffect};

/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "transducer_saturated",
    stage: Stage::Conditioning,
    formula: "signal saturates at threshold_v from at_s on",
    parameters: &[
        CHANNEL,
        AT_S,
        Parameter::new("threshold_v", "V", [1e-6, 10.0], 0.1),
    ],
    apply: |values, faults| {
        faults.channel(values[0]).saturation = Some((values[2], values[1]));
    },
};
