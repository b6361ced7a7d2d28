//! Induced voltage other than force factor times velocity.
//!
//! A shorted turn or eddy currents in the gap: the transducer is not reciprocal.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "back_emf",
    stage: Stage::Exciter,
    formula: "induced voltage (1 + beta) Bl x velocity: damping Bl^2/Z differs from nominal",
    parameters: &[Parameter::new("beta", "1", [-0.95, 10.0], 0.15)],
    apply: |values, _conditions, model| {
        model.coil.emf_ratio *= 1.0 + values[0];
    },
};
