//! How far the exciter yields to a force at orders of which the coil voltage has nothing.

use super::exciter::Exciter;
use num_complex::Complex64;

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
    /// `Z/((k + j c w - M w^2) Z + j w Bl^2)` at n times `omega`: the coil is closed by what feeds it.
    pub(super) fn new(exciter: &Exciter, omega: f64) -> Self {
        let (mut re, mut im) = ([0.0; COUNT], [0.0; COUNT]);
        let impedance: [Complex64; COUNT] =
            std::array::from_fn(|at| exciter.impedance(omega * order(at) as f64));
        let coupling = exciter.force_factor_n_per_a.powi(2) * exciter.emf_ratio;
        for at in 0..COUNT {
            let w = omega * order(at) as f64;
            let (spring, drag) = (
                exciter.stiffness_n_per_m - exciter.mass_kg * w * w,
                exciter.damping_ns_per_m * w,
            );
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
    use super::*;

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
