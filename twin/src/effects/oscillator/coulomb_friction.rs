//! Dry friction.
//!
//! A constant force against the velocity, stated as the deflection it would hold.

use super::{OscillatorAction, OscillatorEffect};
use crate::effects::{Parameter, Stage};

/// See the module.
pub(super) const EFFECT: OscillatorEffect = OscillatorEffect {
    id: "coulomb_friction",
    stage: Stage::Exciter,
    formula: "x'' + ... + w0^2 xc sign(x')",
    parameters: &[Parameter::new("deflection", "output", [0.0, 1e6], 0.01)],
    apply: (|values, oscillator| {
        oscillator.friction += values[0];
    }) as OscillatorAction,
};
