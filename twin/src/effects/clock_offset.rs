//! Sample clocks of different rate.
//!
//! Two digitisers run apart: the delay of the device's channel grows with time.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "clock_offset",
    stage: Stage::Digitiser,
    formula: "r = exp(-j 2 pi f delta t)",
    parameters: &[Parameter::new("delta", "1", [-1e-2, 1e-2], 5e-11)],
    apply: |values, _conditions, model| {
        model.dut.clock_delta += values[0];
    },
};
