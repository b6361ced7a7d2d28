//! Fourier coefficients of a cosine through a hyperbolic tangent.
//!
//! # Equation
//! `tanh x = Sum 2x/(x^2 + b^2)` over `b = pi/2, 3 pi/2, ...`. Of `x = a cos t` each term is a geometric
//! series: with `S = sqrt(a^2 + b^2)` and `r = a/(S + b)` its odd order n is `+-4 r^n/S`, which is also
//! `-+(4/n) d(r^n)/db`. So what the sum leaves out is an integral in closed form, by the rule of midpoints.

use super::grid::ORDERS;
use std::f64::consts::PI;

/// Terms that are summed; what the rest errs by is below 1e-7 of the fundamental.
const TERMS: u32 = 16;
/// Largest input, in thresholds: the output is a square wave to 1e-3 there.
const LARGEST: f64 = 50.0;

/// Orders up to [`ORDERS`] of `tanh(a cos t)`; the even ones are zero.
pub(super) fn saturated(a: f64) -> [f64; ORDERS + 1] {
    let mut orders = [0.0; ORDERS + 1];
    let mut add = |b: f64, of: &dyn Fn(f64, f64, f64) -> f64| {
        let (s, r) = of_term(a, b);
        let mut power = r;
        for n in (1..=ORDERS).step_by(2) {
            orders[n] += power * of(n as f64, s, b);
            power *= -r * r;
        }
    };
    for k in 0..TERMS {
        add((f64::from(k) + 0.5) * PI, &|_, s, _| 4.0 / s);
    }
    add(f64::from(TERMS) * PI, &rest);
    orders
}

/// Orders of the saturated cosine that has the given fundamental, in thresholds; an output larger than any
/// is that of the largest input.
pub(super) fn saturated_from(fundamental: f64) -> [f64; ORDERS + 1] {
    saturated(unsaturated(fundamental))
}

/// `S` and `r` of a term.
fn of_term(a: f64, b: f64) -> (f64, f64) {
    let s = (a * a + b * b).sqrt();
    (s, a / (s + b))
}

/// The cosine that has the given fundamental once it is saturated, at most the largest input.
pub(super) fn unsaturated(fundamental: f64) -> f64 {
    // As if it saturated with the root of a sum of squares; nothing has a fundamental above 4/pi.
    let share = fundamental * PI / 4.0;
    let mut input = (fundamental / (1.0 - share * share).max(0.0).sqrt()).min(LARGEST);
    // The fundamental is concave in the input: after the first, Newton's steps come from below.
    for _ in 0..40 {
        let [found, slope] = saturated_fundamental(input);
        let missing = fundamental - found;
        if missing.abs() < 1e-13 * fundamental || input > LARGEST {
            break;
        }
        input += missing / slope;
    }
    input.min(LARGEST)
}

/// The fundamental of `tanh(a cos t)`, and its derivative by a.
pub(super) fn saturated_fundamental(a: f64) -> [f64; 2] {
    // Of r.
    let slope = |s: f64, b: f64| b / (s * (s + b));
    let (mut value, mut derivative) = (0.0, 0.0);
    for k in 0..TERMS {
        let b = (f64::from(k) + 0.5) * PI;
        let (s, r) = of_term(a, b);
        value += r * (4.0 / s);
        derivative += 4.0 / s * (slope(s, b) - r * a / (s * s));
    }
    let b = f64::from(TERMS) * PI;
    let (s, r) = of_term(a, b);
    value += r * rest(1.0, s, b);
    let left_out = PI / 6.0 * a * (2.0 + 3.0 * b / s) / (s * s * s * s);
    derivative += slope(s, b) * rest(1.0, s, b) + r * left_out;
    [value, derivative]
}

/// Remainder that the sum leaves of an order, over `r^n`.
fn rest(n: f64, s: f64, b: f64) -> f64 {
    4.0 / (n * PI) - PI / 6.0 * (n / (s * s) + b / (s * s * s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// The sum over so many points is exact but for orders above 4000.
    fn by_sampling(a: f64, n: usize) -> f64 {
        const POINTS: usize = 4096;
        let term = |i: usize| {
            let t = TAU * i as f64 / POINTS as f64;
            (a * t.cos()).tanh() * (n as f64 * t).cos()
        };
        (0..POINTS).map(term).sum::<f64>() * 2.0 / POINTS as f64
    }

    #[test]
    fn orders_are_those_of_the_samples() {
        for a in [0.01, 0.3, 1.0, 4.0, 20.0] {
            for (n, order) in saturated(a).into_iter().enumerate().skip(1) {
                let error = order - by_sampling(a, n);
                assert!(error.abs() < 1e-7 * a.min(1.0), "{a} {n}: {error:e}");
            }
        }
    }

    #[test]
    fn the_input_is_found_from_its_fundamental() {
        for a in [0.05, 0.9, 5.0] {
            let orders = saturated(a);
            let [fundamental, slope] = saturated_fundamental(a);
            assert!((fundamental - orders[1]).abs() < 1e-14, "{a}");
            let step = 1e-4 * a;
            let [more, less] = [a + step, a - step].map(|a| saturated(a)[1]);
            assert!(
                (slope * 2.0 * step / (more - less) - 1.0).abs() < 1e-6,
                "{a}"
            );
            for (n, order) in saturated_from(orders[1]).into_iter().enumerate() {
                assert!((order - orders[n]).abs() < 1e-11, "{a} {n}");
            }
        }
        // Nothing has a fundamental above 4/pi.
        assert!(saturated_from(1.4)[3].is_finite());
    }
}
