//! One row without noise: the motion at which the reference shows the level.

use super::characteristic::{ORDERS, bent, converted};
use super::design::Condition;
use super::exciter::{Amplifier, Body, Creep, Exciter, Solved};
use super::response::responses;
use super::truth::{REFERENCE_V_PER_MS2, Truth};
use num_complex::Complex64 as C;
use std::f64::consts::SQRT_2;

/// Harmonics beyond this share of the fundamental make no row.
const MOST_DISTORTION: f64 = 0.3;

/// Complex peak amplitudes of a row.
pub(crate) struct Steady {
    /// Orders 0..=5 of the reference, V.
    pub(crate) reference_v: Vec<C>,
    /// Orders 0..=5 of the device, V.
    pub(crate) dut_v: Vec<C>,
    pub(crate) coil_v: C,
    pub(crate) coil_a: C,
}

/// The row, or nothing where it would be too distorted to be one.
pub(crate) fn steady(truth: &Truth, row: &Condition, gains: [f64; 2]) -> Option<Steady> {
    let exciter = exciter(truth, row);
    let wanted_v = row.acceleration_rms_ms2 * REFERENCE_V_PER_MS2 * SQRT_2;
    let first = responses(truth, row, row.frequency_hz);
    let seen_v_per_ms2 = truth.sensitivity_v_per_ms2[0] * gains[0];
    let mut peak_ms2 = wanted_v / (seen_v_per_ms2 * (first.reference * first.table).norm());
    let mut found = None;
    // A reference that bends softly shows more only of a motion that is much more.
    let tries = truth.get("adc_soft_clipping.ref").map_or(3, |_| 40);
    for _ in 0..tries {
        let solved = exciter.solve(row.frequency_hz, peak_ms2);
        let [reference_v, dut_v] = channels(truth, row, gains, &solved);
        let shown_v = reference_v[1].norm();
        found = solved.converged.then(|| Steady {
            reference_v,
            dut_v,
            coil_v: solved.coil_v[1],
            coil_a: solved.coil_a[1],
        });
        if (shown_v / wanted_v - 1.0).abs() < 1e-7 {
            break;
        }
        peak_ms2 *= wanted_v / shown_v;
    }
    found.filter(|steady| !too_distorted(&steady.reference_v) && !too_distorted(&steady.dut_v))
}

fn too_distorted(orders: &[C]) -> bool {
    (2..=ORDERS).any(|n| relative(orders, n).norm() > MOST_DISTORTION)
}

/// A harmonic in shares of the fundamental, its phase where that of the fundamental is zero.
pub(crate) fn relative(orders: &[C], n: usize) -> C {
    let fundamental = orders[1];
    orders[n] / fundamental.norm() * C::from_polar(1.0, -(n as f64) * fundamental.arg())
}

/// Reference and device, V, for a motion of the coil.
fn channels(truth: &Truth, row: &Condition, gains: [f64; 2], solved: &Solved) -> [Vec<C>; 2] {
    let [of_reference, of_dut] = [0, 1].map(|n| truth.sensitivity_v_per_ms2[n] * gains[n]);
    let mut motion = vec![C::ZERO; ORDERS + 1];
    let (mut reference_v, mut dut_v) = (motion.clone(), motion.clone());
    let at = |n: usize| responses(truth, row, row.frequency_hz * n as f64);
    for n in 1..=ORDERS {
        let response = at(n);
        motion[n] = solved.motion_ms2[n] * response.table;
        reference_v[n] = motion[n] * response.reference * of_reference;
    }
    if let Some(lifts_ms2) = truth.get("loose_mount.t") {
        motion = lifted(&motion, lifts_ms2, truth.or("loose_mount.side", -1.0));
    }
    for n in 1..=ORDERS {
        dut_v[n] = motion[n] * at(n).dut * of_dut;
    }
    let mut dut_v = converted(truth, "dut", dut_v);
    if let Some(g) = truth.get("dut_level_nonlinearity.h2") {
        let twice = C::from_polar(dut_v[1].norm(), 2.0 * dut_v[1].arg());
        dut_v[2] += twice * g * row.acceleration_rms_ms2;
    }
    [converted(truth, "ref", reference_v), dut_v]
}

/// A device that leaves the table where the table accelerates away from it.
fn lifted(motion: &[C], lifts_ms2: f64, side: f64) -> Vec<C> {
    bent(motion, |a| match side < 0.0 {
        true => a.max(-lifts_ms2),
        false => a.min(lifts_ms2),
    })
}

fn exciter(truth: &Truth, row: &Condition) -> Exciter {
    let [
        mass,
        stiffness,
        damping,
        force_factor,
        resistance,
        inductance,
    ] = truth.exciter;
    let warmer_k = truth.get("coil_heating.dt").map_or(0.0, |final_k| {
        final_k * (1.0 - (-row.time_s / truth.or("coil_heating.tau", 600.0)).exp())
    });
    let off = |key| 1.0 + truth.or(key, 0.0);
    let (other, exponent) = (truth.has_other_form(), truth.or("lossy_inductance.n", 1.0));
    let shorted_hz = truth.or("shorted_inductance.f", 1.0);
    Exciter {
        mass_kg: mass + row.payload_kg + truth.or("payload_mass.m", 0.0),
        stiffness_n_per_m: stiffness * off("nominal_stiffness.x"),
        creep: truth.get("suspension_creep.l").map(|share| match other {
            true => Creep::Once(share),
            false => Creep::Spread(share),
        }),
        damping_ns_per_m: damping + truth.or("mechanical_damping.c", 0.0),
        force_factor_n_per_a: force_factor * off("nominal_force_factor.x"),
        back_emf: 1.0 + truth.or("back_emf.b", 0.0),
        // Copper.
        resistance_ohm: resistance * off("nominal_resistance.x") * (1.0 + 0.0039 * warmer_k),
        inductance_h: inductance * off("nominal_inductance.x"),
        inductance_exponent: exponent,
        apart: other && exponent != 1.0,
        shorted_share: truth.or("shorted_inductance.s", 0.0),
        shorted_per_s: std::f64::consts::TAU * shorted_hz,
        diffuses: other,
        quadratic_n_per_m2: truth.or("suspension_asymmetry.k", 0.0),
        cubic_n_per_m3: truth.or("suspension_cubic.k", 0.0),
        droop_per_m2: truth.or("force_factor_droop.b", 0.0),
        friction_n: truth.or("coulomb_friction.f", 0.0),
        sag_share: if other { 1.0 } else { 0.0 },
        gravity_ms2: 9.80665 * row.tilt_deg.to_radians().cos(),
        amplifier: Amplifier {
            clips_at_v: truth.get("amplifier_clipping.v"),
            bends_to_v: truth.get("amplifier_soft_clipping.v").map(|v| (v, other)),
            even_per_v: truth.or("amplifier_even_order.b", 0.0),
        },
        body: truth.get("body_mode.m").map(|mass_kg| Body {
            mass_kg,
            feet_hz: truth.or("body_mode.f", 20.0),
            quality: truth.or("body_mode.q", 5.0),
            of_rubber: other,
        }),
    }
}
