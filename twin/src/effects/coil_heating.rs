//! Coil that warms up under load.
//!
//! The resistance of copper rises by 0.39 % per kelvin while the coil approaches its final temperature.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "coil_heating",
    stage: Stage::Exciter,
    formula: "R (1 + 0.0039 dT (1 - exp(-t/tau)))",
    parameters: &[
        Parameter::new("rise_k", "K", [0.0, 300.0], 15.0),
        Parameter::new("time_constant_s", "s", [1.0, 1e5], 900.0),
    ],
    apply: |values, _conditions, model| {
        model.coil.rise_k = values[0];
        model.coil.rise_time_constant_s = values[1];
    },
};
