//! Magnitude and phase of a complex quantity near zero.
//!
//! When the uncertainty of the real and imaginary part is not small against
//! the magnitude, the magnitude is biased upwards and the phase loses meaning:
//! the first-order formulae do not show either. That is the case in which a
//! measured sensitivity must be refused, not reported.

use super::random::Lanes;
use crate::statistics::{mean, standard_deviation};
use serde::Serialize;
use std::f64::consts::TAU;

/// Magnitude and phase by Monte Carlo and to first order.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Polar {
    /// Mean magnitude.
    pub magnitude: f64,
    /// Standard deviation of the magnitude.
    pub u_magnitude: f64,
    /// Mean phase, rad.
    pub phase_rad: f64,
    /// Standard deviation of the phase, rad.
    pub u_phase_rad: f64,
    /// First-order standard uncertainty of the magnitude.
    pub first_order_u_magnitude: f64,
    /// First-order standard uncertainty of the phase, rad.
    pub first_order_u_phase_rad: f64,
}

/// Propagates normal real and imaginary parts with standard uncertainties `u`
/// and correlation `r`.
///
/// # Source
/// JCGM 102:2011 (GUM-S2) 9.4: the same case with its printed results is test
/// `magnitude_and_phase_near_zero`.
pub fn polar(real: f64, imaginary: f64, u: [f64; 2], r: f64, trials: usize, seed: u64) -> Polar {
    let mut lanes = Lanes::new(seed, 0);
    let (mut first, mut second) = (vec![0.0; trials], vec![0.0; trials]);
    lanes.fill_normal(&mut first);
    lanes.fill_normal(&mut second);
    let direction_rad = imaginary.atan2(real);
    let (mut magnitudes, mut phases) = (Vec::new(), Vec::new());
    for (a, b) in first.iter().zip(&second) {
        let x = real + u[0] * a;
        let y = imaginary + u[1] * (r * a + (1.0 - r * r).sqrt() * b);
        magnitudes.push(x.hypot(y));
        // From the direction of the quantity itself: around half a turn, angles of both signs are one.
        let turn = (y.atan2(x) - direction_rad) / TAU;
        phases.push((turn - turn.round()) * TAU);
    }
    let size = real.hypot(imaginary);
    let (c, s) = (real / size, imaginary / size);
    let cross = 2.0 * r * u[0] * u[1] * c * s;
    let along = (c * u[0]).powi(2) + (s * u[1]).powi(2) + cross;
    let across = (s * u[0]).powi(2) + (c * u[1]).powi(2) - cross;
    Polar {
        magnitude: mean(&magnitudes),
        u_magnitude: standard_deviation(&magnitudes),
        phase_rad: direction_rad + mean(&phases),
        u_phase_rad: standard_deviation(&phases),
        first_order_u_magnitude: along.max(0.0).sqrt(),
        first_order_u_phase_rad: across.max(0.0).sqrt() / size,
    }
}
