//! Acceleration, velocity and displacement of a sine, and sensitivities to them.
//!
//! | wanted | from acceleration | from velocity |
//! |---|---|---|
//! | amplitude | `v = a / w`, `s = a / w^2` | `s = v / w` |
//! | sensitivity | `Sv = w Sa`, `Ss = w^2 Sa` | `Ss = w Sv` |
//! | phase of it | `+90`, `+180` degrees | `+90` degrees |
//!
//! The motion itself lags: velocity by 90 degrees behind acceleration. A phase is that of the output against the
//! motion it is a sensitivity to, so that of a coil whose output follows the velocity is -90 degrees against
//! acceleration and 0 against velocity.
//!
//! # Source
//! ISO 16063-21:2003, clause 6 and Annex C; phase from `v = a / (j w)`.

use crate::polarity::wrap;
use core::f32::consts::{FRAC_PI_2, TAU};

/// Quantity of a rectilinear motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionQuantity {
    /// Acceleration, m/s2.
    Acceleration,
    /// Velocity, m/s.
    Velocity,
    /// Displacement, m.
    Displacement,
}

impl MotionQuantity {
    /// Times the quantity was differentiated from displacement.
    fn order(self) -> i32 {
        match self {
            Self::Displacement => 0,
            Self::Velocity => 1,
            Self::Acceleration => 2,
        }
    }
}

/// Complex sensitivity as magnitude and phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity {
    /// Quantity it refers to.
    pub quantity: MotionQuantity,
    /// Magnitude, V per SI unit of the quantity.
    pub magnitude: f32,
    /// Phase, rad, in (-pi, pi].
    pub phase_rad: f32,
}

impl Sensitivity {
    /// Sensitivity of this transducer to another quantity.
    ///
    /// # Equation
    /// `S_x = S_y (j w)^n`, `n` being how many times `y` is differentiated more
    /// often than `x`: `y = (j w)^n x` for one output.
    pub fn to(self, quantity: MotionQuantity, frequency_hz: f32) -> Self {
        let steps = self.quantity.order() - quantity.order();
        Self {
            quantity,
            magnitude: self.magnitude * power(TAU * frequency_hz, steps),
            phase_rad: wrap(self.phase_rad + steps as f32 * FRAC_PI_2),
        }
    }
}

/// Amplitude of one quantity from that of another, both r.m.s. or both peak.
pub fn amplitude(value: f32, from: MotionQuantity, to: MotionQuantity, frequency_hz: f32) -> f32 {
    value * power(TAU * frequency_hz, to.order() - from.order())
}

/// `base^exponent` for exponents from -2 to 2.
fn power(base: f32, exponent: i32) -> f32 {
    match exponent {
        -2 => 1.0 / (base * base),
        -1 => 1.0 / base,
        1 => base,
        2 => base * base,
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::MotionQuantity::{Acceleration, Displacement, Velocity};
    use super::*;
    use core::f32::consts::PI;

    fn close(value: f32, expected: f64) {
        // Three f32 operations.
        assert!(
            (f64::from(value) / expected - 1.0).abs() < 3.0e-7,
            "{value} {expected}"
        );
    }

    #[test]
    fn ten_metres_per_second_squared_at_160_hz() {
        // By hand: w = 1005.3096 rad/s; v = 9.947184 mm/s; s = 9.894647 um.
        close(
            amplitude(10.0, Acceleration, Velocity, 160.0),
            9.947_183_943e-3,
        );
        close(
            amplitude(10.0, Acceleration, Displacement, 160.0),
            9.894_646_84e-6,
        );
    }

    #[test]
    fn sensitivities_convert_as_in_clause_6() {
        let acceleration = Sensitivity {
            quantity: Acceleration,
            magnitude: 0.01,
            phase_rad: 0.2,
        };
        let velocity = acceleration.to(Velocity, 160.0);
        close(velocity.magnitude, 0.01 * 1_005.309_649);
        close(velocity.phase_rad, 0.2 + core::f64::consts::FRAC_PI_2);
        let displacement = acceleration.to(Displacement, 160.0);
        close(displacement.magnitude, 0.01 * 1_005.309_649_f64.powi(2));
        // Half a turn either way is one angle, told in (-pi, pi].
        close(displacement.phase_rad, 0.2 - core::f64::consts::PI);
        // b): from velocity to displacement.
        let again = velocity.to(Displacement, 160.0);
        close(again.magnitude, f64::from(displacement.magnitude));
        assert!((again.phase_rad - displacement.phase_rad).abs() < 1.0e-6);
    }

    /// Output, velocity and acceleration as samples of one motion `v = cos(w t)`: a coil of 4 V/(m/s) without any
    /// lag, its phase against acceleration by projection, and what becomes of both against velocity.
    #[test]
    fn a_coil_that_follows_the_velocity_has_no_phase_against_it() {
        let (w, count) = (core::f64::consts::TAU * 80.0, 1000);
        let (mut in_phase, mut quadrature) = (0.0, 0.0);
        for index in 0..count {
            let angle = core::f64::consts::TAU * f64::from(index) / f64::from(count);
            let (output, acceleration) = (4.0 * angle.cos(), -w * angle.sin());
            // In phase with the acceleration, and a quarter turn ahead of it.
            in_phase += output * acceleration / w;
            quadrature -= output * angle.cos();
        }
        let half = f64::from(count) / 2.0;
        let (re, im) = (in_phase / half / w, quadrature / half / w);
        let against_acceleration = Sensitivity {
            quantity: Acceleration,
            magnitude: re.hypot(im) as f32,
            phase_rad: im.atan2(re) as f32,
        };
        close(
            against_acceleration.phase_rad,
            -core::f64::consts::FRAC_PI_2,
        );
        let against_velocity = against_acceleration.to(Velocity, 80.0);
        close(against_velocity.magnitude, 4.0);
        assert!(against_velocity.phase_rad.abs() < 1.0e-6);
    }

    #[test]
    fn there_and_back_is_the_same() {
        for quantity in [Acceleration, Velocity, Displacement] {
            for other in [Acceleration, Velocity, Displacement] {
                let start = Sensitivity {
                    quantity,
                    magnitude: 3.0,
                    phase_rad: -3.0,
                };
                let back = start.to(other, 31.5).to(quantity, 31.5);
                close(back.magnitude, 3.0);
                assert!((back.phase_rad + 3.0).abs() < 1.0e-6);
                assert!(start.to(other, 31.5).phase_rad.abs() <= PI);
            }
        }
    }
}
