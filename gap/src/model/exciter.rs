//! The voltage-driven moving coil: what one sine at one frequency does, and the nonlinear forces.

use super::grid::{Parity, ln};
use crate::dataset::ExciterParameters;
use num_complex::Complex64;

/// Frequency at which the coil inductance is stated.
pub(crate) const INDUCTANCE_FREQUENCY_HZ: f64 = 1000.0;

/// Frequency at which the stiffness of a suspension that creeps is the stated one.
const CREEP_FREQUENCY_HZ: f64 = 50.0;
/// Frequency below which it creeps no further.
const RELAXED_HZ: f64 = 1e-3;

/// Body of the exciter on its feet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Body {
    /// Mass, in kg.
    pub(crate) mass_kg: f64,
    /// Natural frequency of the body alone on its feet, in Hz.
    pub(crate) isolator_hz: f64,
    /// Quality of that resonance.
    pub(crate) quality: f64,
}

impl Body {
    /// Mass that resists the coil as much as the body on its feet does.
    fn apparent_kg(&self, omega: f64) -> Complex64 {
        let q = std::f64::consts::TAU * self.isolator_hz / omega;
        self.mass_kg * Complex64::new(1.0 - q * q, -q / self.quality)
    }
}

/// Parameters of the exciter in one row, the effects included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Exciter {
    /// Moving mass with payload, in kg.
    pub(crate) mass_kg: f64,
    /// Suspension stiffness, in N/m.
    pub(crate) stiffness_n_per_m: f64,
    /// Share by which the compliance of the suspension grows per decade.
    pub(crate) creep_per_decade: f64,
    /// Mechanical damping, in N s/m.
    pub(crate) damping_ns_per_m: f64,
    /// Force per current, in N/A.
    pub(crate) force_factor_n_per_a: f64,
    /// Coil resistance, in ohm.
    pub(crate) resistance_ohm: f64,
    /// Coil inductance at 1 kHz, in H.
    pub(crate) inductance_h: f64,
    /// Voltage per velocity over force per current; 1 in an ideal coil.
    pub(crate) emf_ratio: f64,
    /// Exponent n of the coil's j^n w0 L (w/w0)^n; 1 = ideal inductance.
    pub(crate) inductance_exponent: f64,
    /// Share of the inductance that is shorted above a corner, and that corner in Hz.
    pub(crate) shorted: [f64; 2],
    /// The body, if it gives way.
    pub(crate) body: Option<Body>,
}

/// Payload that moves with the exciter.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Added {
    /// Payload and unknown mass, in kg.
    pub(crate) mass_kg: f64,
    /// Damping beyond that of the suspension, in N s/m.
    pub(crate) damping_ns_per_m: f64,
}

/// Relative slopes of a response against relative changes of the parameters.
pub(crate) type Slopes = ExciterParameters<Complex64>;

/// Slopes of both responses to the coil voltage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ExciterSlopes {
    /// Of the acceleration.
    pub(crate) drive: Slopes,
    /// Of the coil current.
    pub(crate) current: Slopes,
}

/// Responses to the coil voltage at one frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Linear {
    /// Acceleration over coil voltage, in (m/s2)/V.
    pub(crate) acceleration_per_v: Complex64,
    /// Coil current over coil voltage, in S.
    pub(crate) admittance: Complex64,
    pub(crate) slopes: ExciterSlopes,
}

impl Exciter {
    /// Coil impedance R + j^n w0 L (w/w0)^n; n = 1 is R + s L.
    pub(crate) fn impedance(&self, omega: f64) -> Complex64 {
        self.resistance_ohm + self.inductive(omega)
    }

    fn inductive(&self, omega: f64) -> Complex64 {
        let omega_0 = std::f64::consts::TAU * INDUCTANCE_FREQUENCY_HZ;
        let n = self.inductance_exponent;
        let ideal = Complex64::new(0.0, omega * self.inductance_h);
        let whole = if n == 1.0 {
            ideal
        } else {
            let size = omega_0 * self.inductance_h * (omega / omega_0).powf(n);
            Complex64::from_polar(size, n * std::f64::consts::FRAC_PI_2)
        };
        let [share, corner_hz] = self.shorted;
        if share == 0.0 {
            return whole;
        }
        let q = omega / (std::f64::consts::TAU * corner_hz);
        whole * (1.0 - share) + ideal * share / Complex64::new(1.0, q)
    }

    /// Force of the suspension over its deflection, k/(1 - l lg(j f/50 Hz)).
    fn suspension_n_per_m(&self, omega: f64) -> Complex64 {
        let stated = Complex64::from(self.stiffness_n_per_m);
        if self.creep_per_decade == 0.0 {
            return stated;
        }
        let decades = (omega / (std::f64::consts::TAU * CREEP_FREQUENCY_HZ)).log10();
        let quarter = std::f64::consts::FRAC_PI_2 / std::f64::consts::LN_10;
        stated / (1.0 - self.creep_per_decade * Complex64::new(decades, quarter))
    }

    /// Stiffness at rest.
    pub(crate) fn static_stiffness_n_per_m(&self) -> f64 {
        let decades = (CREEP_FREQUENCY_HZ / RELAXED_HZ).log10();
        self.stiffness_n_per_m / (1.0 + self.creep_per_decade * decades)
    }

    /// Force over displacement of the moving part from the body, M' s^2 + c s + k.
    ///
    /// # Equation
    /// Between the table and a body that gives way the coil moves the reduced mass, 1/M' = 1/M + 1/Mb.
    pub(crate) fn dynamic_stiffness(&self, omega: f64) -> Complex64 {
        let suspension = self.suspension_n_per_m(omega);
        let spring = Complex64::new(
            suspension.re - self.mass_kg * omega * omega,
            suspension.im + self.damping_ns_per_m * omega,
        );
        match self.body {
            None => spring,
            Some(_) => spring + self.mass_kg * omega * omega * (1.0 - self.share_of_table(omega)),
        }
    }

    /// Displacement of the table in space over that from the body.
    pub(crate) fn share_of_table(&self, omega: f64) -> Complex64 {
        self.body.map_or(Complex64::ONE, |body| {
            let body_kg = body.apparent_kg(omega);
            body_kg / (body_kg + self.mass_kg)
        })
    }

    /// Mass that the coil moves where neither spring nor feet hold.
    pub(crate) fn reduced_mass_kg(&self) -> f64 {
        self.body.map_or(self.mass_kg, |body| {
            1.0 / (1.0 / self.mass_kg + 1.0 / body.mass_kg)
        })
    }

    /// Acceleration over coil voltage at one frequency, in (m/s2)/V.
    pub(crate) fn acceleration_per_v(&self, omega: f64) -> Complex64 {
        let s = Complex64::new(0.0, omega);
        let bl = self.force_factor_n_per_a;
        let denominator =
            self.dynamic_stiffness(omega) * self.impedance(omega) + s * bl * bl * self.emf_ratio;
        s * s * bl * self.share_of_table(omega) / denominator
    }

    /// Responses at one frequency. `stiffness` replaces [`Exciter::dynamic_stiffness`]
    /// where a nonlinear suspension has changed it. The slopes hold for what is the exciter's
    /// own: mass and damping without the part that is `added` to it.
    pub(crate) fn linear(&self, omega: f64, added: Added, stiffness: Complex64) -> Linear {
        let s = Complex64::new(0.0, omega);
        let bl = self.force_factor_n_per_a;
        let z = self.impedance(omega);
        let coupling = s * bl * bl * self.emf_ratio;
        let denominator = stiffness * z + coupling;
        // The reduced mass goes with the square of the table's share.
        let share = self.share_of_table(omega);
        let mass = s * s * (self.mass_kg - added.mass_kg) * share * share;
        let of_share = (share - 1.0) * (1.0 - added.mass_kg / self.mass_kg);
        let stiffness_alone = self.suspension_n_per_m(omega);
        let damping = s * (self.damping_ns_per_m - added.damping_ns_per_m);
        let of_drive = |own: Complex64| -own * z / denominator;
        let drive = Slopes {
            moving_mass_kg: of_drive(mass),
            stiffness_n_per_m: of_drive(stiffness_alone),
            damping_ns_per_m: of_drive(damping),
            force_factor_n_per_a: -coupling * 2.0 / denominator,
            coil_resistance_ohm: -stiffness * self.resistance_ohm / denominator,
            coil_inductance_h: -stiffness * self.inductive(omega) / denominator,
        };
        // The current feels what is electric alike, but for the force it makes.
        let current = Slopes {
            moving_mass_kg: mass / stiffness + drive.moving_mass_kg,
            stiffness_n_per_m: stiffness_alone / stiffness + drive.stiffness_n_per_m,
            damping_ns_per_m: damping / stiffness + drive.damping_ns_per_m,
            ..drive
        };
        let drive = Slopes {
            moving_mass_kg: drive.moving_mass_kg + of_share,
            force_factor_n_per_a: drive.force_factor_n_per_a + 1.0,
            ..drive
        };
        Linear {
            acceleration_per_v: s * s * bl * share / denominator,
            admittance: stiffness / denominator,
            slopes: ExciterSlopes { drive, current },
        }
    }
}

#[cfg(test)]
impl Exciter {
    /// The standard rig with 40 g on it and an ideal inductance.
    pub(crate) fn example() -> Self {
        Self {
            mass_kg: 0.09,
            stiffness_n_per_m: 8000.0,
            creep_per_decade: 0.0,
            damping_ns_per_m: 3.0,
            force_factor_n_per_a: 7.0,
            resistance_ohm: 4.0,
            inductance_h: 1.2e-4,
            emf_ratio: 1.0,
            inductance_exponent: 1.0,
            shorted: [0.0, 1.0],
            body: None,
        }
    }
}

/// Responses of the fundamental to the coil voltage.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fundamental {
    /// Logarithms of acceleration and of current over coil voltage.
    pub(super) ln: [Complex64; 2],
    /// Their slopes against the values of the exciter.
    pub(super) slopes: ExciterSlopes,
}

impl Fundamental {
    pub(super) fn new(linear: &Linear) -> Self {
        Self {
            ln: [ln(linear.acceleration_per_v), ln(linear.admittance)],
            slopes: linear.slopes,
        }
    }
}

/// Nonlinear forces of the exciter in one row.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Nonlinearity {
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

impl Nonlinearity {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::ExciterParameter;

    fn exciter() -> Exciter {
        Exciter {
            mass_kg: 0.08,
            creep_per_decade: 0.1,
            inductance_exponent: 0.7,
            shorted: [0.4, 120.0],
            body: Some(Body {
                mass_kg: 2.0,
                isolator_hz: 120.0,
                quality: 3.0,
            }),
            ..Exciter::example()
        }
    }

    /// Central differences with a relative step of 1e-5: error about 1e-9.
    #[test]
    fn slopes_agree_with_differences() {
        let omega = 900.0;
        let added = Added {
            mass_kg: 0.03,
            damping_ns_per_m: 1.2,
        };
        let nominal = exciter();
        let linear = nominal.linear(omega, added, nominal.dynamic_stiffness(omega));
        let step = 1e-5;
        for parameter in ExciterParameter::ALL {
            let moved = |sign: f64| {
                let (mut e, factor) = (nominal, 1.0 + sign * step);
                match parameter {
                    ExciterParameter::MovingMass => {
                        e.mass_kg = added.mass_kg + (e.mass_kg - added.mass_kg) * factor;
                    }
                    ExciterParameter::Stiffness => e.stiffness_n_per_m *= factor,
                    ExciterParameter::Damping => {
                        e.damping_ns_per_m +=
                            (e.damping_ns_per_m - added.damping_ns_per_m) * (factor - 1.0);
                    }
                    ExciterParameter::ForceFactor => e.force_factor_n_per_a *= factor,
                    ExciterParameter::CoilResistance => e.resistance_ohm *= factor,
                    ExciterParameter::CoilInductance => e.inductance_h *= factor,
                }
                e.linear(omega, added, e.dynamic_stiffness(omega))
            };
            let (up, down) = (moved(1.0), moved(-1.0));
            let drive = (up.acceleration_per_v.ln() - down.acceleration_per_v.ln()) / (2.0 * step);
            let current = (up.admittance.ln() - down.admittance.ln()) / (2.0 * step);
            let slopes = linear.slopes;
            let off = [
                drive - slopes.drive[parameter],
                current - slopes.current[parameter],
            ];
            assert!(off[0].norm() < 1e-7, "drive {parameter:?}");
            assert!(off[1].norm() < 1e-7, "current {parameter:?}");
        }
    }
}
