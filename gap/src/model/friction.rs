//! Dry friction in the harmonic balance: a force that turns where the velocity does.

use super::exciter::Exciter;
use super::grid::{ORDERS, Wave};
use num_complex::Complex64;
use std::f64::consts::PI;

/// First odd order above [`ORDERS`].
const FIRST_BEYOND: usize = ORDERS + 1 + ORDERS % 2;

/// The friction of one row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Friction {
    force_n: f64,
    yields: Yields,
    /// Part of the orders above [`ORDERS`] in the velocity over omega where it turns
    /// upwards, in m.
    tail_m: f64,
    /// Mass that is moved times omega squared, in N/m.
    inertia_n_per_m: f64,
    /// Sum of the squares of the accelerations at those orders (peak), in (m/s2)^2.
    pub(super) beyond: f64,
}

impl Friction {
    pub(super) fn new(force_n: f64, exciter: &Exciter, omega: f64) -> Self {
        let yields = Yields::new(exciter, omega);
        let inertia_n_per_m = exciter.reduced_mass_kg() * omega * omega;
        let (tail_m, beyond) = tail(force_n, &yields, exciter, omega);
        Self {
            force_n,
            yields,
            tail_m,
            inertia_n_per_m,
            beyond,
        }
    }

    /// The motion with this fundamental (m, negative, phase zero) where nothing else bends.
    ///
    /// Each order of the force, -4 j F/(pi n) turned by n times the angle of the zero, then moves
    /// what yields to it, and turns back at the zero: what the orders add to the velocity there
    /// depends on no angle, and the zero is where the fundamental makes up for it.
    pub(super) fn alone(&self, travel_m: f64) -> Wave {
        let force = square_wave(self.force_n);
        let back = self.turn(travel_m).conj();
        let (mut turn, twice) = (back, back * back);
        let mut motion = [Complex64::ZERO; ORDERS + 1];
        motion[1] = Complex64::from(travel_m);
        for (n, yields) in self.within() {
            turn *= twice;
            motion[n] = Complex64::I * yields * (force / n as f64) * turn;
        }
        motion
    }

    /// Whether the armature rests after it has turned: friction then acts against what pulls it, and
    /// the acceleration, over omega^2 as all here, would have the wrong sign. It is that of the
    /// fundamental and of the orders (in the middle of the jump), less half of the jump. So it is
    /// where the suspension carries the motion, and friction makes it ring.
    pub(super) fn rests(&self, travel_m: f64) -> bool {
        let force = square_wave(self.force_n);
        let orders = self.yields.orders(3);
        let drag: f64 = orders.map(|(n, yields)| n as f64 * yields.im).sum();
        let pull_m = travel_m.abs() * self.turn(travel_m).re + force * drag;
        pull_m < self.force_n / self.inertia_n_per_m
    }

    /// `e^{j angle}` where the velocity turns upwards if nothing else bends; at most a quarter turn,
    /// where the fundamental cannot make up for the orders.
    fn turn(&self, travel_m: f64) -> Complex64 {
        let turned: f64 = self.within().map(|(_, yields)| yields.re).sum();
        let missing_m = self.tail_m - square_wave(self.force_n) * turned;
        // The fundamental adds -travel sin(angle).
        let sine = (missing_m / travel_m).clamp(-1.0, 1.0);
        Complex64::new((1.0 - sine * sine).sqrt(), sine)
    }

    /// The harmonics up to [`ORDERS`], with what yields to them.
    fn within(&self) -> impl Iterator<Item = (usize, Complex64)> + '_ {
        self.yields.orders(3).take_while(|(n, _)| *n <= ORDERS)
    }

    /// The force, from the two zeros of the velocity; `odd` where the motion has odd orders only, and
    /// its second half is the first one mirrored.
    pub(super) fn force(&self, motion: &Wave, odd: bool) -> Rubbed {
        // x = -|x1| cos: the velocity is positive between the zeros near 0 and pi.
        let start = Zero::new(motion, 0.0, self.tail_m, odd);
        let from = Complex64::from_polar(1.0, -start.angle);
        let (end, to) = if odd {
            (start.angle + PI, -from)
        } else {
            let end = Zero::new(motion, PI, -self.tail_m, odd).angle;
            (end, Complex64::from_polar(1.0, -end))
        };
        let mut orders = [Complex64::ZERO; ORDERS + 1];
        orders[0] = Complex64::from(self.force_n * ((end - start.angle) / PI - 1.0));
        let (mut at_start, mut at_end) = (Complex64::ONE, Complex64::ONE);
        for (n, order) in orders.iter_mut().enumerate().skip(1) {
            at_start *= from;
            at_end *= to;
            let jump = Complex64::new(0.0, 2.0 * self.force_n / (PI * n as f64));
            *order = (at_end - at_start) * jump;
        }
        let turn = odd.then(|| (from.conj(), start.slope_m));
        Rubbed { orders, turn }
    }
}

/// Fundamental of a force that jumps between `force_n` and its negative; order n has 1/n of it.
fn square_wave(force_n: f64) -> f64 {
    4.0 * force_n / PI
}

/// The force of friction for an assumed motion.
pub(super) struct Rubbed {
    /// Its Fourier coefficients, N.
    pub(super) orders: Wave,
    /// Of an odd motion, `e^{j angle}` where the armature turns, and the slope of its velocity over
    /// omega there, m.
    turn: Option<(Complex64, f64)>,
}

impl Rubbed {
    /// Adds to a correction of the motion that the armature then turns elsewhere, which moves every
    /// order of the force, and with them the motion: each yields `yields` m/N. To first order, one
    /// equation for the angle; without it a strong friction takes some ten corrections more.
    pub(super) fn follow(&self, moves: &mut Wave, yields: &Wave) {
        let Some((turn, slope_m)) = self.turn else {
            return;
        };
        let (mut late, mut stiff) = (0.0, slope_m);
        let mut shift = [Complex64::ZERO; ORDERS + 1];
        let (mut around, twice) = (turn, turn * turn);
        for n in (3..=ORDERS).step_by(2) {
            around *= twice;
            shift[n] = self.orders[n] * yields[n] * Complex64::new(0.0, n as f64);
            late += n as f64 * (moves[n] * around).im;
            stiff -= n as f64 * (shift[n] * around).im;
        }
        if stiff <= 0.0 {
            return;
        }
        let angle = (late / stiff).clamp(-0.3, 0.3);
        for (order, shift) in moves.iter_mut().zip(&shift) {
            *order += shift * angle;
        }
    }
}

/// A zero of the velocity.
struct Zero {
    angle: f64,
    /// Slope of the velocity over omega, in m.
    slope_m: f64,
}

impl Zero {
    /// The one near `angle`, where the velocity over omega and what is missing in it vanish.
    fn new(motion: &Wave, mut angle: f64, missing_m: f64, odd: bool) -> Self {
        let stride = if odd { 2 } else { 1 };
        let mut slope_m = 0.0;
        for _ in 0..8 {
            let mut value = missing_m;
            slope_m = 0.0;
            let turn = Complex64::from_polar(1.0, angle);
            let by = if odd { turn * turn } else { turn };
            let mut turned = turn;
            for (n, x) in motion.iter().enumerate().skip(1).step_by(stride) {
                let k = n as f64;
                let velocity = x * turned * k;
                value -= velocity.im;
                slope_m -= k * velocity.re;
                turned *= by;
            }
            let step = (value / slope_m).clamp(-0.3, 0.3);
            angle -= step;
            // What is left is of the order of its square.
            if step.abs() < 1e-7 {
                break;
            }
        }
        Self { angle, slope_m }
    }
}

/// Where friction turns, the acceleration jumps, and the velocity has a bend that a finite sum
/// of orders rounds off: it misses the zero by a share that falls with the number of orders only
/// as 1/n. The orders that are missing are known: the voltage has none of them, so the force of
/// friction alone, -4 j F/(pi n) at the zero, moves mass, suspension and coil.
///
/// Answers what they add to the velocity over omega there, and the sum of the squares of their
/// accelerations in space: what an instrument that samples sees of them, folded back, as noise.
fn tail(force_n: f64, yields: &Yields, exciter: &Exciter, omega: f64) -> (f64, f64) {
    let (mut turned, mut squares) = (0.0, 0.0);
    for (n, yields) in yields.orders(FIRST_BEYOND) {
        let share = exciter.share_of_table(omega * n as f64);
        turned += yields.re;
        squares += (n * n) as f64 * yields.norm_sqr() * share.norm_sqr();
    }
    // Beyond them the masses alone, in N/m: the sum of 1/n^2 over odd n > N is 1/(2 (N + 1)), to N^-3.
    let rest = 0.5 / (SUMMED + 1) as f64;
    let [moved, table] =
        [exciter.reduced_mass_kg(), exciter.mass_kg].map(|mass_kg| mass_kg * omega * omega);
    let force = square_wave(force_n);
    (
        -force * (turned - rest / moved),
        (force * omega * omega).powi(2) * (squares + rest / (table * table)),
    )
}

/// Odd orders from 3 on.
const COUNT: usize = 24;
/// Highest of them.
pub(super) const SUMMED: usize = order(COUNT - 1);

const fn order(place: usize) -> usize {
    3 + 2 * place
}

/// Displacement per force at the odd orders, m/N. Kept as columns, which the processor takes several
/// at a time: a search asks for them some hundred thousand times.
#[derive(Debug, Clone, Copy)]
pub(super) struct Yields {
    re: [f64; COUNT],
    im: [f64; COUNT],
}

impl Yields {
    /// `Z/((k + j c w - M' w^2) Z + j w Bl^2)` at n times `omega`: the coil is closed by what feeds it.
    pub(super) fn new(exciter: &Exciter, omega: f64) -> Self {
        let (mut re, mut im) = ([0.0; COUNT], [0.0; COUNT]);
        let impedance: [Complex64; COUNT] =
            std::array::from_fn(|at| exciter.impedance(omega * order(at) as f64));
        let stiffness: [Complex64; COUNT] =
            std::array::from_fn(|at| exciter.dynamic_stiffness(omega * order(at) as f64));
        let coupling = exciter.force_factor_n_per_a.powi(2) * exciter.emf_ratio;
        for at in 0..COUNT {
            let w = omega * order(at) as f64;
            let (spring, drag) = (stiffness[at].re, stiffness[at].im);
            let z = impedance[at];
            let below_re = spring * z.re - drag * z.im;
            let below_im = spring * z.im + drag * z.re + coupling * w;
            let size = 1.0 / (below_re * below_re + below_im * below_im);
            re[at] = (z.re * below_re + z.im * below_im) * size;
            im[at] = (z.im * below_re - z.re * below_im) * size;
        }
        Self { re, im }
    }

    /// Each order from `first` (odd) on, with what it yields.
    pub(super) fn orders(&self, first: usize) -> impl Iterator<Item = (usize, Complex64)> + '_ {
        let from = (first - order(0)) / 2;
        (from..COUNT).map(|at| (order(at), Complex64::new(self.re[at], self.im[at])))
    }
}

#[cfg(test)]
mod tests {
    use super::{Friction, ORDERS, Yields};
    use crate::model::balance::{Purpose, balance};
    use crate::model::exciter::Exciter;
    use crate::model::exciter::Nonlinearity;
    use num_complex::Complex64;
    use std::f64::consts::{PI, TAU};

    /// The rig was integrated in time, each turning point found by bisection and each piece
    /// solved exactly (matrix exponential), until it repeated: third harmonic over the fundamental
    /// at 160 Hz, at this level. A sum of 15 orders alone misses it by 7.5e-4.
    #[test]
    fn the_third_harmonic_is_that_of_the_motion_in_time() {
        let exciter = Exciter::example();
        let friction = Nonlinearity {
            friction_n: 0.0154,
            ..Nonlinearity::default()
        };
        let mut motion = [Complex64::ZERO; ORDERS + 1];
        let found = balance(
            &exciter,
            &friction,
            TAU * 160.0,
            1.413_782_638,
            &mut motion,
            Purpose::Value,
        );
        let expected = Complex64::new(-0.008_562_984, 0.051_293_902);
        assert!(
            (found.harmonics[1] - expected).norm() < 5e-6,
            "{}",
            found.harmonics[1]
        );
    }

    /// Without corrections the motion is the one that corrections lead to, to where these stop
    /// (1e-9 of the fundamental); a cubic spring of nothing makes them necessary.
    #[test]
    fn friction_alone_needs_no_corrections() {
        let exciter = Exciter::example();
        for (friction_n, level) in [(0.005, 2.0), (0.02, 1.4), (0.5, 30.0)] {
            let alone = Nonlinearity {
                friction_n,
                ..Nonlinearity::default()
            };
            let corrected = Nonlinearity {
                cubic_n_per_m3: 1e-9,
                ..alone
            };
            for frequency_hz in [5.0, 40.0, 160.0, 2500.0] {
                let of = |bend| {
                    let mut motion = [Complex64::ZERO; ORDERS + 1];
                    let omega = TAU * frequency_hz;
                    balance(&exciter, bend, omega, level, &mut motion, Purpose::Value)
                };
                let (found, expected) = (of(&alone), of(&corrected));
                assert!(expected.converged && found.converged);
                for (a, b) in found.harmonics.iter().zip(&expected.harmonics) {
                    assert!((a - b).norm() < 1e-8, "{frequency_hz} Hz: {a} {b}");
                }
                let change = (found.acceleration_per_v / expected.acceleration_per_v - 1.0).norm();
                assert!(change < 1e-8, "{frequency_hz} Hz: {change}");
            }
        }
    }

    /// Far above the resonance of the suspension the armature rests where friction is more than its
    /// inertia when it turns: F/m above the peak acceleration times the cosine of the angle, whose
    /// sine is `pi/2 - 4/pi` of F/m over that peak. Below, at 5 Hz, the jump makes the suspension
    /// ring, and it rests at less: an integration in time found it at 0.2 N and 4 m/s2, not at 0.05 N.
    #[test]
    fn the_armature_rests_where_friction_stops_it_again() {
        let exciter = Exciter {
            mass_kg: 0.07,
            ..Exciter::example()
        };
        let rests = |friction_n: f64, frequency_hz: f64, peak_ms2: f64| {
            let omega = TAU * frequency_hz;
            let travel_m = -peak_ms2 / (omega * omega);
            Friction::new(friction_n, &exciter, omega).rests(travel_m)
        };
        assert!(rests(0.2, 5.0, 4.0) && !rests(0.05, 5.0, 4.0));
        let late = PI / 2.0 - 4.0 / PI;
        let limit_ms2 = 0.2 / exciter.mass_kg * 1_f64.hypot(late);
        assert!(rests(0.2, 5000.0, 0.99 * limit_ms2) && !rests(0.2, 5000.0, 1.01 * limit_ms2));
    }

    /// On a mass alone the acceleration of friction is a square wave of F/m: 2 (F/m)^2 in all orders
    /// (Parseval), of which (4/(pi n))^2 are in order n. The suspension and the coil add some 1e-5,
    /// and the fifteen orders of the balance are as good as the zeros: 1e-4.
    #[test]
    fn the_orders_above_the_fifth_hold_what_is_left_of_a_square_wave() {
        let exciter = Exciter {
            stiffness_n_per_m: 1.0,
            damping_ns_per_m: 0.0,
            force_factor_n_per_a: 1.0,
            resistance_ohm: 1e4,
            ..Exciter::example()
        };
        let friction = Nonlinearity {
            friction_n: 0.02,
            ..Nonlinearity::default()
        };
        let (omega, level) = (TAU * 160.0, 10.0);
        let mut motion = [Complex64::ZERO; ORDERS + 1];
        let purpose = Purpose::Value;
        let found = balance(&exciter, &friction, omega, level, &mut motion, purpose);
        let reported: f64 = [1.0, 3.0, 5.0]
            .map(|n: f64| (4.0 / (PI * n)).powi(2))
            .iter()
            .sum();
        let share = friction.friction_n / exciter.mass_kg / level;
        let expected = share * share * (2.0 - reported);
        assert!(
            (found.remainder / expected - 1.0).abs() < 1e-3,
            "{} {expected}",
            found.remainder
        );
    }

    /// A force on the armature is a voltage `Z/Bl` times as large at the coil.
    #[test]
    fn a_force_moves_what_its_voltage_would() {
        let exciter = Exciter {
            inductance_exponent: 0.7,
            ..Exciter::example()
        };
        let omega = 600.0;
        for (n, yields) in Yields::new(&exciter, omega).orders(3) {
            let w = omega * n as f64;
            let per_volt = exciter.acceleration_per_v(w) / -(w * w);
            let expected = per_volt * exciter.impedance(w) / exciter.force_factor_n_per_a;
            assert!((yields / expected - 1.0).norm() < 1e-12, "{n}");
        }
    }
}
