//! An IEPE cable that opens: the supply's compliance voltage takes the bias's place.

use super::super::{Effect, Stage};
use super::{FaultEffect, iepe};

/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "iepe_open",
    stage: Stage::Conditioning,
    formula: "signal gone at at_s, bias jumps up and decays",
    parameters: &iepe::PARAMETERS,
    apply: |values, faults| iepe::surge(values, 1.0, faults),
};
