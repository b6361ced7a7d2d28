//! Input that saturates after it is recorded.
//!
//! The amplifier that drives the oscillator runs into its rails.

use super::{OscillatorAction, OscillatorEffect};
use crate::effects::{Parameter, Stage};

/// See the module.
pub(super) const EFFECT: OscillatorEffect = OscillatorEffect {
    id: "input_saturation",
    stage: Stage::Amplifier,
    formula: "clip(a, +-a0)",
    parameters: &[Parameter::new("threshold", "input", [1e-9, 1e9], 0.1)],
    apply: (|values, oscillator| {
        oscillator.input_threshold = oscillator.input_threshold.min(values[0]);
    }) as OscillatorAction,
};
