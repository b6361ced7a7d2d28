//! A wave of many orders.

use super::grid::ORDERS;
use num_complex::Complex64;

/// Orders of a wave, the sum of Re(c_n e^(j n t)); order 0 is the mean.
pub(crate) type Wave = [Complex64; ORDERS + 1];

/// The mean of the square of a wave.
pub(crate) fn mean_square(wave: &Wave) -> f64 {
    let alternating: f64 = wave[1..].iter().map(|c| c.norm_sqr()).sum();
    wave[0].re * wave[0].re + 0.5 * alternating
}

/// Value and slope of a wave at a phase `t` in rad.
pub(super) fn value(wave: &Wave, t: f64) -> (f64, f64) {
    let turn = Complex64::from_polar(1.0, t);
    let (mut power, mut sum) = (turn, (wave[0].re, 0.0));
    for (n, c) in wave.iter().enumerate().skip(1) {
        let there = c * power;
        sum.0 += there.re;
        sum.1 -= n as f64 * there.im;
        power *= turn;
    }
    sum
}
