//! Harmonic balance of the nonlinear exciter at a held level.
//!
//! The level fixes the fundamental of the motion, so the motion is the
//! unknown and the coil voltage the result: for an assumed motion the force,
//! then the current, then the voltage follow without solving anything. The
//! harmonics of the motion are right when the voltage has just those harmonics
//! the amplifier puts out. Each harmonic is corrected by its own linear
//! response (with the mean stiffness of the suspension) until that holds.

use super::exciter::Exciter;
use super::friction::{Friction, Rubbed};
use super::waveform::{Characteristic, clipped_order};
use crate::lanes::dot;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Highest harmonic of the balance.
pub(crate) const ORDERS: usize = 15;
/// Points of the time grid; a cubic force of 15 orders folds back onto orders above 18 only.
pub(super) const GRID: usize = 64;
/// Largest number of corrections.
const MOST_CORRECTIONS: usize = 60;
/// Correction of the motion, relative to its fundamental, at which the balance holds.
const TOLERANCE: f64 = 1e-9;
/// The same, relative to the first correction, where only a slope is wanted.
const SLOPE_TOLERANCE: f64 = 1e-3;

/// What bends the exciter away from the linear one, in one row.
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
    /// Amplifier output e + even e^2, in 1/V.
    pub(crate) even_per_v: f64,
    /// Weight along the axis of motion over mass: g cos(tilt), in m/s2.
    pub(crate) gravity_ms2: f64,
}

impl Bend {
    /// Whether anything is bent at all.
    pub(crate) fn is_linear(&self) -> bool {
        self.friction_n == 0.0 && self.is_dry_only()
    }

    /// Whether nothing but dry friction bends.
    fn is_dry_only(&self) -> bool {
        self.cubic_n_per_m3 == 0.0
            && self.quadratic_n_per_m2 == 0.0
            && self.droop_per_m2 == 0.0
            && self.clip_v.is_none()
            && self.even_per_v == 0.0
    }
}

/// What a balance is for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Purpose {
    /// The value itself.
    Value,
    /// The difference to the balance from which it starts.
    Slope,
}

/// Harmonics of the displacement, in m: order 0 is the rest position.
pub(crate) type Motion = [Complex64; ORDERS + 1];

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
    /// The same of the orders above 5.
    pub(crate) above: [Complex64; ORDERS - 5],
    /// Mean square of the orders above 5 over that of the fundamental.
    pub(crate) remainder: f64,
    /// What of it lies above [`ORDERS`].
    pub(crate) beyond: f64,
    /// Whether the armature rests for part of the period, which no order describes well.
    pub(crate) rests: bool,
    /// Whether the balance was reached.
    pub(crate) converged: bool,
}

/// Points of the first quarter of the grid, both ends included, and zeros up to a multiple of four.
const QUARTER: usize = 20;

/// Cosine and sine of every order on the first quarter of the grid: the other
/// quarters mirror it, with signs that depend on whether the order is even.
struct Tables {
    cos: [[f64; QUARTER]; ORDERS + 1],
    sin: [[f64; QUARTER]; ORDERS + 1],
}

fn tables() -> &'static Tables {
    static TABLES: std::sync::OnceLock<Tables> = std::sync::OnceLock::new();
    TABLES.get_or_init(|| {
        let angle = |n: usize, i: usize| TAU * ((n * i) % GRID) as f64 / GRID as f64;
        let inside = |i: usize| f64::from(u8::from(i <= GRID / 4));
        Tables {
            cos: std::array::from_fn(|n| std::array::from_fn(|i| inside(i) * angle(n, i).cos())),
            sin: std::array::from_fn(|n| std::array::from_fn(|i| inside(i) * angle(n, i).sin())),
        }
    })
}

/// Balances one row at the held acceleration (peak, phase zero).
///
/// `motion` is the start (all zero: none) and receives the solution, so that a
/// small change of a parameter needs few corrections.
pub(crate) fn balance(
    exciter: &Exciter,
    bend: &Bend,
    omega: f64,
    acceleration_peak_ms2: f64,
    motion: &mut Motion,
    purpose: Purpose,
) -> Balanced {
    let travel = -acceleration_peak_ms2 / (omega * omega);
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

/// Orders that can arise: forces that are odd in the motion make odd orders only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Parity {
    All,
    Odd,
}

impl Parity {
    fn of(bend: &Bend) -> Self {
        if bend.quadratic_n_per_m2 == 0.0 && bend.even_per_v == 0.0 {
            Self::Odd
        } else {
            Self::All
        }
    }

    fn orders(self) -> std::iter::StepBy<std::ops::RangeInclusive<usize>> {
        match self {
            Self::All => (0..=ORDERS).step_by(1),
            Self::Odd => (1..=ORDERS).step_by(2),
        }
    }
}

struct Work<'a> {
    exciter: &'a Exciter,
    bend: &'a Bend,
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
    fn new(exciter: &'a Exciter, bend: &'a Bend, omega: f64) -> Self {
        let mut impedance = [Complex64::from(exciter.resistance_ohm); ORDERS + 1];
        let mut stiffness = [Complex64::from(exciter.stiffness_n_per_m); ORDERS + 1];
        let parity = Parity::of(bend);
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
    fn rubbed(&self, travel_m: f64) -> Option<Motion> {
        let friction = self.friction.filter(|_| self.bend.is_dry_only())?;
        Some(friction.alone(travel_m))
    }

    /// Corrects the motion until the balance holds; whether it does.
    fn settle(&self, motion: &mut Motion, purpose: Purpose) -> (State, bool) {
        let mut enough = TOLERANCE * motion[1].re.abs();
        let mut state = self.voltages(motion);
        for step in 0..MOST_CORRECTIONS {
            let damping = if step < 25 { 1.0 } else { 0.5 };
            let (correction, size) = self.correction(&state, damping);
            if step == 0 && purpose == Purpose::Slope {
                enough = enough.max(SLOPE_TOLERANCE * size);
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
    fn voltages(&self, motion: &Motion) -> State {
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
        if self.bend.quadratic_n_per_m2 != 0.0 {
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
    fn suspended(&self, motion: &Motion) -> (Motion, f64) {
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
        motion: &Motion,
        force: &Motion,
        velocity: &Motion,
        bl: f64,
        emf: f64,
    ) -> (Motion, Motion) {
        let (x, mut f, mut v) = (synthesize(motion), synthesize(force), synthesize(velocity));
        for i in 0..GRID {
            let left = (1.0 - self.bend.droop_per_m2 * x[i] * x[i]).max(0.05);
            f[i] /= bl * left;
            v[i] *= emf * left;
        }
        (analyse(&f, self.parity), analyse(&v, self.parity))
    }

    /// Move of each harmonic towards the voltage the amplifier puts out, and the largest one in m.
    fn correction(&self, state: &State, damping: f64) -> (Motion, f64) {
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
        let sizes = moves.iter().enumerate();
        let largest = sizes.fold(0.0_f64, |m, (n, by)| {
            m.max(by.norm_sqr() * (n * n * n * n) as f64)
        });
        (moves, largest.sqrt())
    }

    /// Harmonics the amplifier adds to the fundamental coil voltage (peak phasor).
    fn amplifier(&self, fundamental: Complex64) -> Motion {
        let mut wanted = [Complex64::ZERO; ORDERS + 1];
        wanted[2] = fundamental * fundamental * (self.bend.even_per_v / 2.0);
        if let Some(threshold) = self.bend.clip_v {
            let clip = Characteristic::Clip { threshold };
            let size = fundamental.norm();
            if size > 0.75 * threshold {
                let input = clip.input_for(size);
                let turn = fundamental / size;
                for n in (3..=ORDERS).step_by(2) {
                    wanted[n] += turn.powu(n as u32) * clipped_order(n, input, threshold);
                }
            }
        }
        wanted
    }

    fn result(
        &self,
        motion: &Motion,
        state: &State,
        acceleration: f64,
        converged: bool,
    ) -> Balanced {
        let relative = |n: usize| motion[n] * (-(n as f64 * self.omega).powi(2) / acceleration);
        let (above, beyond) = (
            (6..=ORDERS).map(|n| relative(n).norm_sqr()).sum::<f64>(),
            self.friction.map_or(0.0, |f| f.beyond) / (acceleration * acceleration),
        );
        Balanced {
            acceleration_per_v: acceleration / state.voltage[1],
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

/// Values on the grid of a sum of harmonics.
pub(super) fn synthesize(orders: &Motion) -> [f64; GRID] {
    let t = tables();
    // Cosine and sine part of the even and of the odd orders.
    let mut part = [[[0.0; QUARTER]; 2]; 2];
    for (n, c) in orders.iter().enumerate() {
        if c.re == 0.0 && c.im == 0.0 {
            continue;
        }
        let [cosine, sine] = &mut part[n % 2];
        for i in 0..QUARTER {
            cosine[i] += c.re * t.cos[n][i];
            sine[i] -= c.im * t.sin[n][i];
        }
    }
    let [[even_c, even_s], [odd_c, odd_s]] = part;
    let mut out = [0.0; GRID];
    for i in 0..=GRID / 4 {
        out[i] = even_c[i] + even_s[i] + odd_c[i] + odd_s[i];
        out[GRID / 2 - i] = even_c[i] - even_s[i] - odd_c[i] + odd_s[i];
        out[GRID / 2 + i] = even_c[i] + even_s[i] - odd_c[i] - odd_s[i];
        out[(GRID - i) % GRID] = even_c[i] - even_s[i] + odd_c[i] - odd_s[i];
    }
    out
}

/// Harmonics of the values on the grid.
pub(super) fn analyse(signal: &[f64; GRID], parity: Parity) -> Motion {
    let t = tables();
    let mut folded = [[[0.0; QUARTER]; 2]; 2];
    for i in 0..=GRID / 4 {
        let four = [
            signal[i],
            signal[GRID / 2 - i],
            signal[GRID / 2 + i],
            signal[(GRID - i) % GRID],
        ];
        // The ends of the quarter belong to two of the four points each.
        let share = if i == 0 || i == GRID / 4 { 0.5 } else { 1.0 };
        let [a, b, c, d] = four.map(|v| share * v);
        folded[0][0][i] = a + b + c + d;
        folded[0][1][i] = a - b + c - d;
        folded[1][0][i] = a - b - c + d;
        folded[1][1][i] = a + b - c - d;
    }
    let mut orders = [Complex64::ZERO; ORDERS + 1];
    for n in parity.orders() {
        let scale = if n == 0 { 1.0 } else { 2.0 } / GRID as f64;
        let [cosine, sine] = &folded[n % 2];
        orders[n] = Complex64::new(
            scale * dot(cosine, &t.cos[n]),
            -scale * dot(sine, &t.sin[n]),
        );
    }
    orders
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every order comes back, and its values are those of cosine and sine: rounding of 64 terms only.
    #[test]
    fn a_sum_of_harmonics_is_analysed_into_the_same_harmonics() {
        let mut motion: Motion =
            std::array::from_fn(|n| Complex64::new(1.0 / (n + 1) as f64, 0.3 - 0.1 * n as f64));
        motion[0].im = 0.0;
        let signal = synthesize(&motion);
        for (i, value) in signal.iter().enumerate() {
            let expected: f64 = motion
                .iter()
                .enumerate()
                .map(|(n, c)| (c * Complex64::from_polar(1.0, TAU * (n * i) as f64 / 64.0)).re)
                .sum();
            assert!((value - expected).abs() < 1e-13, "{i}: {value} {expected}");
        }
        for (found, order) in analyse(&signal, Parity::All).iter().zip(&motion) {
            assert!((found - order).norm() < 1e-14);
        }
    }

    /// What is remembered is a start, not part of the answer: both solutions hold to the tolerance.
    #[test]
    fn a_balance_does_not_depend_on_what_another_bend_left() {
        let exciter = Exciter::example();
        let even = Bend {
            quadratic_n_per_m2: 2e5,
            gravity_ms2: 9.81,
            ..Bend::default()
        };
        let odd = Bend {
            cubic_n_per_m3: 1e9,
            ..Bend::default()
        };
        let cold = || [Complex64::ZERO; ORDERS + 1];
        let of = |bend: &Bend, motion: &mut Motion| {
            balance(&exciter, bend, TAU * 12.0, 5.0, motion, Purpose::Value)
        };
        for (first, second) in [(&even, &odd), (&odd, &even)] {
            let mut warm = cold();
            of(first, &mut warm);
            let (warm, cold) = (of(second, &mut warm), of(second, &mut cold()));
            assert!(warm.converged && cold.converged);
            for (a, b) in warm.harmonics.iter().zip(&cold.harmonics) {
                assert!((a - b).norm() < 10.0 * TOLERANCE, "{a} {b}");
            }
        }
    }
}
