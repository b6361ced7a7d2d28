//! A second mode of vibration.
//!
//! It is driven by the same input and adds to the output.

use super::{OscillatorAction, OscillatorEffect};
use crate::effects::{Parameter, Stage};

/// See the module.
pub(super) const EFFECT: OscillatorEffect = OscillatorEffect {
    id: "second_mode",
    stage: Stage::Exciter,
    formula: "y = x + x2, x2'' + 2 d2 w2 x2' + w2^2 x2 = g rho a",
    parameters: &[
        Parameter::new("gain", "1", [-100.0, 100.0], 0.1),
        Parameter::new("mode_hz", "Hz", [1e-3, 1e6], 150.0),
        Parameter::new("damping", "1", [1e-5, 1.0], 0.02),
    ],
    apply: (|values, oscillator| {
        oscillator.second_gain = values[0];
        oscillator.second_hz = values[1];
        oscillator.second_damping = values[2];
    }) as OscillatorAction,
};
