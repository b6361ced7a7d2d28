//! Temperature coefficient of the reference.
//!
//! As in the device, so the ratio goes the other way and the drive transfer along.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "reference_temperature",
    stage: Stage::Reference,
    formula: "r = 1 - alpha (T - T0), d the other way",
    parameters: &[Parameter::new("alpha_per_k", "1/K", [-0.05, 0.05], 1e-3)],
    apply: |values, conditions, model| {
        model.reference.gain *= 1.0 + values[0] * conditions.warmer_k;
    },
};
