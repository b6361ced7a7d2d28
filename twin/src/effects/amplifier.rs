//! Actions of the power amplifier.

use super::effect::Effect;
use calib_effects::amplifier;

pub(super) static EFFECTS: &[Effect] = &[
    Effect::new(&amplifier::CLIPPING, |values, _conditions, model| {
        model.amplifier.threshold_v = model.amplifier.threshold_v.min(values[0]);
    }),
    Effect::new(&amplifier::SOFT_CLIPPING, |values, _conditions, model| {
        model.amplifier.knee_v = model.amplifier.knee_v.min(values[0]);
    }),
    Effect::new(&amplifier::EVEN_ORDER, |values, _conditions, model| {
        model.amplifier.even_per_v += values[0];
    }),
    Effect::new(&amplifier::GAIN_DRIFT, |values, _conditions, model| {
        model.amplifier.drift_per_s += values[0];
    }),
];
