//! Damping that grows with the square of the velocity.
//!
//! Stated for a velocity `w0 x` of unit amplitude.

use super::{OscillatorAction, OscillatorEffect};
use crate::effects::{Parameter, Stage};

/// See the module.
pub(super) const EFFECT: OscillatorEffect = OscillatorEffect {
    id: "cubic_damping",
    stage: Stage::Exciter,
    formula: "2 delta w0 x' (1 + d3 (x'/w0)^2)",
    parameters: &[Parameter::new("d3", "1/output2", [-1e6, 1e6], 3.0)],
    apply: (|values, oscillator| {
        oscillator.cubic_damping += values[0];
    }) as OscillatorAction,
};
