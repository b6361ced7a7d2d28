//! Spring that is softer to one side.
//!
//! An asymmetric spring: even harmonics and a mean deflection.

use super::{OscillatorAction, OscillatorEffect};
use crate::effects::{Parameter, Stage};

/// See the module.
pub(super) const EFFECT: OscillatorEffect = OscillatorEffect {
    id: "quadratic_stiffness",
    stage: Stage::Exciter,
    formula: "w0^2 (x + k2 x^2)",
    parameters: &[Parameter::new("k2", "1/output", [-1e6, 1e6], 0.3)],
    apply: (|values, oscillator| {
        oscillator.quadratic_stiffness += values[0];
    }) as OscillatorAction,
};
