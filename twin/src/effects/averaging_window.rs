//! Mean over a window in the device's conditioner.
//!
//! Digital sensors and boxcar filters report the mean of the past window, and report it late.

use super::{Effect, Parameter, Stage};
use crate::model::Section;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "averaging_window",
    stage: Stage::Conditioning,
    formula: "r = sinc(f T) exp(-j pi f T)",
    parameters: &[Parameter::new("duration_s", "s", [1e-9, 0.1], 1e-5)],
    apply: |values, _conditions, model| {
        model.dut.response.push(Section::Average(values[0]));
    },
};
