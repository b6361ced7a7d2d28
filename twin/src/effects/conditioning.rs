//! Actions of amplifiers and filters between transducer and converter.

use super::effect::Effect;
use crate::model::{Pickup, SecondOrder, Section};
use calib_effects::conditioning;

/// Butterworth's poles lie on a circle, 22.5 and 67.5 degrees from the axis. Bessel's are the roots of
/// s^4 + 10 s^3 + 45 s^2 + 105 s + 105, which is 3 dB down at 2.1139.
fn fourth_order(corner_hz: f64, bessel: bool) -> [Section; 2] {
    let poles = if bessel {
        [(2.896_210_6, 0.867_234_1), (2.103_789_4, 2.657_418_0)]
            .map(|(re, im)| (re / 2.113_917_7, im / 2.113_917_7))
    } else {
        [22.5_f64, 67.5]
            .map(|degrees| degrees.to_radians())
            .map(|angle| (angle.cos(), angle.sin()))
    };
    poles.map(|(decay, turn): (f64, f64)| {
        let size = decay.hypot(turn);
        Section::SecondOrder(SecondOrder::low_pass(corner_hz * size, 0.5 * size / decay))
    })
}

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
    Effect::new(
        &conditioning::DUT_HIGHPASS_2,
        |values, _conditions, model| {
            let section = SecondOrder::high_pass(values[0], values[1]);
            model.dut.response.push(Section::SecondOrder(section));
        },
    ),
    Effect::new(
        &conditioning::REFERENCE_HIGHPASS_2,
        |values, _conditions, model| {
            let section = SecondOrder::high_pass(values[0], values[1]);
            model.reference.response.push(Section::SecondOrder(section));
        },
    ),
    Effect::new(
        &conditioning::DUT_LOWPASS_4,
        |values, _conditions, model| {
            let sections = fourth_order(values[0], values[1] >= 0.5);
            model.dut.response.extend(sections);
        },
    ),
    Effect::new(&conditioning::SINC2_FILTER, |values, _conditions, model| {
        model.dut.response.extend([Section::Average(values[0]); 2]);
    }),
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
