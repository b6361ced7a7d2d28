//! The moving coil: mass, suspension, coil and amplifier, driven with a pure sine.

mod amplifier;
mod collocation;
mod friction;
mod series;

use num_complex::Complex64 as C;
use series::{HARMONICS, Series};
use std::f64::consts::{FRAC_PI_2, TAU};

pub(crate) use amplifier::Amplifier;

/// Frequency at which a lossy inductance has its nominal size.
const NOMINAL_HZ: f64 = 1000.0;

/// How the suspension gives way slowly.
#[derive(Clone, Copy)]
pub(crate) enum Creep {
    /// By a share per decade, as retardations between two times do that are spread evenly over its logarithm.
    Spread(f64),
    /// By a share once, as one dashpot beside a second spring does.
    Once(f64),
}

impl Creep {
    /// Compliance over that at 50 Hz (of one dashpot: at the highest frequencies).
    fn compliance(&self, w_per_s: f64) -> C {
        let s = C::new(0.0, w_per_s / TAU);
        match *self {
            Self::Spread(share) => {
                let (slowest, fastest) = (1e-3, 1e4);
                let spread = ((s + fastest) / (s + slowest)).log10();
                1.0 + share * (spread - f64::log10(fastest / 50.0))
            }
            Self::Once(share) => 1.0 + 2.0 * share / (1.0 + s / 12.0),
        }
    }
}

/// The body that the coil pushes back, on its feet.
#[derive(Clone, Copy)]
pub(crate) struct Body {
    pub(crate) mass_kg: f64,
    pub(crate) feet_hz: f64,
    pub(crate) quality: f64,
    /// Whether the feet are of rubber, which loses the same share of its force at all frequencies.
    pub(crate) of_rubber: bool,
}

impl Body {
    /// Force over displacement.
    fn stiffness_n_per_m(&self, w_per_s: f64) -> C {
        let feet_per_s = TAU * self.feet_hz;
        let loss = match self.of_rubber {
            true => feet_per_s * feet_per_s,
            false => feet_per_s * w_per_s,
        };
        self.mass_kg
            * C::new(
                feet_per_s * feet_per_s - w_per_s * w_per_s,
                loss / self.quality,
            )
    }
}

/// Motion of the table.
#[derive(Clone, Copy)]
pub(crate) struct Exciter {
    pub(crate) mass_kg: f64,
    pub(crate) stiffness_n_per_m: f64,
    pub(crate) creep: Option<Creep>,
    pub(crate) damping_ns_per_m: f64,
    pub(crate) force_factor_n_per_a: f64,
    /// Factor on the back-EMF.
    pub(crate) back_emf: f64,
    pub(crate) resistance_ohm: f64,
    pub(crate) inductance_h: f64,
    /// 1 for an ideal inductance, less for one with eddy currents.
    pub(crate) inductance_exponent: f64,
    /// Whether reactance and loss have exponents of their own, as Wright measured of loudspeakers.
    pub(crate) apart: bool,
    /// Share of the inductance that eddies short, as by a resistance across it (LR-2).
    pub(crate) shorted_share: f64,
    /// That resistance over that inductance, 1/s.
    pub(crate) shorted_per_s: f64,
    /// Whether the eddies go through a sheet of iron instead, deeper the slower they are.
    pub(crate) diffuses: bool,
    pub(crate) quadratic_n_per_m2: f64,
    pub(crate) cubic_n_per_m3: f64,
    pub(crate) droop_per_m2: f64,
    pub(crate) friction_n: f64,
    /// Share of the weight on a spring that is not asymmetric.
    pub(crate) sag_share: f64,
    /// Along the axis; moves an asymmetric suspension off its middle.
    pub(crate) gravity_ms2: f64,
    pub(crate) amplifier: Amplifier,
    pub(crate) body: Option<Body>,
}

/// A steady motion: complex peak amplitudes by order.
pub(crate) struct Solved {
    pub(crate) coil_v: Series,
    pub(crate) coil_a: Series,
    pub(crate) motion_ms2: Series,
    pub(crate) converged: bool,
}

impl Exciter {
    fn impedance_ohm(&self, w_per_s: f64) -> C {
        let (nominal_per_s, exponent) = (TAU * NOMINAL_HZ, self.inductance_exponent);
        let size_ohm =
            |n: f64| nominal_per_s * self.inductance_h * (w_per_s / nominal_per_s).powf(n);
        let whole = C::from_polar(size_ohm(exponent), exponent * FRAC_PI_2);
        let whole = match self.apart {
            true => C::new(
                whole.re * (w_per_s / nominal_per_s).powf(-0.08),
                whole.im * (w_per_s / nominal_per_s).powf(0.05),
            ),
            false => whole,
        };
        if self.shorted_share == 0.0 {
            return self.resistance_ohm + whole;
        }
        let shorted_h = self.inductance_h * self.shorted_share;
        let shorted = C::new(0.0, w_per_s * shorted_h);
        let depth = C::new(0.0, 3.0 * w_per_s / self.shorted_per_s).sqrt();
        let left = match self.diffuses {
            true => shorted * depth.tanh() / depth,
            false => (shorted.inv() + 1.0 / (self.shorted_per_s * shorted_h)).inv(),
        };
        self.resistance_ohm + (1.0 - self.shorted_share) * whole + left
    }

    /// Force of the suspension over its deflection.
    fn suspension_n_per_m(&self, w_per_s: f64) -> C {
        let stated = C::from(self.stiffness_n_per_m);
        self.creep
            .map_or(stated, |creep| stated / creep.compliance(w_per_s))
    }

    /// Of the displacement between table and body, the part that is the table's.
    fn of_table(&self, w_per_s: f64) -> C {
        self.body.map_or(C::ONE, |body| {
            let body = body.stiffness_n_per_m(w_per_s);
            body / (body - self.mass_kg * w_per_s * w_per_s)
        })
    }

    /// Displacement over force where nothing drives the coil.
    fn mobility_m_per_n(&self, w_per_s: f64) -> C {
        let s = C::new(0.0, w_per_s);
        let coil = self.force_factor_n_per_a.powi(2) * self.back_emf / self.impedance_ohm(w_per_s);
        let damping = self.damping_ns_per_m + coil;
        let inertia = self.mass_kg * s * s * self.of_table(w_per_s);
        (inertia + damping * s + self.suspension_n_per_m(w_per_s)).inv()
    }

    fn is_linear(&self) -> bool {
        let bent = [
            self.quadratic_n_per_m2,
            self.cubic_n_per_m3,
            self.droop_per_m2,
            self.friction_n,
        ];
        bent.iter().all(|size| *size == 0.0) && self.amplifier.is_linear()
    }

    /// The motion whose fundamental has this peak value.
    pub(crate) fn solve(&self, frequency_hz: f64, peak_ms2: f64) -> Solved {
        let w_per_s = TAU * frequency_hz;
        match self.is_linear() {
            true => self.sine(w_per_s, peak_ms2),
            false => self.collocated(w_per_s, peak_ms2),
        }
    }

    fn sine(&self, w_per_s: f64, peak_ms2: f64) -> Solved {
        let s = C::new(0.0, w_per_s);
        let travel_m = peak_ms2 / (s * s) / self.of_table(w_per_s);
        let inertia = self.mass_kg * s * s * self.of_table(w_per_s);
        let stiffness = inertia + self.damping_ns_per_m * s + self.suspension_n_per_m(w_per_s);
        let coil_a = travel_m * stiffness / self.force_factor_n_per_a;
        let emf_v = travel_m * s * self.force_factor_n_per_a * self.back_emf;
        let alone = |value: C| {
            let mut series = vec![C::ZERO; HARMONICS + 1];
            series[1] = value;
            series
        };
        Solved {
            coil_v: alone(coil_a * self.impedance_ohm(w_per_s) + emf_v),
            coil_a: alone(coil_a),
            motion_ms2: alone(C::from(peak_ms2)),
            converged: true,
        }
    }
}
