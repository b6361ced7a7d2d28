//! Starts for a spring that is bent so far that the linear fit is no neighbour of it.
//!
//! What a wrong spring does to the phase grows with time, and hides the right
//! one behind other minima: short stretches come first. Over a few periods a
//! fit finds a resonance that is off by some per cent, so resonances that close
//! are tried, each with springs from a softening to a hardening one.

use super::finely::integrate_finely;
use super::fit::{Fitted, refine};
use super::model::LINEAR;
use super::residual::rms;
use super::run::Run;

/// Share of the squared output from which a linear fit counts as poor.
const POOR: f64 = 0.03;
/// Resonances over that of the linear fit: how many, the lowest, and the factor between two.
const RESONANCES: (usize, f64, f64) = (24, 0.45, 1.04);
/// Stiffness at the amplitude of the stretch that is cubic, over that which is linear: 3 k3 sigma^2
/// for Gaussian motion of the standard deviation sigma.
const HARDENING: [f64; 6] = [-0.3, 0.1, 0.4, 1.0, 2.5, 6.0];
/// Factors on the damping: a linear fit takes for damping what does not repeat.
const DAMPING: [f64; 2] = [1.0, 0.2];
/// Samples of the first stretch, and steps of the fits on it.
const FIRST: (usize, usize) = (150, 14);
/// How much longer each stretch is than the one before, and steps of the fits on it. A motion that
/// jumps between branches is foreseen for a while only, which grows as the values get better.
const LONGER: (f64, usize) = (1.35, 40);
/// Starts that are followed from the first stretch on, and least of them.
const FOLLOWED: (usize, usize) = (12, 2);

/// The term this is about.
pub(super) const SPRING: usize = 0;

/// A cubic spring fitted from far away, and the steps per sample it takes; `None` where the linear
/// fit is not poor.
pub(super) fn spring(run: &Run, base: &Fitted) -> Option<(Fitted, usize)> {
    let size = rms(&run.output);
    if base.square < POOR * size * size * run.output.len() as f64 {
        return None;
    }
    let terms = [base.terms.as_slice(), &[SPRING]].concat();
    let head = rms(&run.head(FIRST.0).output).max(0.1 * size);
    let of = |lower: f64, hardening: f64, damping: f64| {
        let mut values = base.values;
        values[0] += lower.ln();
        values[1] *= damping / lower;
        values[2] /= lower * lower;
        values[LINEAR] = hardening / (3.0 * head * head);
        // The state at the first sample, from the samples: that of the linear fit is as wrong as it is.
        (values[4], values[5]) = run.first_state(values[0]);
        values
    };
    let (count, lowest, factor) = RESONANCES;
    let mut starts = Vec::with_capacity(count * HARDENING.len() * DAMPING.len());
    for i in 0..count {
        let lower = lowest * factor.powi(i as i32);
        for hardening in HARDENING {
            starts.extend(DAMPING.map(|damping| of(lower, hardening, damping)));
        }
    }
    let ((mut samples, mut most), (mut kept, least)) = (FIRST, FOLLOWED);
    let mut steps = run.steps;
    loop {
        let part = run.stretch(samples, steps);
        let fits = starts
            .iter()
            .filter_map(|s| refine(&part, *s, &terms, most));
        let mut fits: Vec<Fitted> = fits.collect();
        fits.sort_by(|a, b| a.square.total_cmp(&b.square));
        fits.truncate(kept);
        steps = integrate_finely(part, &mut fits).steps;
        if samples >= run.input.len() {
            return Some((fits.into_iter().next()?, steps));
        }
        starts = fits.into_iter().map(|f| f.values).collect();
        samples = (samples as f64 * LONGER.0) as usize;
        (most, kept) = (LONGER.1, (kept / 2).max(least));
    }
}
