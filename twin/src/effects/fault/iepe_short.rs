//! An IEPE cable with a short circuit: the bias falls to zero.

use super::super::{Effect, Stage};
use super::{FaultEffect, iepe};

/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "iepe_short",
    stage: Stage::Conditioning,
    formula: "signal gone at at_s, bias jumps down and decays",
    parameters: &iepe::PARAMETERS,
    apply: |values, faults| iepe::surge(values, -1.0, faults),
};
