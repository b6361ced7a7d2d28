//! Odd bend of one converter.
//!
//! A third-order term: the gain changes with the square of the amplitude, and a third harmonic appears.

use super::{Effect, Parameter, Stage, channel};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "adc_cubic",
    stage: Stage::Digitiser,
    formula: "gain 1 + 3/4 c3 A^2, H3 in one channel",
    parameters: &[
        Parameter::new("c3_per_v2", "1/V2", [-0.5, 0.5], 1e-4),
        Parameter::new("channel", "0 reference, 1 DUT", [0.0, 1.0], 1.0),
    ],
    apply: |values, _conditions, model| {
        let characteristic = &mut channel(model, values[1]).converter;
        characteristic.third_per_v2 += values[0];
    },
};
