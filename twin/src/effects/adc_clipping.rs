//! Saturation of one converter.
//!
//! The output stays at the threshold above it, on both sides.

use super::{Effect, Parameter, Stage, channel};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "adc_clipping",
    stage: Stage::Digitiser,
    formula: "saturation of one channel at large outputs: odd harmonics and loss of gain",
    parameters: &[
        Parameter::new("threshold_v", "V", [1e-4, 100.0], 0.6),
        Parameter::new("channel", "0 reference, 1 DUT", [0.0, 1.0], 1.0),
    ],
    apply: |values, _conditions, model| {
        let characteristic = &mut channel(model, values[1]).converter;
        characteristic.threshold_v = characteristic.threshold_v.min(values[0]);
    },
};
