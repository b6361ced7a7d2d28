//! A linear network, composed section by section into one state space.
//!
//! ```text
//! d/dt state = rows . (state, inputs)        signal = coefficients . (state, inputs)
//! ```
//!
//! Sections are added in the order the signal flows, so every row only refers to earlier states or
//! its own section: the system matrix is block lower triangular, which the stepper exploits.
//! States are scaled by the section's corner frequency, so that all entries of a row are of the
//! order of that frequency and the matrix exponential stays well conditioned.

use std::f64::consts::{PI, TAU};

use nalgebra::{Complex, DMatrix, DVector};

use crate::model::{BodyModel, CoilModel, Creep, InductanceLadder, SecondOrder};

/// Factor a coefficient of a [`Signal`] multiplies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Source {
    State(usize),
    Input(usize),
}

/// A signal of the network: a linear combination of its states and inputs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Signal {
    terms: Vec<(Source, f64)>,
}

impl Signal {
    /// `self + factor * other`.
    #[must_use]
    pub fn plus(mut self, factor: f64, other: &Self) -> Self {
        for &(source, value) in &other.terms {
            match self.terms.iter_mut().find(|term| term.0 == source) {
                Some(term) => term.1 += factor * value,
                None => self.terms.push((source, factor * value)),
            }
        }
        self
    }

    /// `factor * self`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self::default().plus(factor, self)
    }
}

/// The linear part of a voltage-driven moving coil with a rigid table.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingCoil {
    /// Armature and payload, kg.
    pub mass_kg: f64,
    /// Suspension stiffness, N/m.
    pub stiffness_n_per_m: f64,
    /// How the suspension creeps, if it does.
    pub creep: Option<Creep>,
    /// Viscous damping, N s/m.
    pub damping_ns_per_m: f64,
    /// Force factor Bl, N/A (= V s/m).
    pub force_factor_n_per_a: f64,
    /// Induced voltage over `Bl v`.
    pub emf_ratio: f64,
    /// Coil resistance, ohm.
    pub resistance_ohm: f64,
    /// Coil inductance with its losses.
    pub ladder: InductanceLadder,
    /// The body, if it moves.
    pub body: Option<BodyModel>,
    /// Masses on springs, each on the one before, the first on the armature.
    pub carried: Vec<Carried>,
}

/// A mass on a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carried {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Stiffness below it, N/m.
    pub stiffness_n_per_m: f64,
    /// Damping below it, N s/m.
    pub damping_ns_per_m: f64,
}

impl MovingCoil {
    /// The linear part of `coil` after `time_s` under load.
    pub fn of(coil: &CoilModel, time_s: f64) -> Self {
        Self {
            mass_kg: coil.mass_kg,
            stiffness_n_per_m: coil.stiffness_n_per_m,
            creep: coil.creep(),
            damping_ns_per_m: coil.damping_ns_per_m,
            force_factor_n_per_a: coil.force_factor_n_per_a,
            emf_ratio: coil.emf_ratio,
            resistance_ohm: coil.warm_resistance_ohm(time_s),
            ladder: coil.ladder(),
            body: coil.body,
            carried: Vec::new(),
        }
    }
}

/// Signals a moving coil offers.
#[derive(Clone, Debug)]
pub struct CoilSignals {
    /// Coil current, A.
    pub current: Signal,
    /// Travel from rest, from the body, m.
    pub travel: Signal,
    /// Velocity, from the body, m/s.
    pub velocity: Signal,
    /// Travel in space, m.
    pub position: Signal,
    /// Rate of the current, A/s.
    pub current_rate: Signal,
    /// Acceleration, m/s2.
    pub acceleration: Signal,
    /// Acceleration of each mass it carries, m/s2.
    pub carried: Vec<Signal>,
}

/// A body on its way into the network; without one, at rest.
#[derive(Default)]
struct Standing {
    /// Its states: velocity and travel, in the unit of the armature's.
    indices: Option<[usize; 2]>,
    velocity: Signal,
    travel: Signal,
}

/// A carried mass on its way into the network.
struct Hung {
    /// Index of the state that is its velocity.
    index: usize,
    mass_kg: f64,
    /// Force on it from below, N.
    force: Signal,
}

/// Travel is scaled by 1 krad/s, near w0, to be of the order of the velocity.
const TRAVEL_SCALE_PER_S: f64 = 1000.0;

/// A linear network under construction.
#[derive(Clone, Debug, Default)]
pub struct Network {
    rows: Vec<Signal>,
    inputs: usize,
}

impl Network {
    /// Adds an independent input.
    pub fn input(&mut self) -> Signal {
        self.inputs += 1;
        Signal {
            terms: vec![(Source::Input(self.inputs - 1), 1.0)],
        }
    }

    /// Adds a state whose derivative is set later by [`Self::drive_state`].
    fn state(&mut self) -> (usize, Signal) {
        let index = self.rows.len();
        self.rows.push(Signal::default());
        let signal = Signal {
            terms: vec![(Source::State(index), 1.0)],
        };
        (index, signal)
    }

    /// The integral of `rate` over time.
    pub fn integral(&mut self, rate: &Signal) -> Signal {
        let (index, signal) = self.state();
        self.rows[index] = rate.clone();
        signal
    }

    /// A first-order low-pass with its corner at `corner_hz`.
    pub fn low_pass(&mut self, input: &Signal, corner_hz: f64) -> Signal {
        let (index, output) = self.state();
        self.rows[index] = input.clone().plus(-1.0, &output).scaled(TAU * corner_hz);
        output
    }

    /// A first-order high-pass with its corner at `corner_hz`.
    pub fn high_pass(&mut self, input: &Signal, corner_hz: f64) -> Signal {
        let low = self.low_pass(input, corner_hz);
        input.clone().plus(-1.0, &low)
    }

    /// A second-order section.
    ///
    /// States are `y` and `y'/w0` of the section's low-pass response `y`.
    pub fn second_order(&mut self, input: &Signal, section: SecondOrder) -> Signal {
        let omega = TAU * section.corner_hz;
        let (low_index, low) = self.state();
        let (band_index, band) = self.state();
        // (s/w0)^2 y = u - y - (s/w0) y / Q
        let high = input
            .clone()
            .plus(-1.0, &low)
            .plus(-1.0 / section.quality_factor, &band);
        self.rows[low_index] = band.scaled(omega);
        self.rows[band_index] = high.scaled(omega);
        let [n0, n1, n2] = section.numerator;
        let mut output = Signal::default();
        for (factor, part) in [(n0, &low), (n1, &band), (n2, &high)] {
            if factor != 0.0 {
                output = output.plus(factor, part);
            }
        }
        output
    }

    /// A Butterworth low-pass of even `order` with its -3 dB corner at `corner_hz`.
    pub fn butterworth(&mut self, input: &Signal, order: u32, corner_hz: f64) -> Signal {
        (0..order / 2).fold(input.clone(), |signal, index| {
            // Poles on the unit circle at pi (2 k + 1) / (2 n) from the imaginary axis.
            let angle = PI * f64::from(2 * index + 1) / f64::from(2 * order);
            let section = SecondOrder {
                corner_hz,
                quality_factor: 0.5 / angle.sin(),
                numerator: [1.0, 0.0, 0.0],
            };
            self.second_order(&signal, section)
        })
    }

    /// A moving coil driven by `voltage`, with `force_n` acting on the table beside the coil's.
    ///
    /// # Equation
    /// `L i' = u - R i - e Bl v - sum R_k (i - j_k)`, `j_k' = x_k (i - j_k)`,
    /// `M a = Bl i - c v - k x + F`, `x' = v`, `v' = a - a_b`, and of a body that moves
    /// `Mb a_b = -(Bl i - c v - k x + F) - c_b v_b - k_b x_b`.
    ///
    /// # Shape
    /// The first three states are current, velocity and travel (in mm), then velocity and travel of a body
    /// that moves; the `j_k` follow.
    pub fn moving_coil(
        &mut self,
        voltage: &Signal,
        force_n: &Signal,
        coil: &MovingCoil,
    ) -> CoilSignals {
        let (current_index, current) = self.state();
        let (velocity_index, velocity) = self.state();
        let (travel_index, scaled_travel) = self.state();
        let travel = scaled_travel.scaled(1.0 / TRAVEL_SCALE_PER_S);
        let standing = self.stand(coil.body);
        let stretched = self.stretched(&scaled_travel, coil.creep);
        let hung = self.hang(
            &velocity.clone().plus(1.0, &standing.velocity),
            &coil.carried,
        );
        let mut on_armature = current
            .scaled(coil.force_factor_n_per_a)
            .plus(-coil.damping_ns_per_m, &velocity)
            .plus(-coil.stiffness_n_per_m / TRAVEL_SCALE_PER_S, &stretched)
            .plus(1.0, force_n);
        let recoil = self.drive_body(&standing, coil.body, &on_armature);
        if let Some(first) = hung.first() {
            on_armature = on_armature.plus(-1.0, &first.force);
        }
        let acceleration = on_armature.scaled(1.0 / coil.mass_kg);
        let carried = self.drive_hung(&hung);
        let mut across_inductance = voltage
            .clone()
            .plus(-coil.resistance_ohm - coil.ladder.resistance_ohm, &current)
            .plus(-coil.emf_ratio * coil.force_factor_n_per_a, &velocity);
        for &(resistance_ohm, rate_rad_s) in &coil.ladder.pairs {
            let branch = self.low_pass(&current, rate_rad_s / TAU);
            let through = current.clone().plus(-1.0, &branch);
            across_inductance = across_inductance.plus(-resistance_ohm, &through);
        }
        let current_rate = across_inductance.scaled(1.0 / coil.ladder.inductance_h);
        self.rows[current_index] = current_rate.clone();
        self.rows[velocity_index] = acceleration.clone().plus(-1.0, &recoil);
        self.rows[travel_index] = velocity.scaled(TRAVEL_SCALE_PER_S);
        CoilSignals {
            current,
            position: travel.clone().plus(1.0, &standing.travel),
            travel,
            velocity,
            current_rate,
            acceleration,
            carried,
        }
    }

    /// Stretch at which a spring of the stated stiffness would pull as much.
    ///
    /// # Equation
    /// `c0 y = x - sum q_k`, `q_k' = x_k (c_k y - q_k)`: what yields later follows the force.
    fn stretched(&mut self, travel: &Signal, creep: Option<Creep>) -> Signal {
        let Some(creep) = creep else {
            return travel.clone();
        };
        let late: Vec<(usize, Signal)> = Creep::rates().map(|_| self.state()).collect();
        let left = late
            .iter()
            .fold(travel.clone(), |left, (_, q)| left.plus(-1.0, q));
        let stretched = left.scaled(1.0 / creep.at_once);
        for ((index, q), rate) in late.iter().zip(Creep::rates()) {
            self.rows[*index] = stretched.scaled(creep.share).plus(-1.0, q).scaled(rate);
        }
        stretched
    }

    /// States of a body.
    fn stand(&mut self, body: Option<BodyModel>) -> Standing {
        body.map_or_else(Standing::default, |_| {
            let (velocity_index, velocity) = self.state();
            let (travel_index, travel) = self.state();
            Standing {
                indices: Some([velocity_index, travel_index]),
                velocity,
                travel: travel.scaled(1.0 / TRAVEL_SCALE_PER_S),
            }
        })
    }

    /// Gives a body its rows; returns its acceleration.
    fn drive_body(
        &mut self,
        standing: &Standing,
        body: Option<BodyModel>,
        on_armature: &Signal,
    ) -> Signal {
        let (Some(body), Some([velocity, travel])) = (body, standing.indices) else {
            return Signal::default();
        };
        let on_body = on_armature
            .scaled(-1.0)
            .plus(-body.damping_ns_per_m, &standing.velocity)
            .plus(-body.stiffness_n_per_m, &standing.travel);
        let acceleration = on_body.scaled(1.0 / body.mass_kg);
        self.rows[velocity] = acceleration.clone();
        self.rows[travel] = standing.velocity.scaled(TRAVEL_SCALE_PER_S);
        acceleration
    }

    /// States of masses, each on a spring on the one before, the first on what moves with `velocity`.
    ///
    /// # Equation
    /// `F = k d + c d'`, `d' = v_below - v`; the state is `w d` with `w = sqrt(k/m)`, of the order of a velocity.
    fn hang(&mut self, velocity: &Signal, carried: &[Carried]) -> Vec<Hung> {
        let mut below = velocity.clone();
        let hang_one = |one: &Carried| {
            let omega = (one.stiffness_n_per_m / one.mass_kg).sqrt();
            let (stretch_index, stretch) = self.state();
            let (index, own) = self.state();
            let closing = below.clone().plus(-1.0, &own);
            self.rows[stretch_index] = closing.scaled(omega);
            let force = stretch
                .scaled(one.stiffness_n_per_m / omega)
                .plus(one.damping_ns_per_m, &closing);
            below = own;
            Hung {
                index,
                mass_kg: one.mass_kg,
                force,
            }
        };
        carried.iter().map(hang_one).collect()
    }

    /// Gives the masses their rows; returns their accelerations.
    fn drive_hung(&mut self, hung: &[Hung]) -> Vec<Signal> {
        let accelerations = hung.iter().enumerate().map(|(place, one)| {
            let above = hung.get(place + 1).map(|next| next.force.clone());
            let net = one.force.clone().plus(-1.0, &above.unwrap_or_default());
            net.scaled(1.0 / one.mass_kg)
        });
        let accelerations: Vec<Signal> = accelerations.collect();
        for (one, acceleration) in hung.iter().zip(&accelerations) {
            self.rows[one.index] = acceleration.clone();
        }
        accelerations
    }

    /// Number of states.
    pub fn states(&self) -> usize {
        self.rows.len()
    }

    /// Number of inputs.
    pub fn inputs(&self) -> usize {
        self.inputs
    }

    /// System and input matrix side by side: `states` rows, `states + inputs` columns.
    pub fn matrix(&self) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.states(), self.states() + self.inputs);
        for (row, signal) in self.rows.iter().enumerate() {
            for (column, value) in self.columns(signal) {
                matrix[(row, column)] += value;
            }
        }
        matrix
    }

    /// The non-zero coefficients of `signal`, by column of (states, inputs).
    pub fn columns(&self, signal: &Signal) -> Vec<(usize, f64)> {
        let column = |source| match source {
            Source::State(index) => index,
            Source::Input(index) => self.states() + index,
        };
        let nonzero = signal.terms.iter().filter(|term| term.1 != 0.0);
        nonzero
            .map(|&(source, value)| (column(source), value))
            .collect()
    }

    /// Response of `signal` to input number `input` at `frequency_hz`, by solving the network's
    /// equations in the frequency domain.
    ///
    /// Returns `None` where the network has a pole on the imaginary axis.
    pub fn response(
        &self,
        signal: &Signal,
        input: usize,
        frequency_hz: f64,
    ) -> Option<Complex<f64>> {
        let count = self.states();
        let state = self.state_response(input, frequency_hz)?;
        let terms = self.columns(signal).into_iter().map(|(column, value)| {
            if column < count {
                state[column] * value
            } else {
                Complex::new(if column == count + input { value } else { 0.0 }, 0.0)
            }
        });
        Some(terms.sum())
    }

    /// Response of all states to input number `input`.
    fn state_response(&self, input: usize, frequency_hz: f64) -> Option<DVector<Complex<f64>>> {
        let count = self.states();
        if count == 0 {
            return Some(DVector::zeros(0));
        }
        let matrix = self.matrix().map(|value| Complex::new(value, 0.0));
        let mut system = -matrix.columns(0, count).into_owned();
        for index in 0..count {
            system[(index, index)] += Complex::new(0.0, TAU * frequency_hz);
        }
        system
            .lu()
            .solve(&matrix.column(count + input).into_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn response(network: &Network, signal: &Signal, frequency_hz: f64) -> Complex<f64> {
        network.response(signal, 0, frequency_hz).expect("stable")
    }

    #[test]
    fn sections_have_the_response_of_their_formula() {
        let mut network = Network::default();
        let input = network.input();
        let section = SecondOrder {
            corner_hz: 300.0,
            quality_factor: 7.0,
            numerator: [0.5, -2.0, 0.25],
        };
        let output = network.second_order(&input, section);
        let high = network.high_pass(&output, 20.0);
        for frequency_hz in [1.0, 20.0, 300.0, 4e3] {
            let p = Complex::new(0.0, frequency_hz / 300.0);
            let q = Complex::new(0.0, frequency_hz / 20.0);
            let expected = (p * p * 0.25 - p * 2.0 + 0.5) / (p * p + p / 7.0 + 1.0) * q / (q + 1.0);
            let error = response(&network, &high, frequency_hz) - expected;
            // Only f64 rounding of a 3 x 3 solve.
            assert!(
                error.norm() < 1e-12 * expected.norm().max(1.0),
                "{frequency_hz}"
            );
        }
    }

    #[test]
    fn butterworth_is_maximally_flat() {
        for order in [2, 4, 6, 8] {
            let mut network = Network::default();
            let input = network.input();
            let output = network.butterworth(&input, order, 1000.0);
            for ratio in [0.1_f64, 0.7, 1.0, 3.0] {
                let expected = 1.0 / (1.0 + ratio.powi(2 * order.cast_signed())).sqrt();
                let got = response(&network, &output, 1000.0 * ratio).norm();
                assert!((got / expected - 1.0).abs() < 1e-10, "{order} {ratio}");
            }
        }
    }
}
