//! Fourier series of one period, and the same at equidistant instants.

use num_complex::Complex64 as C;
use std::f64::consts::TAU;
use std::sync::OnceLock;

/// Instants of a period.
pub(super) const INSTANTS: usize = 96;
/// Highest order kept, below the Nyquist order of the instants.
pub(super) const HARMONICS: usize = 30;

/// Complex peak amplitudes of orders 0..=[`HARMONICS`].
pub(super) type Series = Vec<C>;

/// The values at the instants.
pub(super) fn values(series: &[C]) -> Vec<f64> {
    let turn = turns();
    let value = |k: usize| -> f64 {
        let term = |(n, c): (usize, &C)| {
            let turn = turn[(n * k) % INSTANTS];
            c.re * turn.re - c.im * turn.im
        };
        series.iter().enumerate().map(term).sum()
    };
    (0..INSTANTS).map(value).collect()
}

/// The series of values at the instants.
pub(super) fn series(values: &[f64]) -> Series {
    let turn = turns();
    let order = |n: usize| -> C {
        let terms = values.iter().enumerate();
        let sum: C = terms
            .map(|(k, v)| turn[(n * k) % INSTANTS].conj() * *v)
            .sum();
        sum * (if n == 0 { 1.0 } else { 2.0 } / INSTANTS as f64)
    };
    (0..=HARMONICS).map(order).collect()
}

/// The derivative with respect to time.
pub(super) fn derivative(series: &[C], w_per_s: f64) -> Series {
    let terms = series.iter().enumerate();
    terms
        .map(|(n, c)| c * C::new(0.0, n as f64 * w_per_s))
        .collect()
}

fn turns() -> &'static [C; INSTANTS] {
    static TURNS: OnceLock<[C; INSTANTS]> = OnceLock::new();
    let turn = |k: usize| C::from_polar(1.0, TAU * k as f64 / INSTANTS as f64);
    TURNS.get_or_init(|| std::array::from_fn(turn))
}
