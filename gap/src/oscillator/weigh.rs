//! How the sets of terms that were tried compare.

use super::across::stretch;
use super::estimates::term_parameters;
use super::fit::Fitted;
use super::model::{TERMS, places};
use super::run::Run;
use super::stability::stability;
use super::step::Step;
use crate::answer::Cause;
use crate::verdict::{LISTED, NONE_BELOW};

/// Share of squared errors below which two sets do equally well where both leave more than
/// noise: 3 % in amplitude. What is left is model error, and favours none of them.
const AS_GOOD: f64 = 0.061;
/// Share of the samples that count as independent beside model error: it has the memory of the
/// resonance, a few tens of samples.
const INDEPENDENT: f64 = 0.02;
/// Odds of a leading term against a later one, or one with a kink: forces of a real oscillator
/// expand in powers first.
const ODDS_OF_LEADING: f64 = 3.0;
/// Prior odds of one more term, spread over all of them.
const PRIOR_OF_MORE: f64 = 0.5;

/// The sets of the size that was chosen, most probable first, each with its probability and its
/// score above the best.
pub(super) fn weigh(step: &Step) -> Vec<(&Fitted, f64, f64)> {
    let least = least_square(step);
    let score = |f: &Fitted| score(step, f, f.square, least);
    let mut list: Vec<(&Fitted, f64, f64)> =
        step.tried.iter().map(|f| (f, 0.0, score(f))).collect();
    list.sort_by(|a, b| a.2.total_cmp(&b.2));
    let best = list.first().map_or(0.0, |l| l.2);
    let total: f64 = list.iter().map(|l| (-0.5 * (l.2 - best)).exp()).sum();
    for (_, probability, score) in &mut list {
        *score -= best;
        *probability = (-0.5 * *score).exp() / total;
    }
    list
}

fn least_square(step: &Step) -> f64 {
    let squares = step.tried.iter().map(|f| f.square);
    squares.fold(f64::INFINITY, f64::min)
}

/// -2 ln of the posterior probability of a set, with the given sum of squared errors, among
/// those of its size, of which the best has the square `least`.
fn score(step: &Step, fit: &Fitted, square: f64, least: f64) -> f64 {
    let white = step.left.p_value >= NONE_BELOW;
    let samples = step.left.samples * if white { 1.0 } else { INDEPENDENT };
    let tied = if white { 0.0 } else { AS_GOOD };
    samples * square.max(least * (1.0 + tied)).max(f64::MIN_POSITIVE).ln()
        + cost_of_last(fit, samples)
}

/// What the last term of a set costs, in -2 ln of the posterior probability.
pub(super) fn cost_of_last(fit: &Fitted, samples: f64) -> f64 {
    fit.terms.last().map_or(0.0, |term| {
        let odds = if TERMS[*term].leading {
            1.0
        } else {
            ODDS_OF_LEADING
        };
        places(*term).len() as f64 * samples.max(std::f64::consts::E).ln()
            + 2.0 * (odds * TERMS.len() as f64 / PRIOR_OF_MORE).ln()
    })
}

/// Sets that are worth listing.
pub(super) fn causes(step: &Step, part: &Run, resonance_hz: f64) -> Vec<Cause> {
    if step.fit.terms.is_empty() {
        return Vec::new();
    }
    let listed: Vec<_> = weigh(step).into_iter().filter(|l| l.1 > LISTED).collect();
    let fits: Vec<&Fitted> = listed.iter().map(|l| l.0).collect();
    let length = stretch(resonance_hz, part.interval_s);
    let drawn = |f: &Fitted, square: f64, least: f64| score(step, f, square, least);
    let stability = stability(&fits, part, length, drawn);
    let causes = listed.into_iter().zip(stability);
    causes
        .map(|((fit, probability, delta_bic), stability)| Cause {
            effects: names_of(fit),
            probability,
            delta_bic,
            stability,
            stability_over_runs: None,
            parameters: term_parameters(fit),
        })
        .collect()
}

/// Names of the terms of a fit.
pub(super) fn names_of(fit: &Fitted) -> Vec<&'static str> {
    fit.terms.iter().map(|t| TERMS[*t].name).collect()
}
