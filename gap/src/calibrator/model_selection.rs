//! How sets of effects compare: evidence with a cost for each effect and parameter.

use super::fit::Fit;
use super::problem::Problem;
use crate::effects::library;
use crate::estimation::selection::{cost_of_cause, cost_of_parameter, probabilities};
use crate::model::effect::Effect;
use crate::thresholds;

/// A refined set with its score, -2 ln of the (unnormalised) posterior probability.
#[derive(Clone)]
pub(crate) struct Scored {
    pub(crate) fit: Fit,
    pub(crate) bic: f64,
    pub(crate) score: f64,
    pub(crate) probability: f64,
}

/// Scores the sets, keeps the best variant of each, drops what a subset does better.
pub(super) fn score(
    problem: &Problem,
    nominal: &Fit,
    found: Vec<Fit>,
    allowed: &[bool],
) -> Vec<Scored> {
    let per_name = cost_of_cause(possible_names(problem, allowed).max(1) as f64);
    let per_parameter = cost_of_parameter(problem.len() as f64);
    let mut sets: Vec<Scored> = std::iter::once(nominal.clone())
        .chain(found)
        .map(|fit| {
            let bic = fit.objective + per_parameter * fit.parameter_count() as f64;
            // Equals come in the order of the library.
            let order: usize = fit.effects.iter().map(|e| e.entry).sum();
            let score = bic + per_name * fit.effects.len() as f64 + thresholds::TIE * order as f64;
            Scored {
                fit,
                bic,
                score,
                probability: 0.0,
            }
        })
        .collect();
    sets.sort_by(|a, b| a.score.total_cmp(&b.score));
    let mut kept: Vec<Scored> = Vec::new();
    for set in sets {
        let names = set.fit.sorted_names();
        // Occam's window: a set is not considered beside a better one made of part of it.
        // (No effect at all is part of every set: a gap too faint to be claimed has possible causes.)
        if !kept.iter().any(|k| {
            let part = k.fit.sorted_names();
            part.iter().all(|n| names.contains(n)) && (!part.is_empty() || names.is_empty())
        }) {
            kept.push(set);
        }
    }
    normalise(&mut kept);
    kept
}

/// Names of the library that may stand in this problem.
fn possible_names(problem: &Problem, allowed: &[bool]) -> usize {
    let entries = library().iter().zip(allowed);
    // Two names for the same in data of this kind count as one.
    let counts = |e: &dyn Effect| e.applies(&problem.facts) && e.alike(&problem.facts).is_none();
    let possible = entries.filter(|(e, ok)| **ok && counts(**e));
    let mut names: Vec<&str> = possible.map(|(e, _)| e.entry().id).collect();
    names.dedup();
    names.len()
}

/// Probabilities among the sets.
pub(super) fn normalise(sets: &mut [Scored]) {
    let scores: Vec<f64> = sets.iter().map(|s| s.score).collect();
    for (set, probability) in sets.iter_mut().zip(probabilities(&scores)) {
        set.probability = probability;
    }
}
