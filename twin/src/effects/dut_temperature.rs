//! Temperature coefficient of the device under test.
//!
//! Sensitivity changes in proportion to the temperature above the reference temperature.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "dut_temperature",
    stage: Stage::Dut,
    formula: "r = 1 + alpha (T - T0)",
    parameters: &[Parameter::new("alpha_per_k", "1/K", [-0.05, 0.05], 1e-3)],
    apply: |values, conditions, model| {
        model.dut.gain *= 1.0 + values[0] * conditions.warmer_k;
    },
};
