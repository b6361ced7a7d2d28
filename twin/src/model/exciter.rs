//! A voltage-driven moving coil with the nonlinear terms of real ones.

use std::f64::consts::TAU;

use nalgebra::Complex;

/// Temperature coefficient of the resistance of copper, 1/K.
pub const COPPER_PER_K: f64 = 0.0039;

/// Angular frequency at which the inductance is stated, rad/s.
const INDUCTANCE_OMEGA: f64 = TAU * 1000.0;

/// Body of the exciter on its feet: it is pushed as the armature is, the other way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyModel {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Stiffness of the feet, N/m.
    pub stiffness_n_per_m: f64,
    /// Damping of the feet, N s/m.
    pub damping_ns_per_m: f64,
}

/// Frequency at which the stiffness of a suspension that creeps is the stated one, rad/s.
const CREEP_OMEGA: f64 = TAU * 50.0;
/// Retardations of a suspension: how many, the first one's decade of frequency (in Hz), and how many
/// of them make a decade.
pub const RETARDATIONS: u8 = 14;
const CREEP_FROM: f64 = -3.0;
const RETARDATIONS_PER_DECADE: f64 = 2.0;

/// Compliance of a suspension over the stated one, as what yields at once and what yields later.
///
/// # Equation
/// `c = c0 + sum c_k / (1 + s/x_k)` with rates evenly spaced in their logarithm, each the same share: between the
/// first and the last the compliance falls by as much per decade.
///
/// # Accuracy
/// 4e-3 of the creep from 1 Hz to 300 Hz: test `a_suspension_that_creeps_gives_way_evenly_over_decades`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Creep {
    /// c0.
    pub at_once: f64,
    /// c_k.
    pub share: f64,
}

impl Creep {
    fn new(per_decade: f64) -> Self {
        let decades = f64::from(RETARDATIONS) / RETARDATIONS_PER_DECADE;
        let last_omega = TAU * 10_f64.powf(CREEP_FROM + decades);
        Self {
            at_once: 1.0 - per_decade * (last_omega / CREEP_OMEGA).log10(),
            share: per_decade / RETARDATIONS_PER_DECADE,
        }
    }

    /// x_k, rad/s.
    pub fn rates() -> impl Iterator<Item = f64> {
        let decade = |at: u8| CREEP_FROM + (f64::from(at) + 0.5) / RETARDATIONS_PER_DECADE;
        (0..RETARDATIONS).map(move |at| TAU * 10_f64.powf(decade(at)))
    }

    /// Compliance over the stated one.
    fn compliance(&self, omega: f64) -> Complex<f64> {
        let yields = |rate| self.share / Complex::new(1.0, omega / rate);
        Self::rates().map(yields).sum::<Complex<f64>>() + self.at_once
    }
}

/// Moving coil, suspension and what they carry.
///
/// # Equation
/// `u = Z i + e Bl(x) v`, `M v' = Bl(x) i - c v - k x - k2 x^2 - k3 x^3 - Fc sign(v) + Fg`,
/// `x' = v`, both from the body, which moves if it has feet, with `Bl(x) = Bl (1 - b2 x^2)`, and an impedance that is `R + j w L` for the exponent
/// 1, else `R + j^n w0 L (w/w0)^n` with `w0 = 2 pi 1 kHz`. Of L, a share may have a resistance across it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoilModel {
    /// M, armature with payload, kg.
    pub mass_kg: f64,
    /// k, suspension stiffness, N/m.
    pub stiffness_n_per_m: f64,
    /// Share by which the compliance of the suspension grows per decade of time.
    pub creep_per_decade: f64,
    /// c, viscous damping, N s/m.
    pub damping_ns_per_m: f64,
    /// Bl, force factor at rest, N/A.
    pub force_factor_n_per_a: f64,
    /// e, induced voltage over `Bl v`; 1 for a reciprocal transducer.
    pub emf_ratio: f64,
    /// R, coil resistance when cold, ohm.
    pub resistance_ohm: f64,
    /// Final rise of the coil temperature, K.
    pub rise_k: f64,
    /// Time constant of that rise, s.
    pub rise_time_constant_s: f64,
    /// L, inductance at 1 kHz, H.
    pub inductance_h: f64,
    /// n, exponent of the inductance.
    pub inductance_exponent: f64,
    /// Share of the inductance that has a resistance across it.
    pub shorted_share: f64,
    /// That resistance over that inductance, rad/s.
    pub shorted_rate_rad_s: f64,
    /// k2, N/m2.
    pub quadratic_n_per_m2: f64,
    /// k3, N/m3.
    pub cubic_n_per_m3: f64,
    /// b2, 1/m2.
    pub droop_per_m2: f64,
    /// Fc, N.
    pub friction_n: f64,
    /// Fg, constant force such as weight along the axis, N.
    pub static_force_n: f64,
    /// The body, if it moves.
    pub body: Option<BodyModel>,
}

impl CoilModel {
    /// A coil without losses and nonlinear terms, of unit mass, stiffness, force factor, resistance
    /// and inductance: the start of a description.
    pub const LINEAR: Self = Self {
        mass_kg: 1.0,
        stiffness_n_per_m: 1.0,
        creep_per_decade: 0.0,
        damping_ns_per_m: 0.0,
        force_factor_n_per_a: 1.0,
        emf_ratio: 1.0,
        resistance_ohm: 1.0,
        rise_k: 0.0,
        rise_time_constant_s: 1.0,
        inductance_h: 1.0,
        inductance_exponent: 1.0,
        shorted_share: 0.0,
        shorted_rate_rad_s: 1.0,
        quadratic_n_per_m2: 0.0,
        cubic_n_per_m3: 0.0,
        droop_per_m2: 0.0,
        friction_n: 0.0,
        static_force_n: 0.0,
        body: None,
    };

    /// Resistance after `time_s` under load, ohm.
    pub fn warm_resistance_ohm(&self, time_s: f64) -> f64 {
        let rise_k = if self.rise_k == 0.0 {
            0.0
        } else {
            self.rise_k * (1.0 - (-time_s / self.rise_time_constant_s).exp())
        };
        self.resistance_ohm * (1.0 + COPPER_PER_K * rise_k)
    }

    /// Whether the equations are linear.
    pub fn is_linear(&self) -> bool {
        let bends = [
            self.quadratic_n_per_m2,
            self.cubic_n_per_m3,
            self.droop_per_m2,
            self.friction_n,
        ];
        bends.iter().all(|&value| value == 0.0)
    }

    /// Impedance of the blocked coil at the angular frequency `omega`, ohm.
    pub fn blocked_impedance(&self, omega: f64, time_s: f64) -> Complex<f64> {
        let ratio = Complex::new(0.0, omega / INDUCTANCE_OMEGA);
        let reactance = if self.inductance_exponent == 1.0 {
            ratio
        } else {
            ratio.powf(self.inductance_exponent)
        };
        let open_h = self.inductance_h * (1.0 - self.shorted_share);
        let mut impedance =
            reactance * INDUCTANCE_OMEGA * open_h + self.warm_resistance_ohm(time_s);
        if let Some((across_ohm, _)) = self.shorted_pair() {
            let shorted = Complex::new(0.0, omega * self.inductance_h * self.shorted_share);
            impedance += shorted * across_ohm / (shorted + across_ohm);
        }
        impedance
    }

    /// The resistance across part of the inductance, ohm, and the rate of the two, rad/s.
    fn shorted_pair(&self) -> Option<(f64, f64)> {
        let across_ohm = self.shorted_share * self.inductance_h * self.shorted_rate_rad_s;
        (across_ohm > 0.0).then_some((across_ohm, self.shorted_rate_rad_s))
    }

    /// How the suspension creeps, if it does.
    pub fn creep(&self) -> Option<Creep> {
        (self.creep_per_decade != 0.0).then(|| Creep::new(self.creep_per_decade))
    }

    /// Force of the suspension over its deflection at `omega`, N/m.
    pub fn suspension_n_per_m(&self, omega: f64) -> Complex<f64> {
        let stated = Complex::new(self.stiffness_n_per_m, 0.0);
        self.creep()
            .map_or(stated, |creep| stated / creep.compliance(omega))
    }

    /// Travel from the body over travel in space at `omega`: what the body gives way is added.
    pub fn from_body(&self, omega: f64) -> Complex<f64> {
        let s = Complex::new(0.0, omega);
        self.body.map_or(Complex::new(1.0, 0.0), |body| {
            let feet = s * body.damping_ns_per_m + body.stiffness_n_per_m;
            s * s * self.mass_kg / (s * s * body.mass_kg + feet) + 1.0
        })
    }

    /// Current and travel in space per volt at `omega`, of the linear terms alone.
    pub fn linear_response(&self, omega: f64, time_s: f64) -> [Complex<f64>; 2] {
        let s = Complex::new(0.0, omega);
        let from_body = self.from_body(omega);
        let spring = s * self.damping_ns_per_m + self.suspension_n_per_m(omega);
        let mechanics = s * s * self.mass_kg + spring * from_body;
        let impedance = self.blocked_impedance(omega, time_s);
        let emf = self.force_factor_n_per_a * self.emf_ratio * from_body;
        let denominator = mechanics * impedance + s * self.force_factor_n_per_a * emf;
        [
            mechanics / denominator,
            self.force_factor_n_per_a / denominator,
        ]
    }

    /// The ladder of the coil's impedance; an approximation where the exponent is not 1.
    pub fn ladder(&self) -> InductanceLadder {
        let open_h = self.inductance_h * (1.0 - self.shorted_share);
        let mut ladder = InductanceLadder::new(open_h, self.inductance_exponent);
        ladder.pairs.extend(self.shorted_pair());
        ladder
    }
}

/// A coil's lossy inductance as a series of resistor-inductor pairs.
///
/// # Equation
/// With `a = 1 - n`, `s^-a = sin(pi a)/pi Integral x^-a / (s + x) dx`; on a logarithmic grid `x_k`
/// the trapezoidal rule converges exponentially, and the two tails are an inductance and a
/// resistance. So `w0 L (s/w0)^n = R0 + s L0 + sum R_k s / (s + x_k)`: eddy currents with a
/// spectrum of time constants.
///
/// # Accuracy
/// 1e-4 of the impedance from 1 Hz to 20 kHz: test
/// `the_ladder_has_the_impedance_of_the_power_law`.
#[derive(Clone, Debug, PartialEq)]
pub struct InductanceLadder {
    /// R0, ohm.
    pub resistance_ohm: f64,
    /// L0, H.
    pub inductance_h: f64,
    /// (R_k in ohm, x_k in rad/s).
    pub pairs: Vec<(f64, f64)>,
}

/// Start of the ladder's grid, rad/s, far below 1 Hz; it ends near 1e8 rad/s, far above 20 kHz.
const LADDER_LOWEST: f64 = 0.1;
/// Grid points to a decade.
const LADDER_PER_DECADE: f64 = 3.0;
/// Resistor-inductor pairs of a lossy coil.
const LADDER_PAIRS: u32 = 27;

impl InductanceLadder {
    fn new(inductance_h: f64, exponent: f64) -> Self {
        if exponent == 1.0 {
            return Self {
                resistance_ohm: 0.0,
                inductance_h,
                pairs: Vec::new(),
            };
        }
        let a = 1.0 - exponent;
        let scale = inductance_h * INDUCTANCE_OMEGA.powf(a) * (std::f64::consts::PI * a).sin()
            / std::f64::consts::PI;
        let step = std::f64::consts::LN_10 / LADDER_PER_DECADE;
        let rate = |index| LADDER_LOWEST * (step * f64::from(index)).exp();
        let pair = |index| (scale * step * f64::powf(rate(index), exponent), rate(index));
        // The rest of the endless sum, with 1/(s + x) = 1/x above the grid and 1/s below it: two
        // geometric series.
        let series = |power: f64| step / ((power * step).exp() - 1.0);
        Self {
            resistance_ohm: scale * LADDER_LOWEST.powf(exponent) * series(exponent),
            inductance_h: scale * rate(LADDER_PAIRS - 1).powf(-a) * series(a),
            pairs: (0..LADDER_PAIRS).map(pair).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn coil(exponent: f64) -> CoilModel {
        CoilModel {
            resistance_ohm: 4.0,
            inductance_h: 1.2e-4,
            inductance_exponent: exponent,
            ..CoilModel::LINEAR
        }
    }

    #[test]
    fn the_ladder_has_the_impedance_of_the_power_law() {
        for exponent in [0.5, 0.6, 0.7, 0.8, 0.9, 0.98] {
            let coil = coil(exponent);
            let ladder = coil.ladder();
            for frequency_hz in [1.0, 5.0, 100.0, 1e3, 1e4, 2e4] {
                let s = Complex::new(0.0, TAU * frequency_hz);
                let pairs: Complex<f64> = ladder.pairs.iter().map(|&(r, x)| s * r / (s + x)).sum();
                let got =
                    coil.resistance_ohm + ladder.resistance_ohm + s * ladder.inductance_h + pairs;
                let expected = coil.blocked_impedance(s.im, 0.0);
                assert!(
                    (got - expected).norm() < 1e-4 * expected.norm(),
                    "{exponent} {frequency_hz}"
                );
            }
        }
    }

    /// At its corner half of the shorted part is left as an inductance, and as much is a resistance.
    #[test]
    fn a_shorted_inductance_has_half_of_itself_left_at_its_corner() {
        let corner_hz = 2e3;
        let coil = CoilModel {
            shorted_share: 0.6,
            shorted_rate_rad_s: TAU * corner_hz,
            ..coil(1.0)
        };
        let s = Complex::new(0.0, TAU * corner_hz);
        let reactance = s.im * 1.2e-4;
        let expected = Complex::new(4.0 + 0.3 * reactance, 0.7 * reactance);
        assert!((coil.blocked_impedance(s.im, 0.0) - expected).norm() < 1e-12);
        let ladder = coil.ladder();
        let pairs: Complex<f64> = ladder.pairs.iter().map(|&(r, x)| s * r / (s + x)).sum();
        assert!((4.0 + s * ladder.inductance_h + pairs - expected).norm() < 1e-12);
    }

    /// `lg(j f/50 Hz)` has the same imaginary part at all frequencies. A lattice of two to a decade has the ripple
    /// of `a_ladder_falls_with_a_power_of_the_frequency`, 1.2e-3 of `l/ln 10`, and lacks what the ends lack: at
    /// 300 Hz 3 % of that from above, 2e-3 of what is beside inertia there.
    #[test]
    fn a_suspension_that_creeps_gives_way_evenly_over_decades() {
        let per_decade = 0.1;
        let coil = CoilModel {
            stiffness_n_per_m: 8000.0,
            creep_per_decade: per_decade,
            ..CoilModel::LINEAR
        };
        for frequency_hz in [0.5, 5.0, 50.0, 300.0] {
            let compliance = 8000.0 / coil.suspension_n_per_m(TAU * frequency_hz);
            let decades = Complex::new(frequency_hz / 50.0, 0.0).ln() / std::f64::consts::LN_10;
            let angle = std::f64::consts::FRAC_PI_2 / std::f64::consts::LN_10;
            let expected = 1.0 - per_decade * (decades + Complex::new(0.0, angle));
            let error = (compliance - expected).norm();
            let bound = per_decade * (1e-3 + frequency_hz / 1e4 / std::f64::consts::LN_10);
            assert!(error < bound, "{frequency_hz}: {error:e}");
        }
    }

    #[test]
    fn a_lossy_inductance_has_the_stated_reactance_at_one_kilohertz() {
        // |Z - R| = w0 L whatever the exponent, at 90 n degrees.
        for exponent in [0.5, 0.8, 1.0] {
            let reactance = coil(exponent).blocked_impedance(INDUCTANCE_OMEGA, 0.0) - 4.0;
            assert!((reactance.norm() / (INDUCTANCE_OMEGA * 1.2e-4) - 1.0).abs() < 1e-12);
            assert!((reactance.arg() - exponent * TAU / 4.0).abs() < 1e-12);
        }
    }
}
