//! First-order low-pass of the device's conditioner.
//!
//! A cable's capacitance on a resistor.

use super::{Effect, Parameter, Stage};
use crate::model::Section;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "dut_lowpass_1",
    stage: Stage::Conditioning,
    formula: "r = 1 / (1 + j f/fc)",
    parameters: &[Parameter::new("corner_hz", "Hz", [100.0, 1e9], 80e3)],
    apply: |values, _conditions, model| {
        model.dut.response.push(Section::LowPass(values[0]));
    },
};
