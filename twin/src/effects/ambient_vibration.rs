//! Motion of the base from outside.
//!
//! Traffic, machines and people shake the base: a tone and broadband motion, both transducers alike, not
//! locked to the block.

use super::{Effect, Parameter, Stage};
use crate::model::AmbientMotion;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "ambient_vibration",
    stage: Stage::Environment,
    formula: "a tone (1..30 Hz) and broadband motion of the base, the same in both channels: noise, leakage near the tone",
    parameters: &[
        Parameter::new("broadband_ms2", "m/s2", [0.0, 10.0], 5e-3),
        Parameter::new("tone_ms2", "m/s2", [0.0, 10.0], 0.0),
        Parameter::new("tone_hz", "Hz", [0.5, 45.0], 12.0),
    ],
    apply: |values, _conditions, model| {
        model.ambient = AmbientMotion {
            broadband_rms_ms2: values[0],
            tone_rms_ms2: values[1],
            tone_hz: values[2],
        };
    },
};
