//! Moving mass other than stated.
//!
//! A payload that was not weighed, a cable, an adapter.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "payload_mass",
    stage: Stage::Exciter,
    formula: "M -> M + dm in d",
    parameters: &[Parameter::new("added_mass_kg", "kg", [-10.0, 100.0], 0.005)],
    apply: |values, _conditions, model| {
        model.coil.mass_kg += values[0];
    },
};
