//! Actions of the converter and its clock.

use super::effect::Effect;
use crate::model::{Channel, Model, Range, Section};
use calib_effects::digitiser;

/// The channel a parameter selects: 0 reference, 1 device under test.
fn channel(model: &mut Model, selector: f64) -> &mut Channel {
    if selector < 0.5 {
        &mut model.reference
    } else {
        &mut model.dut
    }
}

pub(super) static EFFECTS: &[Effect] = &[
    Effect::new(&digitiser::CHANNEL_SKEW, |values, _conditions, model| {
        model.dut.response.push(Section::Delay(values[0]));
    }),
    Effect::new(&digitiser::SAMPLING_JITTER, |values, _conditions, model| {
        model.jitter_s = model.jitter_s.hypot(values[0]);
    }),
    Effect::new(&digitiser::CLOCK_OFFSET, |values, _conditions, model| {
        model.dut.clock_delta += values[0];
    }),
    Effect::new(&digitiser::CUBIC, |values, _conditions, model| {
        channel(model, values[1]).converter.third_per_v2 += values[0];
    }),
    Effect::new(&digitiser::QUADRATIC, |values, _conditions, model| {
        channel(model, values[1]).converter.second_per_v += values[0];
    }),
    Effect::new(&digitiser::DEAD_ZONE, |values, _conditions, model| {
        channel(model, values[1]).converter.dead_zone_v += values[0];
    }),
    Effect::new(&digitiser::RANGE_STEP, |values, _conditions, model| {
        channel(model, values[2]).range = Some(Range {
            threshold_v: values[1],
            step_rel: values[0],
        });
    }),
    Effect::new(&digitiser::SOFT_CLIPPING, |values, _conditions, model| {
        let characteristic = &mut channel(model, values[1]).converter;
        characteristic.knee_v = characteristic.knee_v.min(values[0]);
    }),
    Effect::new(&digitiser::CLIPPING, |values, _conditions, model| {
        let characteristic = &mut channel(model, values[1]).converter;
        characteristic.threshold_v = characteristic.threshold_v.min(values[0]);
    }),
];
