//! High-pass in the output channel.
//!
//! First order, as of an a.c. coupled conditioner.

use super::{OscillatorAction, OscillatorEffect};
use crate::effects::{Parameter, Stage};

/// See the module.
pub(super) const EFFECT: OscillatorEffect = OscillatorEffect {
    id: "output_highpass",
    stage: Stage::Conditioning,
    formula: "s/wc / (1 + s/wc)",
    parameters: &[Parameter::new("corner_hz", "Hz", [1e-5, 1e5], 0.5)],
    apply: (|values, oscillator| {
        oscillator.output_corner_hz = values[0];
    }) as OscillatorAction,
};
