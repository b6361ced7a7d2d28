//! Mains in the device's channel.
//!
//! Lines at multiples of the mains frequency, not locked to the block: they add to the noise and leak
//! into components near them, each time with another phase.

use super::{Effect, Parameter, Stage};
use crate::model::Pickup;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "mains_pickup",
    stage: Stage::Conditioning,
    formula: "lines at n x mains in the DUT channel: noise, and leakage into components near n x mains",
    parameters: &[
        Parameter::new("pickup_v", "V", [0.0, 1.0], 1e-3),
        Parameter::new("second_v", "V", [0.0, 1.0], 2e-4),
        Parameter::new("third_v", "V", [0.0, 1.0], 4e-4),
    ],
    apply: |values, conditions, model| {
        model.dut.pickup = Pickup {
            lines_rms_v: [values[0], values[1], values[2]],
            mains_hz: conditions.mains_hz,
        };
    },
};
