//! Resonance of the reference transducer.
//!
//! As in the device, so the ratio shows its inverse and the drive transfer the resonance itself.

use super::{Effect, Parameter, Stage};
use crate::model::{SecondOrder, Section};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "reference_resonance",
    stage: Stage::Reference,
    formula: "1/r = 1/(1 - (f/fr)^2 + j f/(Q fr)), the same in d",
    parameters: &[
        Parameter::new("resonance_hz", "Hz", [2e3, 120e3], 30e3),
        Parameter::new("quality", "1", [0.5, 1000.0], 25.0),
    ],
    apply: |values, _conditions, model| {
        let section = SecondOrder::low_pass(values[0], values[1]);
        model.reference.response.push(Section::SecondOrder(section));
    },
};
