//! Hysteresis of the spring (Bouc-Wen).
//!
//! A part of the force follows a state that yields: loading and unloading differ.

use super::{OscillatorAction, OscillatorEffect};
use crate::effects::{Parameter, Stage};

/// See the module.
pub(super) const EFFECT: OscillatorEffect = OscillatorEffect {
    id: "hysteresis",
    stage: Stage::Exciter,
    formula: "w0^2 (x + alpha z), z' = x' - (|x'| z + x' |z|)/(2 zy)",
    parameters: &[
        Parameter::new("alpha", "1", [-0.9, 10.0], 0.1),
        Parameter::new("yield_deflection", "output", [1e-9, 1e6], 0.03),
    ],
    apply: (|values, oscillator| {
        oscillator.hysteresis = values[0];
        oscillator.yield_deflection = values[1];
    }) as OscillatorAction,
};
