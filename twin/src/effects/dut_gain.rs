//! A constant error of the device's gain.
//!
//! The measurand itself: never identifiable without a second reference.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "dut_gain",
    stage: Stage::Dut,
    formula: "r = 1 + g",
    parameters: &[Parameter::new("gain", "1", [-0.9, 10.0], 0.01)],
    apply: |values, _conditions, model| {
        model.dut.gain *= 1.0 + values[0];
    },
};
