//! Even-order distortion of the power amplifier.
//!
//! Unequal halves of the output stage; the d.c. they make does not pass the coupling.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "amplifier_even_order",
    stage: Stage::Amplifier,
    formula: "coil voltage e + b e^2: H2 ~ V in both channels",
    parameters: &[Parameter::new("even_per_v", "1/V", [-1.0, 1.0], 1e-3)],
    apply: |values, _conditions, model| {
        model.amplifier.even_per_v += values[0];
    },
};
