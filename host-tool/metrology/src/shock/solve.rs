//! Weighted least squares on the ratio of the spectra.
//!
//! The vector v of (23) and the coefficients mu of a polynomial in
//! `s_n = i K tan(w_n T / 2)` describe the same discrete model:
//! v1 = mu1 + K mu2 + K^2 mu3, v2 = 2 mu1 - 2 K^2 mu3,
//! v3 = mu1 - K mu2 + K^2 mu3. The fit uses mu, because at high sample rates
//! the columns of (25) are almost equal and lose half of the digits.

use crate::discrete::Mapping;
use crate::oscillator::Oscillator;
use nalgebra::{Complex, Matrix2x3, Matrix3, Vector2, Vector3};
use std::f64::consts::{PI, TAU};

/// mu, its covariance for u0 = 1, and the weighted sum of squares for u0 = 1.
///
/// With (27), dividing the residual of G = A/X by u(G) = u0/|X| leaves
/// |A - X (mu1 + mu2 s + mu3 s^2)|^2 / u0^2.
pub(super) fn solve(
    a: &[Complex<f64>],
    x: &[Complex<f64>],
    bins: &[usize],
    sample_rate_hz: f64,
) -> Option<(Vector3<f64>, Matrix3<f64>, f64)> {
    let s = |n: usize| 2.0 * sample_rate_hz * (PI * n as f64 / a.len() as f64).tan();
    let scale = bins.iter().map(|&n| s(n)).sum::<f64>() / bins.len() as f64;
    let rows: Vec<(Matrix2x3<f64>, Vector2<f64>)> = bins
        .iter()
        .map(|&n| {
            let w = s(n) / scale;
            let columns = [x[n], x[n] * Complex::new(0.0, w), x[n] * -(w * w)];
            (
                Matrix2x3::from_fn(|row, column| match row {
                    0 => columns[column].re,
                    _ => columns[column].im,
                }),
                Vector2::new(a[n].re, a[n].im),
            )
        })
        .collect();
    let normal: Matrix3<f64> = rows.iter().map(|(d, _)| d.transpose() * d).sum();
    let right: Vector3<f64> = rows.iter().map(|(d, y)| d.transpose() * y).sum();
    let inverse = normal.try_inverse()?;
    let scaled = inverse * right;
    let squares = rows
        .iter()
        .map(|(d, y)| (y - d * scaled).norm_squared())
        .sum();
    let unit = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0 / scale, 1.0 / (scale * scale)));
    Some((unit * scaled, unit * inverse * unit, squares))
}

/// Continuous-time parameters of mu found with K = 2/T. Pre-warping maps the
/// same filter to another resonance: `w0 = (2/T) atan(w0' T/2)`.
pub(super) fn continuous(
    mu: &Vector3<f64>,
    sample_rate_hz: f64,
    mapping: Mapping,
) -> Option<Oscillator> {
    let plain = Oscillator::from_inverse(mu)?;
    let f0_hz = match mapping {
        Mapping::Bilinear => plain.f0_hz,
        Mapping::BilinearPrewarped => {
            let half = TAU * plain.f0_hz / (2.0 * sample_rate_hz);
            2.0 * sample_rate_hz * half.atan() / TAU
        }
    };
    Some(Oscillator { f0_hz, ..plain })
}

/// Standard uncertainties of all parameters and the correlation of the first
/// three, to first order with central differences.
pub(super) fn spread(
    mu: &Vector3<f64>,
    covariance: &Matrix3<f64>,
    all: impl Fn(&Vector3<f64>) -> [f64; 6],
) -> ([f64; 6], [[f64; 3]; 3]) {
    let mut gradient = [[0.0; 3]; 6];
    for column in 0..3 {
        let step = (0.01 * covariance[(column, column)].sqrt()).max(1e-9 * mu[column].abs());
        let (mut above, mut below) = (*mu, *mu);
        above[column] += step;
        below[column] -= step;
        for (row, (high, low)) in gradient.iter_mut().zip(all(&above).iter().zip(all(&below))) {
            row[column] = (high - low) / (2.0 * step);
        }
    }
    let g = |row: usize| Vector3::from(gradient[row]);
    let covariance_of = |a: usize, b: usize| g(a).dot(&(covariance * g(b)));
    let u: [f64; 6] = std::array::from_fn(|row| covariance_of(row, row).max(0.0).sqrt());
    let correlation =
        std::array::from_fn(|a| std::array::from_fn(|b| covariance_of(a, b) / (u[a] * u[b])));
    (u, correlation)
}
