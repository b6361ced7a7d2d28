//! Nonlinear forces of the exciter.

use super::grid::Parity;

/// Nonlinear forces of the exciter in one row.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Bend {
    /// Force k3 x^3, in N/m3.
    pub(crate) cubic_n_per_m3: f64,
    /// Force k2 x^2 about the unloaded position, in N/m2.
    pub(crate) quadratic_n_per_m2: f64,
    /// Bl(x) = Bl (1 - droop x^2), in 1/m2.
    pub(crate) droop_per_m2: f64,
    /// Dry friction, in N.
    pub(crate) friction_n: f64,
    /// Peak voltage at which the amplifier saturates.
    pub(crate) clip_v: Option<f64>,
    /// Peak voltage towards which the amplifier bends.
    pub(crate) knee_v: Option<f64>,
    /// Amplifier output e + even e^2, in 1/V.
    pub(crate) even_per_v: f64,
    /// Weight on the spring along the axis of motion over mass: g cos(tilt), or a share of it, in m/s2.
    pub(crate) gravity_ms2: f64,
}

impl Bend {
    /// Whether anything is bent at all.
    pub(crate) fn is_linear(&self) -> bool {
        self.friction_n == 0.0 && self.is_dry_only()
    }

    /// Whether nothing but dry friction bends.
    pub(super) fn is_dry_only(&self) -> bool {
        self.cubic_n_per_m3 == 0.0
            && self.quadratic_n_per_m2 == 0.0
            && self.droop_per_m2 == 0.0
            && self.clip_v.is_none()
            && self.knee_v.is_none()
            && self.even_per_v == 0.0
    }

    /// The spring carries as much, or what it carries already if that is more.
    pub(crate) fn carry(&mut self, gravity_ms2: f64) {
        if gravity_ms2.abs() > self.gravity_ms2.abs() {
            self.gravity_ms2 = gravity_ms2;
        }
    }

    /// Orders that can arise under it.
    pub(super) fn parity(&self) -> Parity {
        let sags = self.cubic_n_per_m3 != 0.0 && self.gravity_ms2 != 0.0;
        if self.quadratic_n_per_m2 == 0.0 && self.even_per_v == 0.0 && !sags {
            Parity::Odd
        } else {
            Parity::All
        }
    }
}
