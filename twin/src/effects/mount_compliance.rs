//! Contact stiffness between table and device.
//!
//! The mounted mass on the contact spring is a resonator at `fm = sqrt(km/m)/2pi`, which a heavier
//! payload lowers.

use std::f64::consts::TAU;

use super::{Effect, Parameter, Stage};
use crate::model::{SecondOrder, Section};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "mount_compliance",
    stage: Stage::Mount,
    formula: "r = 1/(1 - (f/fm)^2 + j f/(Q fm)), fm = sqrt(km/payload)/2pi",
    parameters: &[
        Parameter::new("stiffness_n_per_m", "N/m", [1e5, 1e12], 2e9),
        Parameter::new("quality", "1", [0.5, 1000.0], 20.0),
    ],
    apply: |values, conditions, model| {
        let mounted_hz = (values[0] / conditions.payload_kg).sqrt() / TAU;
        let section = SecondOrder::low_pass(mounted_hz, values[1]);
        model.dut.motion.push(Section::SecondOrder(section));
    },
};
