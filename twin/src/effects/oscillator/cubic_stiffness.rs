//! Stiffness that grows with the square of the deflection.
//!
//! A symmetric hardening or softening spring: Duffing's oscillator.

use super::{OscillatorAction, OscillatorEffect};
use crate::effects::{Parameter, Stage};

/// See the module.
pub(super) const EFFECT: OscillatorEffect = OscillatorEffect {
    id: "cubic_stiffness",
    stage: Stage::Exciter,
    formula: "w0^2 (x + k3 x^3)",
    parameters: &[Parameter::new("k3", "1/output2", [-1e6, 1e6], 3.0)],
    apply: (|values, oscillator| {
        oscillator.cubic_stiffness += values[0];
    }) as OscillatorAction,
};
