//! A period of the motion as harmonics, and as values on a grid of time.

use crate::estimation::column::dot;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Highest harmonic of the balance.
pub(crate) const ORDERS: usize = 15;
/// Points of the time grid; a cubic force of 15 orders folds back onto orders above 18 only.
pub(super) const GRID: usize = 64;

/// Orders of a wave, the sum of Re(c_n e^(j n t)); order 0 is the mean, of a displacement its rest position.
pub(crate) type Wave = [Complex64; ORDERS + 1];

/// Orders that can arise: forces that are odd in the motion make odd orders only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Parity {
    All,
    Odd,
}

impl Parity {
    pub(super) fn orders(self) -> std::iter::StepBy<std::ops::RangeInclusive<usize>> {
        match self {
            Self::All => (0..=ORDERS).step_by(1),
            Self::Odd => (1..=ORDERS).step_by(2),
        }
    }
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

/// Values on the grid of a sum of harmonics.
pub(super) fn synthesize(orders: &Wave) -> [f64; GRID] {
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
pub(super) fn analyse(signal: &[f64; GRID], parity: Parity) -> Wave {
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

/// Logarithm without the care for overflow that the library's takes: no value here is near it.
pub(super) fn ln(value: Complex64) -> Complex64 {
    if value == Complex64::ONE {
        return Complex64::ZERO;
    }
    Complex64::new(0.5 * value.norm_sqr().ln(), value.im.atan2(value.re))
}

/// Size of a value, likewise.
pub(super) fn size(value: Complex64) -> f64 {
    value.norm_sqr().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every order comes back, and its values are those of cosine and sine: rounding of 64 terms only.
    #[test]
    fn a_sum_of_harmonics_is_analysed_into_the_same_harmonics() {
        let mut motion: Wave =
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
}
