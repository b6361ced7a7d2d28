//! Coupling from one channel into the other.
//!
//! Through a capacitance the derivative of the neighbour's signal, through a common resistance the
//! signal itself, with a constant phase if it comes from elsewhere.

use super::{Effect, Parameter, Stage};
use crate::model::Section;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "crosstalk",
    stage: Stage::Conditioning,
    formula: "r = 1 + j f/fx (capacitive) or a constant complex factor (resistive)",
    parameters: &[
        Parameter::new("inverse_fx_s", "s", [-1e-3, 1e-3], 5e-7),
        Parameter::new("in_phase", "1", [-0.5, 0.5], 0.0),
        Parameter::new("quadrature", "1", [-0.5, 0.5], 0.0),
    ],
    apply: |values, _conditions, model| {
        model.dut.response.push(Section::Coupling {
            inverse_fx_s: values[0],
            in_phase: values[1],
            quadrature: values[2],
        });
    },
};
