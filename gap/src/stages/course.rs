//! Free courses of a deviation over frequency.

use crate::engine::problem::Problem;

/// Most bands of a course with a sharp feature.
const MOST_BANDS: usize = 26;

/// A course over frequency: one function of the frequency for each free amount.
pub(super) type Course = Vec<Box<dyn Fn(f64) -> f64>>;

/// Chebyshev polynomials of the logarithm of frequency.
pub(super) fn smooth(problem: &Problem, order: usize) -> Course {
    let facts = &problem.facts;
    let (low, high) = (facts.lowest_hz.ln(), facts.highest_hz.ln());
    let place = move |f: f64| {
        if high > low {
            (2.0 * (f.ln() - low) / (high - low) - 1.0).clamp(-1.0, 1.0)
        } else {
            0.0
        }
    };
    let term = |k: usize| -> Box<dyn Fn(f64) -> f64> {
        Box::new(move |f| (k as f64 * place(f).acos()).cos())
    };
    (0..=order).map(term).collect()
}

/// Steps, one for each few of the frequencies.
pub(super) fn bands(problem: &Problem) -> Course {
    let frequencies = &problem.facts.frequencies_hz;
    let count = MOST_BANDS.min(frequencies.len());
    let edge = |b: usize| {
        let at = b * frequencies.len() / count;
        frequencies.get(at).copied().unwrap_or(f64::INFINITY)
    };
    let band = |b: usize| -> Box<dyn Fn(f64) -> f64> {
        let inside = edge(b)..edge(b + 1);
        Box::new(move |f| f64::from(u8::from(inside.contains(&f))))
    };
    (0..count).map(band).collect()
}
