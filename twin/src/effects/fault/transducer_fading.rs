//! A transducer whose sensitivity changes fast: a leak of charge, a crack, a mount that lets go.

use super::super::{Effect, Parameter, Stage};
use super::{AT_S, CHANNEL, FaultEffect};
use crate::faults::Fade;
/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "transducer_fading",
    stage: Stage::Reference,
    formula: "sensitivity 1 + per_s t from at_s on",
    parameters: &[
        CHANNEL,
        AT_S,
        Parameter::new("per_s", "1/s", [-100.0, 100.0], -0.2),
    ],
    apply: |values, faults| {
        faults.channel(values[0]).fade = Some(Fade {
            at_s: values[1],
            per_s: values[2],
        });
    },
};
