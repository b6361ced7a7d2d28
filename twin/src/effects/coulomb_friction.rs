//! Dry friction of the armature.
//!
//! A constant force against the motion; where the drive is too weak to break it, the armature sticks.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "coulomb_friction",
    stage: Stage::Exciter,
    formula: "force Fc against the motion, 4 Fc/(pi F): odd harmonics in both channels, as 1/A",
    parameters: &[Parameter::new("friction_n", "N", [0.0, 100.0], 0.02)],
    apply: |values, _conditions, model| {
        model.coil.friction_n += values[0];
    },
};
