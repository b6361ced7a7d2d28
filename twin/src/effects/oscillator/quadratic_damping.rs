//! Drag in proportion to the square of the velocity.
//!
//! Air or a liquid around the mass; it opposes the motion in both directions.

use super::{OscillatorAction, OscillatorEffect};
use crate::effects::{Parameter, Stage};

/// See the module.
pub(super) const EFFECT: OscillatorEffect = OscillatorEffect {
    id: "quadratic_damping",
    stage: Stage::Exciter,
    formula: "2 delta w0 x' (1 + d2 |x'|/w0)",
    parameters: &[Parameter::new("d2", "1/output", [-1e6, 1e6], 1.0)],
    apply: (|values, oscillator| {
        oscillator.quadratic_damping += values[0];
    }) as OscillatorAction,
};
