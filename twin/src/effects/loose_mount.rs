//! A loose device that lifts off.
//!
//! When the table falls away faster than the mounting pulls, the device stays behind: its acceleration
//! is cut on one side at a threshold, and above it impacts add noise in proportion to the excess. With
//! `weight` 1 the threshold is that of a vertical axis and tilting takes the weight away.

use super::{Effect, Parameter, Stage};
use crate::model::{FREE_FALL_MS2, Separation};

/// A device that has lost its weight still sticks a little, m/s2.
const LEAST_THRESHOLD_MS2: f64 = 0.2;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "loose_mount",
    stage: Stage::Mount,
    formula: "acceleration of the device cut on one side at a threshold, impact noise above it",
    parameters: &[
        Parameter::new("threshold_ms2", "m/s2", [0.5, 300.0], 15.0),
        Parameter::new("impact_noise", "1", [0.0, 3.0], 0.01),
        Parameter::new("upper", "0 or 1", [0.0, 1.0], 0.0),
        Parameter::new("weight", "0 or 1", [0.0, 1.0], 0.0),
    ],
    apply: |values, conditions, model| {
        let lifted_ms2 = values[3] * FREE_FALL_MS2 * (1.0 - conditions.tilt_rad.cos());
        model.dut.separation = Some(Separation {
            threshold_ms2: (values[0] - lifted_ms2).max(LEAST_THRESHOLD_MS2),
            upper: values[2] >= 0.5,
            impact_noise: values[1],
        });
    },
};
