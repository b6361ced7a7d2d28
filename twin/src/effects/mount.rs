//! Actions between table and transducers.

use super::effect::Effect;
use crate::model::{FREE_FALL_MS2, SecondOrder, Section, Separation};
use calib_effects::mount;
use std::f64::consts::TAU;

/// Payload for which the strain is stated, kg.
const STATED_PAYLOAD_KG: f64 = 0.040;

/// A device that has lost its weight still sticks a little, m/s2.
const LEAST_THRESHOLD_MS2: f64 = 0.2;

pub(super) static EFFECTS: &[Effect] = &[
    Effect::new(&mount::COMPLIANCE, |values, conditions, model| {
        let mounted_hz = (values[0] / conditions.payload_kg).sqrt() / TAU;
        let section = SecondOrder::low_pass(mounted_hz, values[1]);
        model.dut.motion.push(Section::SecondOrder(section));
    }),
    Effect::new(&mount::RELATIVE_MOTION, |values, conditions, model| {
        let per_hz2 = values[0] * conditions.payload_kg;
        model.dut.motion.push(Section::InverseSquare(per_hz2));
    }),
    Effect::new(&mount::TRANSVERSE_MOTION, |values, conditions, model| {
        let direction = (conditions.rotation_rad - values[1]).cos();
        let (still, rocking) = (1.0 + values[0] * direction, values[2] * direction);
        // still + rocking / (1 + p/Q + p^2), over one denominator.
        model.dut.motion.push(Section::SecondOrder(SecondOrder {
            corner_hz: values[3],
            quality_factor: values[4],
            numerator: [still + rocking, still / values[4], still],
        }));
    }),
    Effect::new(&mount::ROTATION_TWICE, |values, conditions, model| {
        let turn = 2.0 * (conditions.rotation_rad - values[1]);
        model.dut.gain *= 1.0 + values[0] * turn.cos();
    }),
    Effect::new(&mount::BASE_STRAIN, |values, conditions, model| {
        let gain = values[0] * conditions.payload_kg / STATED_PAYLOAD_KG;
        model.dut.motion.push(Section::Strain {
            gain,
            corner_hz: values[1],
        });
    }),
    // The travel is `-a / (2 pi f)^2`.
    Effect::new(&mount::GRAVITY_TILT, |values, conditions, model| {
        let tilt = values[0] * conditions.rotation_rad.cos();
        model.dut.motion.push(Section::Tilt(tilt));
    }),
    Effect::new(&mount::LOOSE_MOUNT, |values, conditions, model| {
        let lifted_ms2 = values[3] * FREE_FALL_MS2 * (1.0 - conditions.tilt_rad.cos());
        model.dut.separation = Some(Separation {
            threshold_ms2: (values[0] - lifted_ms2).max(LEAST_THRESHOLD_MS2),
            upper: values[2] >= 0.5,
            impact_noise: values[1],
        });
    }),
];
