//! Drift of the reference's sensitivity.
//!
//! A rising ratio is a falling reference: the sign is that of the ratio.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "reference_drift",
    stage: Stage::Reference,
    formula: "r = 1 + b t, d the other way",
    parameters: &[Parameter::new("drift_per_s", "1/s", [-1e-2, 1e-2], 2e-6)],
    apply: |values, _conditions, model| {
        model.reference.drift_per_s -= values[0];
    },
};
