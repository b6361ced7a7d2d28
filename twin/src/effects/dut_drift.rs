//! Drift of the device's sensitivity.
//!
//! Warming up, ageing, discharge of a charge amplifier.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "dut_drift",
    stage: Stage::Dut,
    formula: "r = 1 + b t",
    parameters: &[Parameter::new("drift_per_s", "1/s", [-1e-2, 1e-2], 2e-6)],
    apply: |values, _conditions, model| {
        model.dut.drift_per_s += values[0];
    },
};
