//! Axial mode of the moving element.
//!
//! The table resonates on the coil former: it moves more than the driven end near the mode.

use super::{Effect, Parameter, Stage};
use crate::model::{SecondOrder, Section};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "armature_mode",
    stage: Stage::Exciter,
    formula: "d and travel of the table x (1 + kappa q^2/(1 - q^2 + 2 j zeta q)), q = f/fa, the same for all payloads",
    parameters: &[
        Parameter::new("kappa", "1", [-3.0, 3.0], 0.3),
        Parameter::new("mode_hz", "Hz", [1e3, 40e3], 8e3),
        Parameter::new("zeta", "1", [5e-4, 0.7], 0.02),
    ],
    apply: |values, _conditions, model| {
        // q^2 = -p^2 and 2 zeta = 1/Q.
        let damping = 2.0 * values[2];
        model.table.push(Section::SecondOrder(SecondOrder {
            corner_hz: values[1],
            quality_factor: 1.0 / damping,
            numerator: [1.0, damping, 1.0 - values[0]],
        }));
    },
};
