//! Strain of the mounting face, sensed by the device.
//!
//! The face bends where the suspension pulls, at low frequency, and the more the heavier the payload
//! (stated for 40 g).

use super::{Effect, Parameter, Stage};
use crate::model::Section;

/// Payload for which the strain is stated, kg.
const STATED_PAYLOAD_KG: f64 = 0.040;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "base_strain",
    stage: Stage::Mount,
    formula: "r = 1 + s (payload/40 g)/(1 + (f/f1)^2)",
    parameters: &[
        Parameter::new("strain", "1", [-0.3, 0.3], 0.01),
        Parameter::new("corner_hz", "Hz", [5.0, 200.0], 30.0),
    ],
    apply: |values, conditions, model| {
        let gain = values[0] * conditions.payload_kg / STATED_PAYLOAD_KG;
        model.dut.motion.push(Section::Strain {
            gain,
            corner_hz: values[1],
        });
    },
};
