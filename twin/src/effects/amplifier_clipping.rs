//! Power amplifier at its supply rails.
//!
//! The coil voltage stays at the threshold above it; the coil turns the corners into harmonics of the motion.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "amplifier_clipping",
    stage: Stage::Amplifier,
    formula: "coil voltage saturates at a threshold: odd harmonics in both channels",
    parameters: &[Parameter::new("threshold_v", "V", [1e-3, 1e4], 15.0)],
    apply: |values, _conditions, model| {
        model.amplifier.threshold_v = model.amplifier.threshold_v.min(values[0]);
    },
};
