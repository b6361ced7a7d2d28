//! Input that acts later than it is recorded.
//!
//! A filter or a multiplexed converter in the input channel.

use super::{OscillatorAction, OscillatorEffect};
use crate::effects::{Parameter, Stage};

/// See the module.
pub(super) const EFFECT: OscillatorEffect = OscillatorEffect {
    id: "input_delay",
    stage: Stage::Conditioning,
    formula: "a(t - tau)",
    parameters: &[Parameter::new("tau_s", "s", [0.0, 1.0], 3e-4)],
    apply: (|values, oscillator| {
        oscillator.input_delay_s += values[0];
    }) as OscillatorAction,
};
