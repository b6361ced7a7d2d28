//! Fourier series of one period, and the same at equidistant instants.

use num_complex::Complex64 as C;
use std::f64::consts::TAU;
use std::sync::LazyLock;

/// Instants of a period.
pub(super) const INSTANTS: usize = 96;
/// Highest order kept, below the Nyquist order of the instants.
pub(super) const HARMONICS: usize = 30;

/// Complex peak amplitudes of orders 0..=[`HARMONICS`].
pub(super) type Series = Vec<C>;

/// Turn of each order at each instant.
static TURNS: LazyLock<[[C; INSTANTS]; HARMONICS + 1]> = LazyLock::new(|| {
    let turn = |k: usize| C::from_polar(1.0, TAU * k as f64 / INSTANTS as f64);
    let first: [C; INSTANTS] = std::array::from_fn(turn);
    std::array::from_fn(|n| std::array::from_fn(|k| first[(n * k) % INSTANTS]))
});

/// The values at the instants.
pub(super) fn values(series: &[C]) -> Vec<f64> {
    let mut values = vec![0.0; INSTANTS];
    for (c, turns) in series.iter().zip(TURNS.iter()) {
        for (value, turn) in values.iter_mut().zip(turns) {
            *value += c.re * turn.re - c.im * turn.im;
        }
    }
    values
}

/// The series of values at the instants.
pub(super) fn series(values: &[f64]) -> Series {
    let order = |(n, turns): (usize, &[C; INSTANTS])| -> C {
        let sum: C = turns
            .iter()
            .zip(values)
            .map(|(turn, v)| turn.conj() * *v)
            .sum();
        sum * (if n == 0 { 1.0 } else { 2.0 } / INSTANTS as f64)
    };
    TURNS.iter().enumerate().map(order).collect()
}

/// The derivative with respect to time.
pub(super) fn derivative(series: &[C], w_per_s: f64) -> Series {
    let terms = series.iter().enumerate();
    terms
        .map(|(n, c)| c * C::new(0.0, n as f64 * w_per_s))
        .collect()
}
