//! Even bend of one converter.
//!
//! A second-order term: second harmonic and d.c., no change of gain.

use super::{Effect, Parameter, Stage, channel};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "adc_quadratic",
    stage: Stage::Digitiser,
    formula: "H2 and d.c. in one channel",
    parameters: &[
        Parameter::new("c2_per_v", "1/V", [-0.5, 0.5], 3e-4),
        Parameter::new("channel", "0 reference, 1 DUT", [0.0, 1.0], 1.0),
    ],
    apply: |values, _conditions, model| {
        let characteristic = &mut channel(model, values[1]).converter;
        characteristic.second_per_v += values[0];
    },
};
