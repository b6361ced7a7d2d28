//! Damping of the suspension other than nominal.
//!
//! Viscous, in parallel to the nominal one.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "mechanical_damping",
    stage: Stage::Exciter,
    formula: "added force dc x velocity: 2 zeta q near f0",
    parameters: &[Parameter::new(
        "added_damping_ns_per_m",
        "N s/m",
        [-1e3, 1e4],
        3.0,
    )],
    apply: |values, _conditions, model| {
        model.coil.damping_ns_per_m += values[0];
    },
};
