//! Force factor that falls with travel.
//!
//! The coil leaves the gap: less force per ampere and less induced voltage at large travel.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "force_factor_droop",
    stage: Stage::Exciter,
    formula: "Bl(x) = Bl0 (1 - b2 x^2): force and back-EMF fall",
    parameters: &[Parameter::new("b2_per_m2", "1/m2", [0.0, 1e9], 2e4)],
    apply: |values, _conditions, model| {
        model.coil.droop_per_m2 += values[0];
    },
};
