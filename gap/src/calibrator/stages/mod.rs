//! Which stage a gap points to, by what explains it and by its class.
//!
//! ```text
//! rules     observables and courses of each kind of deviation, and the kind that accounts for most
//! pattern   the kinds; what columns with free amounts take out of a residual
//! suggested the stages these point to
//! shape     the course of the ratio in words
//! ```

mod pattern;
mod rules;
mod shape;
mod suggested;

use crate::answer::Verdict;
use crate::axis::Axis;
use crate::calibrator::fit::Workspace;
use crate::calibrator::lack_of_fit::LackOfFit;
use crate::calibrator::problem::Problem;
use crate::calibrator::search::Search;
use crate::observable::{Group, Observable};
use crate::thresholds;
use calib_effects::{Entry, Of, Stage, named as entry};
use rules::classes;
use std::collections::BTreeMap;
use suggested::by_class;

pub(crate) use shape::of_ratio;

/// Stages in the order of what speaks for them, with the chi-square they account for.
pub(crate) fn rank(
    problem: &Problem,
    found: &Search,
    nominal: &LackOfFit,
    verdict: Verdict,
    work: &mut Workspace,
) -> Vec<(Stage, f64)> {
    let by_effects = by_effects(found);
    let classes = classes(problem, &found.nominal, work);
    let by_class = by_class(problem, nominal, &classes);
    let named: Vec<&Entry> = found.sets.first().map_or_else(Vec::new, |best| {
        best.fit.effects.iter().map(|e| e.effect.entry()).collect()
    });
    let mut order: Vec<Stage> = Vec::new();
    if verdict == Verdict::Unexplained {
        // What was named is a substitute: the gap itself speaks first.
        order.extend(by_class.iter().take(2).map(|s| s.0));
    }
    if verdict == Verdict::PartlyExplained {
        // What was named is there, or stands for something near it.
        order.extend(named.first().map(|entry| entry.stage));
        order.extend(by_class.first().map(|s| s.0));
    }
    order.extend(named.iter().map(|entry| entry.stage));
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
fn mistaken_for(one: &Entry) -> Option<Stage> {
    let others = one.confused_with.iter();
    let mut stages = others.filter_map(|id| Some(entry(Of::Calibrator, id)?.stage));
    stages.find(|stage| *stage != one.stage)
}

/// Gain of the best set that has an effect of a stage and nothing else.
fn by_effects(found: &Search) -> Vec<(Stage, f64)> {
    let mut best: BTreeMap<Stage, f64> = BTreeMap::new();
    for set in found.sets.iter().filter(|s| s.fit.effects.len() == 1) {
        let gain = found.nominal.objective - set.fit.objective;
        let stage = set.fit.effects[0].effect.entry().stage;
        let entry = best.entry(stage).or_insert(0.0);
        *entry = entry.max(gain);
    }
    let mut list: Vec<_> = best
        .into_iter()
        .filter(|(_, g)| *g > thresholds::WORTH_ADDING)
        .collect();
    list.sort_by(|a, b| b.1.total_cmp(&a.1));
    list
}

/// The strongest test in the observables of a stage: observable, axis, deviate.
pub(crate) fn evidence(
    stage: Stage,
    first: &LackOfFit,
    second: &LackOfFit,
) -> (Observable, Axis, f64) {
    let groups: &[Group] = match stage {
        Stage::Exciter | Stage::Amplifier => &[Group::Drive, Group::Current, Group::RefHarmonics],
        Stage::Environment => &[Group::Noise],
        Stage::Digitiser => &[
            Group::Ratio,
            Group::RefHarmonics,
            Group::DutHarmonics,
            Group::Dc,
            Group::Noise,
        ],
        Stage::Conditioning => &[Group::Ratio, Group::Noise],
        Stage::Reference => &[Group::Ratio, Group::Drive],
        Stage::Dut | Stage::Mount => &[Group::Ratio, Group::DutHarmonics],
    };
    let strongest = |lack_of_fit: &LackOfFit, groups: &[Group]| {
        let outcomes = lack_of_fit.outcomes.iter();
        let inside = outcomes.filter(|o| groups.contains(&o.observable.group()));
        inside
            .max_by(|a, b| a.z.abs().total_cmp(&b.z.abs()))
            .map(|o| (o.observable, o.axis, o.z))
    };
    strongest(first, groups)
        .or_else(|| strongest(second, groups))
        .or_else(|| strongest(second, &Group::ALL))
        .unwrap_or((Observable::Ratio, Axis::Frequency, 0.0))
}
