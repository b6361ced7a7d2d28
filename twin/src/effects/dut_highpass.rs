//! High-pass of the device's conditioner.
//!
//! First order: a charge amplifier's time constant or an IEPE coupling capacitor.

use super::{Effect, Parameter, Stage};
use crate::model::Section;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "dut_highpass",
    stage: Stage::Conditioning,
    formula: "r = j f/fc / (1 + j f/fc)",
    parameters: &[Parameter::new("corner_hz", "Hz", [1e-5, 1e3], 0.8)],
    apply: |values, _conditions, model| {
        model.dut.response.push(Section::HighPass(values[0]));
    },
};
