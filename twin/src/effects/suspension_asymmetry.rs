//! Suspension that is softer to one side.
//!
//! A quadratic term about the unloaded position. The weight of armature and payload shifts the working
//! point, so tilt and payload change stiffness, resonance and second harmonic.

use super::{Effect, Parameter, Stage};
use crate::model::FREE_FALL_MS2;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "suspension_asymmetry",
    stage: Stage::Exciter,
    formula: "restoring force k1 x + k2 x^2 about the unloaded position, sag -M g cos(tilt)/k1: H2, f0 moves with tilt and payload",
    parameters: &[Parameter::new("k2_n_per_m2", "N/m2", [-1e10, 1e10], 3e5)],
    apply: |values, conditions, model| {
        model.coil.quadratic_n_per_m2 += values[0];
        model.coil.static_force_n = -model.coil.mass_kg * FREE_FALL_MS2 * conditions.tilt_rad.cos();
    },
};
