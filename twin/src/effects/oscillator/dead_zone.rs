//! Play of the spring.
//!
//! No restoring force until the deflection leaves a band around zero.

use super::{OscillatorAction, OscillatorEffect};
use crate::effects::{Parameter, Stage};

/// See the module.
pub(super) const EFFECT: OscillatorEffect = OscillatorEffect {
    id: "dead_zone",
    stage: Stage::Exciter,
    formula: "w0^2 (x - clip(x, +-x0))",
    parameters: &[Parameter::new("half_width", "output", [0.0, 1e6], 0.005)],
    apply: (|values, oscillator| {
        oscillator.dead_zone += values[0];
    }) as OscillatorAction,
};
