//! High-pass of the reference's conditioner.
//!
//! As in the device, so the ratio shows its inverse and the drive transfer the high-pass itself.

use super::{Effect, Parameter, Stage};
use crate::model::Section;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "reference_highpass",
    stage: Stage::Conditioning,
    formula: "1/r = j f/fc / (1 + j f/fc), the same in d",
    parameters: &[Parameter::new("corner_hz", "Hz", [1e-5, 1e3], 0.8)],
    apply: |values, _conditions, model| {
        model.reference.response.push(Section::HighPass(values[0]));
    },
};
