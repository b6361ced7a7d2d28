//! Actions of the reference transducer.

use super::effect::Effect;
use crate::model::{SecondOrder, Section, WarmUp};
use calib_effects::reference;

pub(super) static EFFECTS: &[Effect] = &[
    Effect::new(&reference::RESONANCE, |values, _conditions, model| {
        let section = SecondOrder::low_pass(values[0], values[1]);
        model.reference.response.push(Section::SecondOrder(section));
    }),
    Effect::new(
        &reference::LEVEL_NONLINEARITY,
        |values, _conditions, model| {
            model.reference.level_gain_per_ms2 += values[0];
        },
    ),
    Effect::new(&reference::TEMPERATURE, |values, conditions, model| {
        model.reference.gain *= 1.0 + values[0] * conditions.warmer_k;
    }),
    // The sign is that of the ratio.
    Effect::new(&reference::DRIFT, |values, _conditions, model| {
        model.reference.drift_per_s -= values[0];
    }),
    Effect::new(&reference::WARM_UP, |values, _conditions, model| {
        model.reference.warm_up = WarmUp {
            cold_rel: -values[0],
            time_constant_s: values[1],
        };
    }),
    Effect::new(&reference::GAIN, |values, _conditions, model| {
        model.reference.gain *= 1.0 + values[0];
    }),
];
