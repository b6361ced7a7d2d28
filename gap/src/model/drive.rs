//! The exciter of one row at the level that is held.

use super::balance::Balanced;
use super::chain::Chain;
use super::exciter::{Added, Exciter, Fundamental};
use super::grid::size;
use super::memory::Recall;
use super::row::Row;
use crate::dataset::ExciterParameters;
use std::f64::consts::SQRT_2;

/// Action of the exciter on one row.
pub(super) struct Drive {
    pub(super) first: Fundamental,
    /// A balance of harmonics where the exciter is nonlinear.
    pub(super) balanced: Option<Balanced>,
}

/// Drives a row to the level that is held.
pub(super) fn drive(
    row: &Row,
    values: &ExciterParameters<f64>,
    chain: &Chain,
    level_ms2: f64,
    memory: &mut Recall<'_>,
) -> Drive {
    let exciter = Exciter {
        mass_kg: values.moving_mass_kg + row.payload_kg + chain.mass_kg,
        stiffness_n_per_m: values.stiffness_n_per_m * chain.stiffness,
        creep_per_decade: chain.creep_per_decade,
        damping_ns_per_m: values.damping_ns_per_m + chain.damping_ns_per_m,
        force_factor_n_per_a: values.force_factor_n_per_a * chain.force_factor,
        resistance_ohm: values.coil_resistance_ohm * chain.resistance,
        inductance_h: values.coil_inductance_h * chain.inductance,
        emf_ratio: chain.emf,
        inductance_exponent: chain.inductance_exponent,
        shorted: chain.shorted,
        body: chain.body,
    };
    let added = Added {
        mass_kg: row.payload_kg + chain.mass_kg,
        damping_ns_per_m: chain.damping_ns_per_m,
    };
    if chain.bend.is_linear()
        || !level_ms2.is_finite()
        || is_negligible(row, &exciter, chain, level_ms2)
    {
        let first = memory.still(&exciter, added, || {
            let stiffness = exciter.dynamic_stiffness(row.omega);
            Fundamental::new(&exciter.linear(row.omega, added, stiffness))
        });
        return Drive {
            first,
            balanced: None,
        };
    }
    let balanced = memory.balance(&exciter, &chain.bend, row.omega, level_ms2 * SQRT_2);
    let mut linear = exciter.linear(row.omega, added, balanced.stiffness);
    linear.acceleration_per_v = balanced.acceleration_per_v;
    linear.admittance = balanced.admittance;
    Drive {
        first: Fundamental::new(&linear),
        balanced: Some(balanced),
    }
}

/// At high frequency the travel is too small to bend anything; the row is then linear to 1e-7.
fn is_negligible(row: &Row, exciter: &Exciter, chain: &Chain, level_ms2: f64) -> bool {
    let bend = &chain.bend;
    if bend.friction_n != 0.0 || bend.even_per_v != 0.0 {
        return false;
    }
    if let Some(threshold) = bend.clip_v {
        let per_v = size(exciter.acceleration_per_v(row.omega));
        if level_ms2 * SQRT_2 / per_v > 0.75 * threshold {
            return false;
        }
    }
    // The third harmonic is a twelfth of the square of voltage over threshold.
    if let Some(knee_v) = bend.knee_v {
        let per_v = size(exciter.acceleration_per_v(row.omega));
        if level_ms2 * SQRT_2 / per_v > 1e-3 * knee_v {
            return false;
        }
    }
    let sag = bend.gravity_ms2.abs() * exciter.mass_kg / exciter.static_stiffness_n_per_m();
    let travel = level_ms2 * SQRT_2 / (row.omega * row.omega);
    let slope = 2.0 * bend.quadratic_n_per_m2.abs() * (travel + sag)
        + 3.0 * bend.cubic_n_per_m3.abs() * (travel + sag).powi(2);
    slope < 1e-7 * exciter.dynamic_stiffness(row.omega).norm()
        && bend.droop_per_m2.abs() * travel * travel < 1e-7
}
