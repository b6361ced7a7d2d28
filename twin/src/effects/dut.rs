//! Actions of the device under test.

use super::effect::Effect;
use crate::model::{SecondOrder, Section, WarmUp};
use calib_effects::dut;

/// Frequency at which the sensitivity is stated, Hz.
const REFERENCE_HZ: f64 = 160.0;

pub(super) static EFFECTS: &[Effect] = &[
    Effect::new(&dut::RESONANCE, |values, _conditions, model| {
        let section = SecondOrder::low_pass(values[0], values[1]);
        model.dut.response.push(Section::SecondOrder(section));
    }),
    Effect::new(&dut::FREQUENCY_SLOPE, |values, _conditions, model| {
        model.dut.response.push(Section::Slope {
            per_decade: values[0],
            reference_hz: REFERENCE_HZ,
        });
    }),
    Effect::new(&dut::POWER_LAW, |values, _conditions, model| {
        let ladder = Section::power_law(values[0], REFERENCE_HZ);
        model.dut.response.extend(ladder);
    }),
    Effect::new(&dut::LEVEL_NONLINEARITY, |values, _conditions, model| {
        model.dut.level_gain_per_ms2 += values[0];
        model.dut.level_second_per_ms2 += values[1];
    }),
    Effect::new(&dut::TEMPERATURE, |values, conditions, model| {
        model.dut.gain *= 1.0 + values[0] * conditions.warmer_k;
    }),
    Effect::new(&dut::DRIFT, |values, _conditions, model| {
        model.dut.drift_per_s += values[0];
    }),
    Effect::new(&dut::WARM_UP, |values, _conditions, model| {
        model.dut.warm_up = WarmUp {
            cold_rel: values[0],
            time_constant_s: values[1],
        };
    }),
    Effect::new(&dut::GAIN, |values, _conditions, model| {
        model.dut.gain *= 1.0 + values[0];
    }),
];
