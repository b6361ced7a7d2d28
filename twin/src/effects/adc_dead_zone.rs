//! Dead zone of one converter.
//!
//! Nothing happens until the input leaves a band around zero: worst at small amplitudes.

use super::{Effect, Parameter, Stage, channel};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "adc_dead_zone",
    stage: Stage::Digitiser,
    formula: "gain 1 - 4 delta/(pi A), H3, H5 ~ 1/A in one channel",
    parameters: &[
        Parameter::new("delta_v", "V", [0.0, 1.0], 1e-4),
        Parameter::new("channel", "0 reference, 1 DUT", [0.0, 1.0], 1.0),
    ],
    apply: |values, _conditions, model| {
        let characteristic = &mut channel(model, values[1]).converter;
        characteristic.dead_zone_v += values[0];
    },
};
