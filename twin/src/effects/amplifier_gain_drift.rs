//! Drift of the power amplifier's gain.
//!
//! Invisible where the coil voltage is measured; otherwise the demanded voltage is recorded instead.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "amplifier_gain_drift",
    stage: Stage::Amplifier,
    formula: "d = 1 + b t, r and z stay (only when the coil voltage is not measured)",
    parameters: &[Parameter::new("drift_per_s", "1/s", [-1e-2, 1e-2], 2e-6)],
    apply: |values, _conditions, model| {
        model.amplifier.drift_per_s += values[0];
    },
};
