//! Resonance of the device under test.
//!
//! The seismic oscillator of ISO 16063-43 formula (1) inside the device: its sensitivity rises towards
//! the resonance, as `1 / (1 - q^2 + j q/Q)` with `q = f/fr`, and its harmonics rise with it.

use super::{Effect, Parameter, Stage};
use crate::model::{SecondOrder, Section};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "dut_resonance",
    stage: Stage::Dut,
    formula: "r = 1/(1 - (f/fr)^2 + j f/(Q fr))",
    parameters: &[
        Parameter::new("resonance_hz", "Hz", [2e3, 120e3], 30e3),
        Parameter::new("quality", "1", [0.5, 1000.0], 25.0),
    ],
    apply: |values, _conditions, model| {
        let section = SecondOrder::low_pass(values[0], values[1]);
        model.dut.response.push(Section::SecondOrder(section));
    },
};
