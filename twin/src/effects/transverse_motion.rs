//! Transverse motion seen through transverse sensitivity.
//!
//! The table moves sideways too, at all frequencies by a share and more at a rocking mode; the device
//! has a direction in which it senses that. Rotating it about the axis changes the sign.

use super::{Effect, Parameter, Stage};
use crate::model::{SecondOrder, Section};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "transverse_motion",
    stage: Stage::Mount,
    formula: "r = 1 + (t0 + t1 H(f; fr, Q)) cos(rotation - beta), H a second-order rocking mode",
    parameters: &[
        Parameter::new("t0", "1", [-0.3, 0.3], 0.004),
        Parameter::new("beta_rad", "rad", [-10.0, 10.0], 0.5),
        Parameter::new("t1", "1", [-0.3, 0.3], 0.01),
        Parameter::new("rocking_hz", "Hz", [20.0, 60e3], 2500.0),
        Parameter::new("quality", "1", [0.5, 300.0], 12.0),
    ],
    apply: |values, conditions, model| {
        let direction = (conditions.rotation_rad - values[1]).cos();
        let (still, rocking) = (1.0 + values[0] * direction, values[2] * direction);
        // still + rocking / (1 + p/Q + p^2), over one denominator.
        model.dut.motion.push(Section::SecondOrder(SecondOrder {
            corner_hz: values[3],
            quality_factor: values[4],
            numerator: [still + rocking, still / values[4], still],
        }));
    },
};
