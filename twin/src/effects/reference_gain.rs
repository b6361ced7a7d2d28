//! A constant error of the reference's gain.
//!
//! Shared with the measurand: never identifiable without a second reference.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "reference_gain",
    stage: Stage::Reference,
    formula: "r = 1/(1 + g), d the other way",
    parameters: &[Parameter::new("gain", "1", [-0.9, 10.0], 0.01)],
    apply: |values, _conditions, model| {
        model.reference.gain *= 1.0 + values[0];
    },
};
