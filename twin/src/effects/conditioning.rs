//! Actions of amplifiers and filters between transducer and converter.

use super::effect::Effect;
use crate::model::{Pickup, SecondOrder, Section};
use calib_effects::conditioning;

pub(super) static EFFECTS: &[Effect] = &[
    Effect::new(&conditioning::DUT_HIGHPASS, |values, _conditions, model| {
        model.dut.response.push(Section::HighPass(values[0]));
    }),
    Effect::new(
        &conditioning::REFERENCE_HIGHPASS,
        |values, _conditions, model| {
            model.reference.response.push(Section::HighPass(values[0]));
        },
    ),
    Effect::new(
        &conditioning::DUT_LOWPASS_1,
        |values, _conditions, model| {
            model.dut.response.push(Section::LowPass(values[0]));
        },
    ),
    Effect::new(
        &conditioning::REFERENCE_LOWPASS_1,
        |values, _conditions, model| {
            model.reference.response.push(Section::LowPass(values[0]));
        },
    ),
    Effect::new(
        &conditioning::DUT_LOWPASS_2,
        |values, _conditions, model| {
            let section = SecondOrder::low_pass(values[0], values[1]);
            model.dut.response.push(Section::SecondOrder(section));
        },
    ),
    Effect::new(
        &conditioning::AVERAGING_WINDOW,
        |values, _conditions, model| {
            model.dut.response.push(Section::Average(values[0]));
        },
    ),
    Effect::new(&conditioning::CROSSTALK, |values, _conditions, model| {
        model.dut.response.push(Section::Coupling {
            inverse_fx_s: values[0],
            in_phase: values[1],
            quadrature: values[2],
        });
    }),
    Effect::new(&conditioning::MAINS_PICKUP, |values, conditions, model| {
        model.dut.pickup = Pickup {
            lines_rms_v: [values[0], values[1], values[2]],
            mains_hz: conditions.mains_hz,
        };
    }),
];
