//! A wave of many orders through a bent or cut characteristic.
//!
//! The nonlinearity of a channel acts on the wave that arrives, with the harmonics it
//! has already. A cut is integrated in closed form between the places where
//! the wave crosses the threshold; a polynomial is exact on the grid.

use super::grid::{GRID, ORDERS, Parity, Wave, analyse, mean_square, synthesize, value};
use super::waveform::Characteristic;
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// Wave behind a characteristic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Shaped {
    pub(crate) wave: Wave,
    /// Mean square of the orders above those of a wave.
    pub(crate) beyond: f64,
}

impl Characteristic {
    /// Fundamental behind the characteristic, and its derivative by the logarithm of a factor on the wave.
    pub(crate) fn fundamental_behind(self, wave: &Wave) -> [Complex64; 2] {
        let less = |cut: [Complex64; 2]| cut.map(|cut| wave[1] - cut);
        match self {
            Self::Polynomial { second, third } => pointwise_fundamental(wave, |v| {
                let (second, third) = (second * v * v, third * v * v * v);
                [v + second + third, v + 2.0 * second + 3.0 * third]
            }),
            Self::Soft { threshold } => pointwise_fundamental(wave, |v| {
                let y = (v / threshold).tanh();
                [threshold * y, v * (1.0 - y * y)]
            }),
            Self::DeadZone { threshold } => both_fundamentals(wave, threshold),
            Self::Clip { threshold } => less(both_fundamentals(wave, threshold)),
            Self::OneSided { threshold, upper } => less(fundamental_beyond(
                wave,
                threshold,
                if upper { 1.0 } else { -1.0 },
            )),
        }
    }

    /// The wave behind the characteristic.
    pub(crate) fn shape(self, wave: &Wave) -> Shaped {
        match self {
            // 45 orders of the cube fold back onto orders above 18 only.
            Self::Polynomial { second, third } => {
                pointwise(wave, |v| v + (second + third * v) * v * v)
            }
            Self::Soft { threshold } => pointwise(wave, |v| threshold * (v / threshold).tanh()),
            Self::DeadZone { threshold } => {
                let beyond = both_sides(wave, threshold);
                Shaped {
                    wave: beyond.wave,
                    beyond: beyond.left_out(),
                }
            }
            Self::Clip { threshold } => both_sides(wave, threshold).taken_from(wave),
            Self::OneSided { threshold, upper } => {
                Excess::new(wave, threshold, if upper { 1.0 } else { -1.0 }).taken_from(wave)
            }
        }
    }
}

/// A smooth characteristic, on the grid of time.
fn pointwise(wave: &Wave, characteristic: impl Fn(f64) -> f64) -> Shaped {
    let mut signal = synthesize(wave);
    for v in &mut signal {
        *v = characteristic(*v);
    }
    Shaped {
        wave: analyse(&signal, Parity::All),
        beyond: 0.0,
    }
}

/// Fundamentals of two functions of a wave, on the grid of time.
fn pointwise_fundamental(wave: &Wave, both: impl Fn(f64) -> [f64; 2]) -> [Complex64; 2] {
    let values = synthesize(wave).map(both);
    [0, 1].map(|of| analyse(&values.map(|v| v[of]), Parity::Odd)[1])
}

/// Part of a wave beyond a threshold, and its whole mean square.
struct Excess {
    wave: Wave,
    mean_square: f64,
}

fn both_sides(wave: &Wave, threshold: f64) -> Excess {
    let (above, below) = (
        Excess::new(wave, threshold, 1.0),
        Excess::new(wave, threshold, -1.0),
    );
    Excess {
        wave: std::array::from_fn(|n| above.wave[n] + below.wave[n]),
        // The two are never there at one time.
        mean_square: above.mean_square + below.mean_square,
    }
}

impl Excess {
    /// sign max(sign v - threshold, 0).
    fn new(wave: &Wave, threshold: f64, sign: f64) -> Self {
        let over = over(wave, threshold, sign);
        let parts = positive(&over);
        if parts.is_empty() {
            return Self {
                wave: [Complex64::ZERO; ORDERS + 1],
                mean_square: 0.0,
            };
        }
        let turning = turning::<{ 2 * ORDERS + 1 }>(&parts);
        let excess: Wave = std::array::from_fn(|n| order(&over, &turning, n));
        // Where it is not zero it is the wave less the threshold.
        let products = over[1..].iter().zip(&excess[1..]);
        let alternating: f64 = products.map(|(a, b)| (a.conj() * b).re).sum();
        Self {
            mean_square: over[0].re * excess[0].re + 0.5 * alternating,
            wave: excess.map(|c| c * sign),
        }
    }

    fn left_out(&self) -> f64 {
        (self.mean_square - mean_square(&self.wave)).max(0.0)
    }

    fn taken_from(&self, wave: &Wave) -> Shaped {
        Shaped {
            wave: std::array::from_fn(|n| wave[n] - self.wave[n]),
            beyond: self.left_out(),
        }
    }
}

/// A wave less a threshold; with the sign -1 the other side of it.
fn over(wave: &Wave, threshold: f64, sign: f64) -> Wave {
    let mut over = wave.map(|c| c * sign);
    over[0] = Complex64::from(over[0].re - threshold);
    over
}

fn both_fundamentals(wave: &Wave, threshold: f64) -> [Complex64; 2] {
    let [above, below] = [1.0, -1.0].map(|sign| fundamental_beyond(wave, threshold, sign));
    [above[0] + below[0], above[1] + below[1]]
}

/// Fundamental of the part of a wave beyond a threshold, and its derivative by the logarithm of a factor on the wave.
///
/// The ends of the parts move with the factor, but nothing is beyond the threshold there.
fn fundamental_beyond(wave: &Wave, threshold: f64, sign: f64) -> [Complex64; 2] {
    let over = over(wave, threshold, sign);
    let turning = turning::<{ ORDERS + 2 }>(&positive(&over));
    let beyond = order(&over, &turning, 1);
    [beyond, beyond + turning[1].conj() * (threshold / PI)].map(|c| c * sign)
}

/// Integrals over all parts of a period of e^(j k t), for k from zero.
fn turning<const POWERS: usize>(parts: &[(f64, f64)]) -> [Complex64; POWERS] {
    let mut of_power = [Complex64::ZERO; POWERS];
    for &(from, to) in parts {
        of_power[0] += to - from;
        let [first, last] = [from, to].map(|t| Complex64::from_polar(1.0, t));
        let (mut a, mut b) = (first, last);
        for (k, sum) in of_power.iter_mut().enumerate().skip(1) {
            *sum += (b - a) / Complex64::new(0.0, k as f64);
            (a, b) = (a * first, b * last);
        }
    }
    of_power
}

/// An order of a wave that is itself on some parts of its period and zero elsewhere.
///
/// # Equation
/// R_n = (1/pi) Integral w e^(-j n t) dt, w = (1/2) Sum (c_m e^(j m t) + conj(c_m) e^(-j m t)).
fn order(wave: &Wave, turning: &[Complex64], n: usize) -> Complex64 {
    let mut sum = Complex64::ZERO;
    let orders = wave.iter().enumerate();
    for (m, c) in orders.filter(|(_, c)| **c != Complex64::ZERO) {
        let turned = if m >= n {
            turning[m - n]
        } else {
            turning[n - m].conj()
        };
        sum += c * turned + c.conj() * turning[m + n].conj();
    }
    let halved = if n == 0 { 0.25 } else { 0.5 };
    sum * (halved / PI)
}

/// Parts of the period, from and to in rad, where a wave is positive.
fn positive(wave: &Wave) -> Vec<(f64, f64)> {
    let crossings = crossings(wave);
    let Some(&(_, rises)) = crossings.first() else {
        let always = value(wave, 0.0).0 > 0.0;
        return if always { vec![(0.0, TAU)] } else { Vec::new() };
    };
    let mut parts = Vec::with_capacity(crossings.len() / 2 + 1);
    let mut from = (!rises).then_some(0.0);
    for &(at, rises) in &crossings {
        match (rises, from.take()) {
            (true, _) => from = Some(at),
            (false, Some(from)) => parts.push((from, at)),
            (false, None) => {}
        }
    }
    if let Some(from) = from {
        parts.push((from, TAU));
    }
    parts
}

/// Where a wave changes its sign, in order, and whether it rises there.
fn crossings(wave: &Wave) -> Vec<(f64, bool)> {
    let signal = synthesize(wave);
    let step = TAU / GRID as f64;
    let mut found = Vec::new();
    let at = |i: usize| i as f64 * step;
    for i in 0..GRID {
        let (here, next) = (signal[i], signal[(i + 1) % GRID]);
        if (here > 0.0) != (next > 0.0) {
            found.push((root(wave, (at(i), here), (at(i + 1), next)), next > 0.0));
        } else if let Some(turn) = turn_between(&signal, i) {
            // It may touch the other side between two points and come back.
            let top = extremum(wave, at(i) + turn * step);
            let beyond = value(wave, top).0;
            if (beyond > 0.0) != (here > 0.0) && top > at(i) && top < at(i + 1) {
                let there = (top, beyond);
                found.push((root(wave, (at(i), here), there), beyond > 0.0));
                found.push((root(wave, there, (at(i + 1), next)), here > 0.0));
            }
        }
    }
    found
}

/// Where a wave turns towards zero in an interval of the grid, as a share of it, if it could get there.
fn turn_between(signal: &[f64; GRID], i: usize) -> Option<f64> {
    let [before, here, next, after] = [GRID - 1, 0, 1, 2].map(|k| signal[(i + k) % GRID]);
    let (left, right) = (here - before, after - next);
    let towards = -here.signum();
    // Slopes at both ends from the neighbours: towards zero first, away from it last.
    let slopes = [left + (next - here), right + (next - here)].map(|s| 0.5 * towards * s);
    if slopes[0] <= 0.0 || slopes[1] >= 0.0 {
        return None;
    }
    let share = slopes[0] / (slopes[0] - slopes[1]);
    let reach = here.abs() - slopes[0] * share;
    (reach < 0.5 * here.abs()).then_some(share)
}

/// Zero between two places where the signs differ: Newton's steps, halving where they leave the bracket.
fn root(wave: &Wave, low: (f64, f64), high: (f64, f64)) -> f64 {
    let (mut from, mut to) = (low.0, high.0);
    let mut t = from + (to - from) * low.1 / (low.1 - high.1);
    for _ in 0..30 {
        let (v, slope) = value(wave, t);
        if (v > 0.0) == (low.1 > 0.0) {
            from = t;
        } else {
            to = t;
        }
        let next = t - v / slope;
        if next > from && next < to {
            // Newton's step leaves about the square of its size.
            if (next - t).abs() < 1e-7 {
                return next;
            }
            t = next;
        } else {
            t = 0.5 * (from + to);
        }
    }
    t
}

/// Place of an extremum near a place.
fn extremum(wave: &Wave, near: f64) -> f64 {
    const STEP: f64 = 1e-3;
    let mut t = near;
    for _ in 0..4 {
        let [left, here, right] = [-STEP, 0.0, STEP].map(|d| value(wave, t + d).1);
        t -= (here * 2.0 * STEP / (right - left)).clamp(-0.05, 0.05);
    }
    t
}

#[cfg(test)]
mod tests {
    use super::super::grid::value;
    use super::*;
    use std::f64::consts::TAU;

    const CASES: [Characteristic; 6] = [
        Characteristic::Soft { threshold: 2.0 },
        Characteristic::DeadZone { threshold: 0.2 },
        Characteristic::Clip { threshold: 1.1 },
        Characteristic::OneSided {
            threshold: 0.9,
            upper: false,
        },
        Characteristic::OneSided {
            threshold: 0.9,
            upper: true,
        },
        Characteristic::Polynomial {
            second: 0.02,
            third: -0.03,
        },
    ];

    fn function(characteristic: Characteristic, v: f64) -> f64 {
        match characteristic {
            Characteristic::DeadZone { threshold } => v - v.clamp(-threshold, threshold),
            Characteristic::Clip { threshold } => v.clamp(-threshold, threshold),
            Characteristic::Soft { threshold } => threshold * (v / threshold).tanh(),
            Characteristic::OneSided {
                threshold,
                upper: true,
            } => v.min(threshold),
            Characteristic::OneSided { threshold, .. } => v.max(-threshold),
            Characteristic::Polynomial { second, third } => v + second * v * v + third * v * v * v,
        }
    }

    /// The closed forms for a cosine are another calculation: rounding only, and what the partial fractions of
    /// a hyperbolic tangent leave out.
    #[test]
    fn a_cosine_is_shaped_as_its_closed_form_says() {
        let mut wave = [Complex64::ZERO; ORDERS + 1];
        wave[1] = Complex64::from(1.7);
        for characteristic in CASES {
            let (shaped, closed) = (characteristic.shape(&wave), characteristic.spectrum(1.7));
            let most = match characteristic {
                Characteristic::Soft { threshold } => 1e-7 * threshold,
                _ => 1e-12,
            };
            for (n, order) in closed.order.iter().enumerate() {
                let found = shaped.wave[n];
                assert!(
                    (found - order).norm() < most,
                    "{characteristic:?} {n} {found}"
                );
            }
            let above: f64 = shaped.wave[6..].iter().map(|c| 0.5 * c.norm_sqr()).sum();
            let remainder = above + shaped.beyond;
            let error = remainder - closed.remainder_mean_square;
            assert!(error.abs() < most, "{characteristic:?} {error:e}");
        }
    }

    /// Orders by summation over 20 000 points: (pi/N)^2 = 2.5e-8 for a kinked function.
    #[test]
    fn a_bent_wave_is_shaped_as_its_samples_say() {
        const N: usize = 20_000;
        // Phases and sizes of a clipped drive behind an asymmetric suspension, and a flat top that
        // just reaches the threshold between two points of the grid.
        let mut bent = [Complex64::ZERO; ORDERS + 1];
        bent[1] = Complex64::from_polar(1.4, 0.3);
        for (n, c) in bent.iter_mut().enumerate().skip(2) {
            *c = Complex64::from_polar(0.5 / (n * n) as f64, n as f64);
        }
        let mut flat = [Complex64::ZERO; ORDERS + 1];
        flat[1] = Complex64::from_polar(1.1005, 0.05);
        for (wave, characteristic) in CASES.iter().flat_map(|c| [(bent, *c), (flat, *c)]) {
            let angle = |i: usize| TAU * (i as f64 + 0.5) / N as f64;
            let samples: Vec<f64> = (0..N)
                .map(|i| function(characteristic, value(&wave, angle(i)).0))
                .collect();
            let shaped = characteristic.shape(&wave);
            for (n, found) in shaped.wave.iter().enumerate() {
                let terms = samples.iter().enumerate();
                let sum: Complex64 = terms
                    .map(|(i, v)| Complex64::from_polar(*v, -(n as f64) * angle(i)))
                    .sum();
                let expected = sum * if n == 0 { 1.0 } else { 2.0 } / N as f64;
                assert!(
                    (found - expected).norm() < 1e-7,
                    "{characteristic:?} {n}: {found} {expected}"
                );
            }
            let [fundamental, growth] = characteristic.fundamental_behind(&wave);
            assert!((fundamental - shaped.wave[1]).norm() < 1e-12);
            let scaled = |by: f64| characteristic.shape(&wave.map(|c| c * by)).wave[1];
            let expected = (scaled(1.0 + 1e-5) - scaled(1.0 - 1e-5)) / 2e-5;
            // The second derivative jumps where a flat top reaches the threshold.
            let error = (growth - expected).norm();
            assert!(error < 3e-4, "{characteristic:?} growth {error:e}");
            let square = samples.iter().map(|v| v * v).sum::<f64>() / N as f64;
            let error = mean_square(&shaped.wave) + shaped.beyond - square;
            // Of a smooth bend the orders above those of a wave are left out.
            let left_out = match characteristic {
                Characteristic::Polynomial { .. } | Characteristic::Soft { .. } => 1e-5,
                _ => 1e-7,
            };
            assert!(error.abs() < left_out, "{characteristic:?} {error:e}");
        }
    }
}
