//! Which stage a gap points to, by what explains it and by its class.
//!
//! ```text
//! class     the class of a gap: which kind of deviation accounts for most of it
//! kind      the kinds; rules: observables and courses of each; course: over frequency
//! pattern   what columns with free amounts take out of a residual
//! suggested the stages these point to
//! shape     the course of the ratio in words
//! ```

mod class;
mod course;
mod kind;
mod pattern;
mod rules;
mod shape;
mod suggested;

use crate::answer::Verdict;
use crate::effects::{About, Stage, list};
use crate::engine::fit::Workspace;
use crate::engine::problem::Problem;
use crate::engine::search::Search;
use crate::engine::structure::Structure;
use crate::model::row::{CURRENT, DC, DRIVE, DUT_HARMONICS, NOISE, RATIO, REF_HARMONICS, SLOTS};
use std::collections::BTreeMap;
use suggested::by_class;

pub(crate) use shape::of_ratio;

/// Stages in the order of what speaks for them, with the chi-square they account for.
pub(crate) fn rank(
    problem: &Problem,
    found: &Search,
    nominal: &Structure,
    verdict: Verdict,
    work: &mut Workspace,
) -> Vec<(Stage, f64)> {
    let by_effects = by_effects(found);
    let classes = class::classes(problem, &found.nominal, work);
    let by_class = by_class(problem, nominal, &classes);
    let named: Vec<&About> = found.sets.first().map_or_else(Vec::new, |best| {
        best.fit.effects.iter().map(|e| e.effect.about()).collect()
    });
    let mut order: Vec<Stage> = Vec::new();
    if verdict == Verdict::Unexplained {
        // What was named is a substitute: the gap itself speaks first.
        order.extend(by_class.iter().take(2).map(|s| s.0));
    }
    order.extend(named.iter().map(|about| about.stage));
    if let [alone] = named.as_slice() {
        order.extend(mistaken_for(alone));
    }
    order.extend(by_effects.iter().chain(&by_class).map(|s| s.0));
    let share = |stage: Stage| {
        let of = |list: &[(Stage, f64)]| list.iter().find(|s| s.0 == stage).map(|s| s.1);
        of(&by_effects).or_else(|| of(&by_class)).unwrap_or(0.0)
    };
    let mut ranked: Vec<(Stage, f64)> = Vec::new();
    for stage in order {
        if !ranked.iter().any(|r| r.0 == stage) {
            ranked.push((stage, share(stage)));
        }
    }
    ranked.truncate(4);
    ranked
}

/// The other stage in which what is first mistaken for an effect sits.
fn mistaken_for(about: &About) -> Option<Stage> {
    let library = list();
    let stage = |id: &&str| library.iter().find(|a| a.id == *id).map(|a| a.stage);
    about
        .confused_with
        .iter()
        .filter_map(stage)
        .find(|s| *s != about.stage)
}

/// Gain of the best set that has an effect of a stage and nothing else.
fn by_effects(found: &Search) -> Vec<(Stage, f64)> {
    let mut best: BTreeMap<Stage, f64> = BTreeMap::new();
    for set in found.sets.iter().filter(|s| s.fit.effects.len() == 1) {
        let gain = found.nominal.objective - set.fit.objective;
        let stage = set.fit.effects[0].effect.about().stage;
        let entry = best.entry(stage).or_insert(0.0);
        *entry = entry.max(gain);
    }
    let mut list: Vec<_> = best.into_iter().filter(|(_, g)| *g > 9.0).collect();
    list.sort_by(|a, b| b.1.total_cmp(&a.1));
    list
}

/// The strongest test in the observables of a stage: slot, axis, deviate.
pub(crate) fn evidence(
    stage: Stage,
    first: &Structure,
    second: &Structure,
) -> (usize, &'static str, f64) {
    let slots: &[(usize, usize)] = match stage {
        Stage::Exciter | Stage::Amplifier => &[(DRIVE, DUT_HARMONICS)],
        Stage::Environment => &[(NOISE, SLOTS)],
        Stage::Digitiser => &[(RATIO, DRIVE), (REF_HARMONICS, SLOTS)],
        Stage::Conditioning => &[(RATIO, DRIVE), (NOISE, SLOTS)],
        Stage::Reference => &[(RATIO, CURRENT)],
        Stage::Dut | Stage::Mount => &[(RATIO, DRIVE), (DUT_HARMONICS, DC)],
    };
    let strongest = |structure: &Structure, slots: &[(usize, usize)]| {
        let inside = |slot: usize| slots.iter().any(|(a, b)| (*a..*b).contains(&slot));
        let chosen = structure.outcomes.iter().filter(|o| inside(o.slot));
        chosen
            .max_by(|a, b| a.z.abs().total_cmp(&b.z.abs()))
            .map(|o| (o.slot, o.axis, o.z))
    };
    strongest(first, slots)
        .or_else(|| strongest(second, slots))
        .or_else(|| strongest(second, &[(0, SLOTS)]))
        .unwrap_or((RATIO, "frequency_hz", 0.0))
}
