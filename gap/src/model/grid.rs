//! A period of the motion as harmonics, and as values on a grid of time.

use num_complex::Complex64;
use std::array::from_fn;
use std::f64::consts::TAU;
use std::sync::LazyLock;

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

/// Points of the first quarter of the grid, both ends included.
const QUARTER: usize = GRID / 4 + 1;
/// Orders that are even, and as many that are odd.
const HALF: usize = ORDERS.div_ceil(2);
/// Points whose sums stay in registers, and how many times so many are a quarter.
const CHUNK: usize = 6;
const CHUNKS: usize = QUARTER.div_ceil(CHUNK);

/// Cosines or sines of the even or of the odd orders on the first quarter of the grid: the other
/// quarters mirror it, with signs that depend on whether the order is even.
struct Table {
    /// By point, then order: an analysis sums over points.
    by_point: [[f64; HALF]; QUARTER],
    /// By chunk of points, then order: a synthesis sums over orders.
    by_order: [[[f64; CHUNK]; HALF]; CHUNKS],
}

impl Table {
    fn new(odd: usize, function: fn(f64) -> f64) -> Self {
        let at = |half: usize, i: usize| {
            let turns = ((2 * half + odd) * i) % GRID;
            function(TAU * turns as f64 / GRID as f64)
        };
        let chunk = |c: usize, half: usize| from_fn(|i| at(half, c * CHUNK + i));
        Self {
            by_point: from_fn(|i| from_fn(|half| at(half, i))),
            by_order: from_fn(|c| from_fn(|half| chunk(c, half))),
        }
    }

    /// Sum over the orders at each point of the quarter.
    #[inline]
    fn synthesized(&self, orders: &[f64; HALF]) -> [[f64; CHUNK]; CHUNKS] {
        let mut points = [[0.0; CHUNK]; CHUNKS];
        for (sums, table) in points.iter_mut().zip(&self.by_order) {
            // By itself, so that it stays in registers.
            let mut chunk = [0.0; CHUNK];
            for (order, values) in orders.iter().zip(table) {
                for i in 0..CHUNK {
                    chunk[i] += order * values[i];
                }
            }
            *sums = chunk;
        }
        points
    }

    /// Sum over the points for each order.
    #[inline]
    fn analysed(&self, points: &[f64; QUARTER]) -> [f64; HALF] {
        let mut sums = [0.0; HALF];
        for (point, values) in points.iter().zip(&self.by_point) {
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += point * value;
            }
        }
        sums
    }
}

/// Cosines and sines, of the even and of the odd orders.
static TABLES: LazyLock<[[Table; 2]; 2]> =
    LazyLock::new(|| from_fn(|odd| [Table::new(odd, f64::cos), Table::new(odd, f64::sin)]));

/// Values on the grid of a sum of harmonics.
pub(super) fn synthesize(orders: &Wave) -> [f64; GRID] {
    // Cosine and sine part of the even and of the odd orders.
    let mut part = [[[[0.0; CHUNK]; CHUNKS]; 2]; 2];
    for (odd, [cosine, sine]) in TABLES.iter().enumerate() {
        let half: [Complex64; HALF] = from_fn(|k| orders[2 * k + odd]);
        if half != [Complex64::ZERO; HALF] {
            let (re, im) = (from_fn(|k| half[k].re), from_fn(|k| -half[k].im));
            part[odd] = [cosine.synthesized(&re), sine.synthesized(&im)];
        }
    }
    let [even_c, even_s] = part[0].each_ref().map(|p| p.as_flattened());
    let [odd_c, odd_s] = part[1].each_ref().map(|p| p.as_flattened());
    let mut out = [0.0; GRID];
    for i in 0..QUARTER {
        out[i] = even_c[i] + even_s[i] + odd_c[i] + odd_s[i];
        out[GRID / 2 - i] = even_c[i] - even_s[i] - odd_c[i] + odd_s[i];
        out[GRID / 2 + i] = even_c[i] + even_s[i] - odd_c[i] - odd_s[i];
        out[(GRID - i) % GRID] = even_c[i] - even_s[i] + odd_c[i] - odd_s[i];
    }
    out
}

/// Harmonics of the values on the grid.
pub(super) fn analyse(signal: &[f64; GRID], parity: Parity) -> Wave {
    // Values of the four quarters by how cosine and sine of the even and of the odd orders mirror them.
    let mut folded = [[[0.0; QUARTER]; 2]; 2];
    for i in 0..QUARTER {
        // The ends of the quarter belong to two of the four points each.
        let share = if i == 0 || i == GRID / 4 { 1.0 } else { 2.0 } / GRID as f64;
        let [a, b] = [signal[i], signal[GRID / 2 - i]];
        let [c, d] = [signal[GRID / 2 + i], signal[(GRID - i) % GRID]];
        folded[0][0][i] = share * (a + b + c + d);
        folded[0][1][i] = share * (a - b + c - d);
        folded[1][0][i] = share * (a - b - c + d);
        folded[1][1][i] = share * (a + b - c - d);
    }
    let mut orders = [Complex64::ZERO; ORDERS + 1];
    for odd in usize::from(parity == Parity::Odd)..2 {
        let ([cosine, sine], [even, uneven]) = (&TABLES[odd], &folded[odd]);
        let parts = cosine.analysed(even).into_iter().zip(sine.analysed(uneven));
        for (k, (re, im)) in parts.enumerate() {
            orders[2 * k + odd] = Complex64::new(re, -im);
        }
    }
    // The mean is summed without the factor of two that the other orders have.
    orders[0] *= 0.5;
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
