//! Second-order low-pass of the device's conditioner.
//!
//! Bessel to slightly peaked; a quality factor above 1 is a resonance, not a filter.

use super::{Effect, Parameter, Stage};
use crate::model::{SecondOrder, Section};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "dut_lowpass_2",
    stage: Stage::Conditioning,
    formula: "r = 1 / (1 - (f/fc)^2 + j f/(Q fc)), Q 0.5..1",
    parameters: &[
        Parameter::new("corner_hz", "Hz", [100.0, 1e7], 50e3),
        Parameter::new("quality", "1", [0.5, 1.0], 0.7),
    ],
    apply: |values, _conditions, model| {
        let section = SecondOrder::low_pass(values[0], values[1]);
        model.dut.response.push(Section::SecondOrder(section));
    },
};
