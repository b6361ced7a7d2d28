//! Periodic motion of the nonlinear exciter by collocation in time.
//!
//! The fundamental of the motion is given; mean and harmonics are those at
//! which the coil voltage is what the amplifier makes of a sine.

use super::friction::friction_force;
use super::series::{HARMONICS, INSTANTS, Series, derivative, series, values};
use super::{Exciter, Solved};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64 as C;

/// Mean, then real and imaginary parts of orders 2..=[`HARMONICS`].
const UNKNOWNS: usize = 1 + 2 * (HARMONICS - 1);
/// Newton steps, and how many of them share a Jacobian.
const STEPS: usize = 24;
const STEPS_PER_JACOBIAN: usize = 6;

impl Exciter {
    pub(super) fn collocated(&self, w_per_s: f64, peak_ms2: f64) -> Solved {
        // Between table and body.
        let fundamental_m = -peak_ms2 / (w_per_s * w_per_s) / self.of_table(w_per_s).norm();
        let mut unknowns = vec![0.0; UNKNOWNS];
        let mut converged = self.newton(w_per_s, fundamental_m, &mut unknowns);
        if !converged {
            unknowns.fill(0.0);
            for share in [0.25, 0.5, 0.75, 1.0] {
                let part = self.with_share(share);
                converged = part.newton(w_per_s, fundamental_m, &mut unknowns);
            }
        }
        let travel_m = travel(fundamental_m, &unknowns);
        let (coil_v, coil_a) = self.coil(w_per_s, &travel_m);
        Solved {
            coil_v,
            coil_a,
            motion_ms2: self.acceleration(w_per_s, &travel_m),
            converged,
        }
    }

    /// Acceleration of the table.
    fn acceleration(&self, w_per_s: f64, travel_m: &[C]) -> Series {
        let of_body = derivative(&derivative(travel_m, w_per_s), w_per_s);
        let orders = of_body.into_iter().enumerate();
        orders
            .map(|(n, c)| c * self.of_table(n.max(1) as f64 * w_per_s))
            .collect()
    }

    /// Exciter with a part of its nonlinearity.
    fn with_share(&self, share: f64) -> Self {
        Self {
            quadratic_n_per_m2: self.quadratic_n_per_m2 * share,
            cubic_n_per_m3: self.cubic_n_per_m3 * share,
            droop_per_m2: self.droop_per_m2 * share,
            friction_n: self.friction_n * share,
            ..*self
        }
    }

    /// Newton's method with a numerical Jacobian; whether it converged.
    fn newton(&self, w_per_s: f64, fundamental_m: f64, unknowns: &mut [f64]) -> bool {
        let residual = |unknowns: &[f64]| self.residual(w_per_s, &travel(fundamental_m, unknowns));
        let mut left = residual(unknowns);
        let mut solver = None;
        for count in 0..STEPS {
            if count % STEPS_PER_JACOBIAN == 0 {
                let step_m = 1e-6 * fundamental_m.abs();
                solver = Some(jacobian(&residual, unknowns, &left, step_m).lu());
            }
            let Some(step) = solver.as_ref().and_then(|solver| solver.solve(&left)) else {
                return false;
            };
            for (unknown, step) in unknowns.iter_mut().zip(step.iter()) {
                *unknown -= step;
            }
            if step.amax() < 1e-8 * fundamental_m.abs() {
                return true;
            }
            left = residual(unknowns);
        }
        false
    }

    /// Coil voltage less what the amplifier gives, but for the fundamental.
    fn residual(&self, w_per_s: f64, travel_m: &[C]) -> DVector<f64> {
        let (coil_v, _) = self.coil(w_per_s, travel_m);
        let given_v = self.amplifier.waveform(coil_v[1]);
        let orders = (2..=HARMONICS).map(|n| coil_v[n] - given_v[n]);
        let parts = orders.flat_map(|z| [z.re, z.im]);
        DVector::from_iterator(UNKNOWNS, [coil_v[0].re].into_iter().chain(parts))
    }

    /// Voltage and current of the coil that make a motion.
    fn coil(&self, w_per_s: f64, travel_m: &[C]) -> (Series, Series) {
        let velocity = derivative(travel_m, w_per_s);
        let (x_m, v_ms) = (values(travel_m), values(&velocity));
        let a_ms2 = values(&self.acceleration(w_per_s, travel_m));
        let spring_n = self.spring_n(w_per_s, travel_m, &x_m);
        let mut force_n: Vec<f64> = (0..INSTANTS)
            .map(|k| self.force_n(x_m[k], v_ms[k], a_ms2[k], spring_n[k]))
            .collect();
        if self.friction_n > 0.0 {
            let mobility = |n: usize| self.mobility_m_per_n(n as f64 * w_per_s);
            let series = friction_force(self.friction_n, travel_m, &v_ms, mobility);
            let friction = values(&series);
            force_n.iter_mut().zip(friction).for_each(|(f, d)| *f += d);
        }
        let force_factor =
            |k: usize| self.force_factor_n_per_a * (1.0 - self.droop_per_m2 * x_m[k] * x_m[k]);
        let current = |k: usize| force_n[k] / force_factor(k);
        let emf = |k: usize| v_ms[k] * force_factor(k) * self.back_emf;
        let coil_a = series(&(0..INSTANTS).map(current).collect::<Vec<_>>());
        let emf_v = series(&(0..INSTANTS).map(emf).collect::<Vec<_>>());
        let voltage = |n: usize| match n {
            0 => coil_a[0] * self.resistance_ohm + emf_v[0],
            _ => coil_a[n] * self.impedance_ohm(n as f64 * w_per_s) + emf_v[n],
        };
        ((0..=HARMONICS).map(voltage).collect(), coil_a)
    }

    /// Force of the straight spring: one that creeps answers each order on its own.
    fn spring_n(&self, w_per_s: f64, travel_m: &[C], x_m: &[f64]) -> Vec<f64> {
        if self.creep.is_none() {
            return x_m.iter().map(|x| self.stiffness_n_per_m * x).collect();
        }
        let orders = travel_m.iter().enumerate();
        let spring = orders.map(|(n, x)| x * self.suspension_n_per_m(n as f64 * w_per_s));
        values(&spring.collect::<Series>())
    }

    /// Force of the coil on what it moves. Weight shifts the rest position; it matters where the
    /// suspension is asymmetric.
    fn force_n(&self, x_m: f64, v_ms: f64, a_ms2: f64, spring_n: f64) -> f64 {
        let weight_n = match self.quadratic_n_per_m2 == 0.0 {
            true => self.sag_share * self.mass_kg * self.gravity_ms2,
            false => self.mass_kg * self.gravity_ms2,
        };
        self.mass_kg * a_ms2
            + self.damping_ns_per_m * v_ms
            + spring_n
            + self.quadratic_n_per_m2 * x_m * x_m
            + self.cubic_n_per_m3 * x_m * x_m * x_m
            + weight_n
    }
}

fn travel(fundamental_m: f64, unknowns: &[f64]) -> Series {
    let mut travel_m = vec![C::from(unknowns[0]), C::from(fundamental_m)];
    let (orders, _) = unknowns[1..].as_chunks::<2>();
    travel_m.extend(orders.iter().map(|[re, im]| C::new(*re, *im)));
    travel_m
}

fn jacobian(
    residual: &impl Fn(&[f64]) -> DVector<f64>,
    unknowns: &[f64],
    at: &DVector<f64>,
    step_m: f64,
) -> DMatrix<f64> {
    let columns: Vec<DVector<f64>> = (0..unknowns.len())
        .map(|n| {
            let mut moved = unknowns.to_vec();
            moved[n] += step_m;
            (residual(&moved) - at) / step_m
        })
        .collect();
    DMatrix::from_columns(&columns)
}
