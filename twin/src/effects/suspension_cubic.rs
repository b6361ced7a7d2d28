//! Suspension that stiffens with travel.
//!
//! Real flexures stiffen symmetrically at large travel: the resonance moves with level and a third
//! harmonic appears in the motion itself, so in both channels.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "suspension_cubic",
    stage: Stage::Exciter,
    formula: "restoring force k1 x + k3 x^3: d near f0, H3 ~ X^2 in both channels",
    parameters: &[Parameter::new("k3_n_per_m3", "N/m3", [-1e14, 1e14], 3e7)],
    apply: |values, _conditions, model| {
        model.coil.cubic_n_per_m3 += values[0];
    },
};
