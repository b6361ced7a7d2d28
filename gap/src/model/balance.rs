//! Harmonic balance of the nonlinear exciter at a held level.
//!
//! The level fixes the fundamental of the motion, so the motion is the
//! unknown and the coil voltage the result: for an assumed motion the force,
//! then the current, then the voltage follow without solving anything. The
//! harmonics of the motion are right when the voltage has just those harmonics
//! the amplifier puts out. Each harmonic is corrected by its own linear
//! response (with the mean stiffness of the suspension) until that holds.

use super::exciter::{Exciter, Nonlinearity};
use super::friction::{Friction, Rubbed};
use super::grid::{GRID, ORDERS, Parity, Wave, analyse, size, synthesize};
use super::saturation::saturated_from;
use super::waveform::{Characteristic, clipped_order};
use crate::thresholds;
use num_complex::Complex64;

/// Largest number of corrections.
const MOST_CORRECTIONS: usize = 60;

/// Inputs of a balance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Purpose {
    /// The value itself.
    Value,
    /// The difference to the balance from which it starts.
    Slope,
}

/// The balanced row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Balanced {
    /// Acceleration over coil voltage, fundamentals, in (m/s2)/V.
    pub(crate) acceleration_per_v: Complex64,
    /// Coil current over coil voltage, fundamentals, in S.
    pub(crate) admittance: Complex64,
    /// Force over displacement of the fundamentals: the describing function.
    pub(crate) stiffness: Complex64,
    /// Acceleration of orders 2..5 over the fundamental, phase relative to n times its phase.
    pub(crate) harmonics: [Complex64; 4],
    /// Acceleration of the orders above 5 over the fundamental.
    pub(crate) above: [Complex64; ORDERS - 5],
    /// Mean square of the orders above 5 over that of the fundamental.
    pub(crate) remainder: f64,
    /// Part of it above [`ORDERS`].
    pub(crate) beyond: f64,
    /// Whether the armature rests for part of the period, which no order describes well.
    pub(crate) rests: bool,
    /// Whether the balance was reached.
    pub(crate) converged: bool,
}

/// Balances one row at the held acceleration (peak, phase zero).
///
/// `motion` is the start (all zero: none) and receives the solution, so that a
/// small change of a parameter needs few corrections.
pub(crate) fn balance(
    exciter: &Exciter,
    bend: &Nonlinearity,
    omega: f64,
    acceleration_peak_ms2: f64,
    motion: &mut Wave,
    purpose: Purpose,
) -> Balanced {
    // From the body, phase zero.
    let travel = -acceleration_peak_ms2 / (omega * omega) / size(exciter.share_of_table(omega));
    if (motion[1].re / travel - 1.0).abs() > 1e-3 || !motion.iter().all(|m| m.is_finite()) {
        *motion = [Complex64::ZERO; ORDERS + 1];
    }
    motion[1] = Complex64::from(travel);
    let work = Work::new(exciter, bend, omega);
    if let Some(alone) = work.rubbed(travel) {
        *motion = alone;
        let state = work.voltages(motion);
        return work.result(motion, &state, acceleration_peak_ms2, true);
    }
    if work.parity == Parity::Odd {
        // What another bend has left there is not corrected.
        motion
            .iter_mut()
            .step_by(2)
            .for_each(|m| *m = Complex64::ZERO);
    }
    let remembers = motion
        .iter()
        .enumerate()
        .any(|(n, m)| n != 1 && *m != Complex64::ZERO);
    let (mut state, mut converged) = work.settle(motion, purpose);
    if !converged && remembers {
        // The remembered motion may lie in the basin of a parameter far away.
        *motion = [Complex64::ZERO; ORDERS + 1];
        motion[1] = Complex64::from(travel);
        (state, converged) = work.settle(motion, Purpose::Value);
    }
    work.result(motion, &state, acceleration_peak_ms2, converged)
}

struct Work<'a> {
    exciter: &'a Exciter,
    bend: &'a Nonlinearity,
    friction: Option<Friction>,
    parity: Parity,
    omega: f64,
    impedance: [Complex64; ORDERS + 1],
    stiffness: [Complex64; ORDERS + 1],
}

struct State {
    voltage: [Complex64; ORDERS + 1],
    current_1: Complex64,
    force_1: Complex64,
    mean_added_stiffness: f64,
    rubbed: Option<Rubbed>,
}

impl<'a> Work<'a> {
    fn new(exciter: &'a Exciter, bend: &'a Nonlinearity, omega: f64) -> Self {
        let mut impedance = [Complex64::from(exciter.resistance_ohm); ORDERS + 1];
        let mut stiffness = [Complex64::from(exciter.static_stiffness_n_per_m()); ORDERS + 1];
        let parity = bend.parity();
        for n in parity.orders().filter(|&n| n > 0) {
            impedance[n] = exciter.impedance(n as f64 * omega);
            stiffness[n] = exciter.dynamic_stiffness(n as f64 * omega);
        }
        let is_dry = bend.friction_n > 0.0;
        Self {
            exciter,
            bend,
            friction: is_dry.then(|| Friction::new(bend.friction_n, exciter, omega)),
            parity,
            omega,
            impedance,
            stiffness,
        }
    }

    /// The motion where dry friction is all that bends, which needs no correction; nothing where
    /// something else bends as well.
    fn rubbed(&self, travel_m: f64) -> Option<Wave> {
        let friction = self.friction.filter(|_| self.bend.is_dry_only())?;
        Some(friction.alone(travel_m))
    }

    /// Corrects the motion until the balance holds; whether it does.
    fn settle(&self, motion: &mut Wave, purpose: Purpose) -> (State, bool) {
        let mut enough = thresholds::BALANCED * motion[1].re.abs();
        let mut state = self.voltages(motion);
        for step in 0..MOST_CORRECTIONS {
            let damping = if step < 25 { 1.0 } else { 0.5 };
            let (correction, size) = self.correction(&state, damping);
            if step == 0 && purpose == Purpose::Slope {
                enough = enough.max(thresholds::BALANCED_SLOPE * size);
            }
            if size < enough {
                return (state, true);
            }
            if !size.is_finite() {
                break;
            }
            for (m, by) in motion.iter_mut().zip(&correction) {
                *m += by;
            }
            motion[0].im = 0.0;
            state = self.voltages(motion);
        }
        (state, false)
    }

    /// Coil voltage that the assumed motion needs.
    fn voltages(&self, motion: &Wave) -> State {
        let (mut added, mean_added_stiffness) = self.suspended(motion);
        let odd = self.parity == Parity::Odd;
        let rubbed = self.friction.map(|friction| friction.force(motion, odd));
        if let Some(rubbed) = &rubbed {
            for (added, order) in added.iter_mut().zip(&rubbed.orders) {
                *added += order;
            }
        }
        let mut force = [Complex64::ZERO; ORDERS + 1];
        for n in 0..=ORDERS {
            force[n] = self.stiffness[n] * motion[n] + added[n];
        }
        if self.parity == Parity::All {
            force[0] += self.exciter.mass_kg * self.bend.gravity_ms2;
        }
        let bl = self.exciter.force_factor_n_per_a;
        let emf_factor = bl * self.exciter.emf_ratio;
        let mut velocity = [Complex64::ZERO; ORDERS + 1];
        for n in 1..=ORDERS {
            velocity[n] = motion[n] * Complex64::new(0.0, n as f64 * self.omega);
        }
        let (current, emf) = if self.bend.droop_per_m2 == 0.0 {
            (force.map(|f| f / bl), velocity.map(|v| v * emf_factor))
        } else {
            self.drooping(motion, &force, &velocity, bl, emf_factor)
        };
        let mut voltage = [Complex64::ZERO; ORDERS + 1];
        for n in 0..=ORDERS {
            voltage[n] = self.impedance[n] * current[n] + emf[n];
        }
        State {
            voltage,
            current_1: current[1],
            force_1: force[1],
            mean_added_stiffness,
            rubbed,
        }
    }

    /// Force of the bent suspension, and its mean slope.
    fn suspended(&self, motion: &Wave) -> (Wave, f64) {
        let (k2, k3) = (self.bend.quadratic_n_per_m2, self.bend.cubic_n_per_m3);
        let mut added = [Complex64::ZERO; ORDERS + 1];
        let mut slope = 0.0;
        if k2 != 0.0 || k3 != 0.0 {
            let x = synthesize(motion);
            let mut force = [0.0; GRID];
            for (f, &x) in force.iter_mut().zip(&x) {
                *f = (k2 + k3 * x) * x * x;
                slope += (2.0 * k2 + 3.0 * k3 * x) * x;
            }
            slope /= GRID as f64;
            added = analyse(&force, self.parity);
        }
        (added, slope)
    }

    /// Current and induced voltage where the force factor falls with travel.
    fn drooping(
        &self,
        motion: &Wave,
        force: &Wave,
        velocity: &Wave,
        bl: f64,
        emf: f64,
    ) -> (Wave, Wave) {
        let (x, mut f, mut v) = (synthesize(motion), synthesize(force), synthesize(velocity));
        for i in 0..GRID {
            let left = (1.0 - self.bend.droop_per_m2 * x[i] * x[i]).max(0.05);
            f[i] /= bl * left;
            v[i] *= emf * left;
        }
        (analyse(&f, self.parity), analyse(&v, self.parity))
    }

    /// Move of each harmonic towards the voltage the amplifier puts out, and the largest one in m.
    fn correction(&self, state: &State, damping: f64) -> (Wave, f64) {
        let wanted = self.amplifier(state.voltage[1]);
        let bl = self.exciter.force_factor_n_per_a;
        let mut moves = [Complex64::ZERO; ORDERS + 1];
        let mut yields = [Complex64::ZERO; ORDERS + 1];
        for n in self.parity.orders().filter(|&n| n != 1) {
            let s = Complex64::new(0.0, n as f64 * self.omega);
            let stiffness = self.stiffness[n] + state.mean_added_stiffness;
            let response = self.impedance[n] * stiffness / bl + s * bl * self.exciter.emf_ratio;
            moves[n] = (wanted[n] - state.voltage[n]) / response * damping;
            if state.rubbed.is_some() {
                yields[n] = self.impedance[n] / (response * bl);
            }
        }
        if let Some(rubbed) = &state.rubbed {
            rubbed.follow(&mut moves, &yields);
        }
        // The mean counts as well: a sag alone moves nothing else at first.
        let sizes = moves.iter().enumerate();
        let largest = sizes.fold(0.0_f64, |m, (n, by)| {
            m.max(by.norm_sqr() * (n * n * n * n).max(1) as f64)
        });
        (moves, largest.sqrt())
    }

    /// Harmonics the amplifier adds to the fundamental coil voltage (peak phasor).
    fn amplifier(&self, fundamental: Complex64) -> Wave {
        let mut wanted = [Complex64::ZERO; ORDERS + 1];
        wanted[2] = fundamental * fundamental * (self.bend.even_per_v / 2.0);
        if let Some(threshold) = self.bend.clip_v {
            let clip = Characteristic::Clip { threshold };
            let size = fundamental.norm();
            if size > thresholds::NEAR_CLIPPING * threshold {
                let input = clip.input_for(size);
                let turn = fundamental / size;
                for n in (3..=ORDERS).step_by(2) {
                    wanted[n] += turn.powu(n as u32) * clipped_order(n, input, threshold);
                }
            }
        }
        if let Some(knee_v) = self.bend.knee_v {
            let size = fundamental.norm();
            let (saturated, turn) = (saturated_from(size / knee_v), fundamental / size);
            for n in (3..=ORDERS).step_by(2) {
                wanted[n] += turn.powu(n as u32) * (knee_v * saturated[n]);
            }
        }
        wanted
    }

    fn result(&self, motion: &Wave, state: &State, acceleration: f64, converged: bool) -> Balanced {
        let first = self.exciter.share_of_table(self.omega);
        let turn = first / size(first);
        let relative = |n: usize| {
            let here = motion[n] * (-(n as f64 * self.omega).powi(2) / acceleration);
            match self.exciter.body {
                None => here,
                Some(_) => {
                    let share = self.exciter.share_of_table(n as f64 * self.omega);
                    here * share * turn.powu(n as u32).conj()
                }
            }
        };
        let (above, beyond) = (
            (6..=ORDERS).map(|n| relative(n).norm_sqr()).sum::<f64>(),
            self.friction.map_or(0.0, |f| f.beyond) / (acceleration * acceleration),
        );
        Balanced {
            acceleration_per_v: acceleration * turn / state.voltage[1],
            admittance: state.current_1 / state.voltage[1],
            stiffness: state.force_1 / motion[1],
            harmonics: std::array::from_fn(|k| relative(k + 2)),
            above: std::array::from_fn(|k| relative(k + 6)),
            remainder: above + beyond,
            beyond,
            rests: self.friction.is_some_and(|f| f.rests(motion[1].re)),
            converged,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// The memory is a start, not part of the answer: both solutions hold to the tolerance.
    #[test]
    fn a_balance_does_not_depend_on_what_another_bend_left() {
        let exciter = Exciter::example();
        let even = Nonlinearity {
            quadratic_n_per_m2: 2e5,
            gravity_ms2: 9.81,
            ..Nonlinearity::default()
        };
        let odd = Nonlinearity {
            cubic_n_per_m3: 1e9,
            ..Nonlinearity::default()
        };
        let cold = || [Complex64::ZERO; ORDERS + 1];
        let of = |bend: &Nonlinearity, motion: &mut Wave| {
            balance(&exciter, bend, TAU * 12.0, 5.0, motion, Purpose::Value)
        };
        for (first, second) in [(&even, &odd), (&odd, &even)] {
            let mut warm = cold();
            of(first, &mut warm);
            let (warm, cold) = (of(second, &mut warm), of(second, &mut cold()));
            assert!(warm.converged && cold.converged);
            for (a, b) in warm.harmonics.iter().zip(&cold.harmonics) {
                assert!((a - b).norm() < 10.0 * thresholds::BALANCED, "{a} {b}");
            }
        }
    }

    /// A cubic spring about its sag x0 is `k + 3 k3 x0^2` stiff there and has `3 k3 x0` to one side: a step of the
    /// weight alone must move the balance from where it was. X is the amplitude.
    #[test]
    fn a_step_of_the_weight_moves_the_second_harmonic() {
        let exciter = Exciter::example();
        let sagging = |gravity_ms2| Nonlinearity {
            cubic_n_per_m3: 1e7,
            gravity_ms2,
            ..Nonlinearity::default()
        };
        let mut motion = [Complex64::ZERO; ORDERS + 1];
        let mut of = |gravity_ms2: f64, purpose| {
            balance(
                &exciter,
                &sagging(gravity_ms2),
                TAU * 12.0,
                5.0,
                &mut motion,
                purpose,
            )
        };
        let before = of(9.81, Purpose::Value).harmonics[0];
        let after = of(9.81 * 1.001, Purpose::Slope).harmonics[0];
        // The second harmonic goes with the sag; its square stiffens the spring by 1e-3.
        assert!(
            ((after / before).re - 1.001).abs() < 1e-5,
            "{after} {before}"
        );
    }
}
