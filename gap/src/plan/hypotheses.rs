//! Hypotheses still possible: sets of effects as the data leave them, or any effect.

use crate::answer::Verdict;
use crate::calibrator::candidate::active;
use crate::calibrator::evaluation::difference;
use crate::calibrator::fit::{Fit, Workspace};
use crate::calibrator::problem::Problem;
use crate::calibrator::search::{Limits, search};
use crate::calibrator::verdict::judge;
use crate::effects::library;
use crate::model::effect::{Active, Start};
use crate::options::Options;
use crate::thresholds;
use rayon::prelude::*;

/// A set that is taken for true, and one that is refitted; both are fits of one problem.
pub(super) struct Pairs<'a> {
    pub(super) of: &'a Problem,
    pub(super) list: Vec<(Fit, Fit)>,
}

/// Hypotheses a dataset leaves possible; where it shows no gap, any effect too small for it.
pub(super) fn of_data<'a>(
    problem: &'a Problem,
    reach: &'a Problem,
) -> (Option<Verdict>, Pairs<'a>) {
    let at_most_two = Options {
        most_effects: Some(2),
        ..Options::default()
    };
    let found = search(problem, &Limits::of(&at_most_two));
    let best = found.best();
    let verdict = judge(problem, &found, &mut Workspace::new(problem)).verdict;
    if verdict == Verdict::NoGap {
        return (Some(verdict), of_library(reach));
    }
    let mut sets: Vec<Fit> = found
        .sets
        .iter()
        .filter(|s| s.probability >= thresholds::LISTED_PROBABILITY && !s.fit.effects.is_empty())
        .map(|s| s.fit.clone())
        .take(thresholds::MOST_SETS)
        .collect();
    let undecided = sets.len() > 1;
    if !undecided {
        // One set leads: it is to be confirmed against the next best.
        let mut rest: Vec<&Fit> = found.every.iter().filter(|f| rivals(f, best)).collect();
        rest.sort_by(|a, b| a.objective.total_cmp(&b.objective));
        for fit in rest {
            if sets.len() < thresholds::MOST_SETS / 2
                && sets.iter().all(|s| s.names() != fit.names())
            {
                sets.push(fit.clone());
            }
        }
    }
    let mut pairs = Vec::new();
    let leaders = if undecided { sets.len() } else { 1 };
    for (at, one) in sets.iter().enumerate().take(leaders) {
        for other in &sets[at + 1..] {
            pairs.push((one.clone(), other.clone()));
        }
    }
    let pairs = Pairs {
        of: problem,
        list: pairs,
    };
    (Some(verdict), pairs)
}

fn rivals(fit: &Fit, best: &Fit) -> bool {
    let names = fit.names();
    !fit.effects.is_empty() && !best.names().iter().all(|n| names.contains(n))
}

/// Every effect against nothing, and against what it is confused with.
pub(super) fn of_library(reach: &Problem) -> Pairs<'_> {
    let nothing = bare(reach, Vec::new());
    let entries: Vec<usize> = library()
        .iter()
        .enumerate()
        .filter(|(_, effect)| effect.applies(&reach.facts))
        .map(|(entry, _)| entry)
        .collect();
    let signatures: Vec<Signature> = entries
        .par_iter()
        .flat_map_iter(|entry| signatures(reach, &nothing, *entry))
        .collect();
    let mut names: Vec<&str> = entries.iter().map(|e| library()[*e].entry().id).collect();
    names.dedup();
    let mut pairs = Vec::new();
    for name in names {
        let Some(one) = largest(&signatures, name) else {
            continue;
        };
        pairs.push((one.fit.clone(), nothing.clone()));
        for other in library()[one.entry].entry().confused_with {
            if let Some(rival) = most_alike(&signatures, one, other) {
                pairs.push((one.fit.clone(), rival.fit.clone()));
            }
        }
    }
    Pairs {
        of: reach,
        list: pairs,
    }
}

/// An effect at one start, sized, with what it changes.
struct Signature {
    entry: usize,
    fit: Fit,
    change: Vec<f64>,
    size: f64,
}

fn bare(problem: &Problem, effects: Vec<Active<'static>>) -> Fit {
    Fit {
        effects,
        theta: vec![0.0; problem.free.len()],
        objective: 0.0,
    }
}

fn signatures(reach: &Problem, nothing: &Fit, entry: usize) -> Vec<Signature> {
    let here = reach.evaluate(&[], &nothing.theta, &mut reach.memory());
    let starts = library()[entry].starts(&reach.facts);
    let of = |parameters: Vec<f64>| {
        let mut effect = active(entry, parameters);
        let bounds = effect.effect.parameters();
        for (value, bound) in effect.parameters.iter_mut().zip(bounds) {
            *value = value.clamp(bound.lower, bound.upper);
        }
        let fit = bare(reach, vec![effect]);
        let there = reach.evaluate(&fit.effects, &fit.theta, &mut reach.memory());
        let change = difference(reach, &here, &there);
        let size = change.iter().map(|c| c * c).sum::<f64>().sqrt();
        Signature {
            entry,
            fit,
            change,
            size,
        }
    };
    let sized = |start: &Start| {
        let first = of(start.members[0].clone());
        match start.amplitude {
            Some(_) if first.size > 0.0 => {
                let larger = thresholds::USUAL_SIGMA / first.size;
                of(library()[entry].combine(start, &[larger]))
            }
            _ => first,
        }
    };
    let usable = |s: &Signature| s.size.is_finite() && s.size > 1.0;
    starts.iter().map(sized).filter(usable).collect()
}

fn name(signature: &Signature) -> &'static str {
    library()[signature.entry].entry().id
}

/// The start of an effect whose size is nearest to the usual one.
fn largest<'a>(all: &'a [Signature], id: &str) -> Option<&'a Signature> {
    let off = |s: &Signature| (s.size / thresholds::USUAL_SIGMA).ln().abs();
    let of_name = all.iter().filter(|s| name(s) == id);
    of_name.min_by(|a, b| off(a).total_cmp(&off(b)))
}

/// The start of an effect that looks most like another one.
fn most_alike<'a>(all: &'a [Signature], one: &Signature, id: &str) -> Option<&'a Signature> {
    let alike = |s: &Signature| {
        let product: f64 = s.change.iter().zip(&one.change).map(|(a, b)| a * b).sum();
        product.abs() / (s.size * one.size)
    };
    let of_name = all.iter().filter(|s| name(s) == id);
    of_name.max_by(|a, b| alike(a).total_cmp(&alike(b)))
}
