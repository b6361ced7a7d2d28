//! Sensitivity that depends on the level.
//!
//! Domains of a piezoelectric ceramic follow the stress of the whole cycle, so the gain follows the
//! r.m.s. acceleration; if the element is asymmetric, a second harmonic grows alike.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "dut_level_nonlinearity",
    stage: Stage::Dut,
    formula: "r = 1 + gamma A, A = r.m.s. acceleration in m/s2; H2 if asymmetric",
    parameters: &[
        Parameter::new("gamma_per_ms2", "s2/m", [-0.1, 0.1], 1e-4),
        Parameter::new("second_harmonic_per_ms2", "s2/m", [-0.1, 0.1], 0.0),
    ],
    apply: |values, _conditions, model| {
        model.dut.level_gain_per_ms2 += values[0];
        model.dut.level_second_per_ms2 += values[1];
    },
};
