//! Actions of moving coil and suspension.

use super::effect::Effect;
use crate::model::{BodyModel, CoilModel, Conditions, FREE_FALL_MS2, SecondOrder, Section};
use calib_effects::exciter;
use std::f64::consts::TAU;

/// The spring carries a share of the weight, or what it carries already if that is more.
fn hang(coil: &mut CoilModel, share: f64, conditions: &Conditions) {
    let weight_n = coil.mass_kg * FREE_FALL_MS2 * conditions.tilt_rad.cos();
    if (share * weight_n).abs() > coil.static_force_n.abs() {
        coil.static_force_n = -share * weight_n;
    }
}

pub(super) static EFFECTS: &[Effect] = &[
    Effect::new(&exciter::SUSPENSION_CUBIC, |values, conditions, model| {
        model.coil.cubic_n_per_m3 += values[0];
        hang(&mut model.coil, values[1], conditions);
    }),
    Effect::new(
        &exciter::SUSPENSION_ASYMMETRY,
        |values, conditions, model| {
            model.coil.quadratic_n_per_m2 += values[0];
            hang(&mut model.coil, 1.0, conditions);
        },
    ),
    Effect::new(&exciter::SUSPENSION_CREEP, |values, _conditions, model| {
        model.coil.creep_per_decade = values[0];
    }),
    Effect::new(
        &exciter::FORCE_FACTOR_DROOP,
        |values, _conditions, model| {
            model.coil.droop_per_m2 += values[0];
        },
    ),
    Effect::new(&exciter::COULOMB_FRICTION, |values, _conditions, model| {
        model.coil.friction_n += values[0];
    }),
    Effect::new(
        &exciter::MECHANICAL_DAMPING,
        |values, _conditions, model| {
            model.coil.damping_ns_per_m += values[0];
        },
    ),
    Effect::new(&exciter::BACK_EMF, |values, _conditions, model| {
        model.coil.emf_ratio *= 1.0 + values[0];
    }),
    Effect::new(&exciter::PAYLOAD_MASS, |values, _conditions, model| {
        model.coil.mass_kg += values[0];
    }),
    Effect::new(&exciter::LOSSY_INDUCTANCE, |values, _conditions, model| {
        model.coil.inductance_exponent = values[0];
    }),
    Effect::new(
        &exciter::SHORTED_INDUCTANCE,
        |values, _conditions, model| {
            model.coil.shorted_share = values[0];
            model.coil.shorted_rate_rad_s = TAU * values[1];
        },
    ),
    Effect::new(&exciter::COIL_HEATING, |values, _conditions, model| {
        model.coil.rise_k = values[0];
        model.coil.rise_time_constant_s = values[1];
    }),
    Effect::new(&exciter::NOMINAL_STIFFNESS, |values, _conditions, model| {
        model.coil.stiffness_n_per_m *= 1.0 + values[0];
    }),
    Effect::new(
        &exciter::NOMINAL_FORCE_FACTOR,
        |values, _conditions, model| {
            model.coil.force_factor_n_per_a *= 1.0 + values[0];
        },
    ),
    Effect::new(
        &exciter::NOMINAL_RESISTANCE,
        |values, _conditions, model| {
            model.coil.resistance_ohm *= 1.0 + values[0];
        },
    ),
    Effect::new(
        &exciter::NOMINAL_INDUCTANCE,
        |values, _conditions, model| {
            model.coil.inductance_h *= 1.0 + values[0];
        },
    ),
    // q^2 = -p^2 and 2 zeta = 1/Q.
    Effect::new(&exciter::ARMATURE_MODE, |values, _conditions, model| {
        let damping = 2.0 * values[2];
        model.table.push(Section::SecondOrder(SecondOrder {
            corner_hz: values[1],
            quality_factor: 1.0 / damping,
            numerator: [1.0, damping, 1.0 - values[0]],
        }));
    }),
    // The resonance is that of the body alone on its feet.
    Effect::new(&exciter::BODY_MODE, |values, _conditions, model| {
        let (mass_kg, omega) = (values[0], TAU * values[1]);
        model.coil.body = Some(BodyModel {
            mass_kg,
            stiffness_n_per_m: mass_kg * omega * omega,
            damping_ns_per_m: mass_kg * omega / values[2],
        });
    }),
];
