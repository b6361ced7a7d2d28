//! How often each set of terms leads when the stretches of a record are drawn again.

use super::fit::Fitted;
use super::residual::residual;
use super::run::Run;
use crate::engine::significance::Gauss;

const DRAWS: usize = 100;

/// Share of bootstrap samples in which each fit has the least score.
///
/// Errors are correlated over a few periods of the resonance, so stretches of
/// `length` samples are drawn, not samples. The values stay as fitted;
/// `score(fit, square, least)` weighs a fit with a sum of squared errors, where `least`
/// is the least of all.
pub(super) fn stability(
    fits: &[&Fitted],
    record: &Run,
    length: usize,
    score: impl Fn(&Fitted, f64, f64) -> f64,
) -> Vec<f64> {
    let stretches = |fit: &&Fitted| -> Vec<f64> {
        let left = residual(&fit.values, record).unwrap_or_default();
        let square = |stretch: &[f64]| stretch.iter().map(|r| r * r).sum();
        left.chunks_exact(length.max(1)).map(square).collect()
    };
    let squares: Vec<Vec<f64>> = fits.iter().map(stretches).collect();
    let count = squares.iter().map(Vec::len).min().unwrap_or(0);
    let mut random = Gauss::new(1);
    let mut led = vec![0.0; fits.len()];
    for _ in 0..DRAWS {
        let place = |u: f64| ((u * count as f64) as usize).min(count.saturating_sub(1));
        let drawn: Vec<usize> = (0..count).map(|_| place(random.uniform())).collect();
        let sum = |squares: &Vec<f64>| drawn.iter().map(|at| squares[*at]).sum::<f64>();
        let sums: Vec<f64> = squares.iter().map(sum).collect();
        let least = sums.iter().copied().fold(f64::INFINITY, f64::min);
        let scored = fits
            .iter()
            .zip(&sums)
            .map(|(fit, sum)| score(fit, *sum, least));
        let best = scored.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((at, _)) = best {
            led[at] += 1.0;
        }
    }
    led.iter().map(|count| count / DRAWS as f64).collect()
}
