//! Tilt of the table in proportion to its travel.
//!
//! A tilted device senses a part of gravity. The travel is `-a / (2 pi f)^2`, so the part grows towards
//! low frequency; the direction of tilt is fixed to the exciter, that of the device turns with it.

use super::{Effect, Parameter, Stage};
use crate::model::Section;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "gravity_tilt",
    stage: Stage::Mount,
    formula: "r = 1 + g cos(rotation) / f^2",
    parameters: &[Parameter::new("tilt_hz2", "Hz2", [-1e4, 1e4], 0.5)],
    apply: |values, conditions, model| {
        model
            .dut
            .motion
            .push(Section::Tilt(values[0] * conditions.rotation_rad.cos()));
    },
};
