//! The share of the gap that is closed on rows that took no part.

use super::errors::Compared;
use super::fit::Fit;
use super::gap::Gap;
use super::problem::Problem;
use crate::dataset::Rig;
use crate::observable::Group;
use std::collections::BTreeMap;

/// Rows to choose and fit on, and rows that take no part: every third frequency.
pub(crate) fn split(problem: &Problem, rig: &Rig) -> (Problem, Problem) {
    let held = held_out(problem);
    let training = problem.subset(rig, &|row| !held[row]);
    let testing = problem.subset(rig, &|row| held[row]);
    (training, testing)
}

/// Every third frequency; every third row where there are few frequencies.
pub(crate) fn held_out(problem: &Problem) -> Vec<bool> {
    let frequencies = &problem.facts.frequencies_hz;
    if frequencies.len() < 9 {
        return (0..problem.rows.len()).map(|i| i % 3 == 1).collect();
    }
    problem
        .rows
        .iter()
        .map(|r| frequencies.partition_point(|f| *f < r.frequency_hz) % 3 == 1)
        .collect()
}

/// Scores fits of one problem on another with the same rig.
pub(crate) fn score_on(training: &Problem, testing: &Problem, nominal: &Fit, chosen: &Fit) -> Gap {
    let compared = Compared::by_group(training, testing, nominal, chosen);
    let mut responses = Group::RESPONSES.into_iter();
    let has_response = responses.any(|group| !testing.data_of_group(group).is_empty());
    let mut pooled = Compared::default();
    let mut by_observable = BTreeMap::new();
    let (mut closed, mut weights) = (0.0, 0.0);
    for (compared, group) in compared.iter().zip(Group::ALL) {
        if compared.before.rows == 0.0 {
            continue;
        }
        let gap = compared.gap();
        if let Some(share) = gap.closed {
            closed += share * compared.excess();
            weights += compared.excess();
        }
        let counts = group.is_response() || !has_response;
        pool(&mut pooled, compared, counts);
        by_observable.insert(group.name(), gap);
    }
    let [before_percent, after_percent, floor_percent] = pooled.percent();
    let [chi_before, chi_after] = pooled.chi();
    Gap {
        before_percent,
        after_percent,
        floor_percent,
        closed: if weights > 0.0 {
            Some(closed / weights)
        } else {
            // No observable stands out of its noise by itself: what all of them together show.
            let is_gap = pooled.before.square > pooled.before.floor;
            (!chosen.effects.is_empty() && is_gap).then(|| pooled.share())
        },
        chi_before,
        chi_after,
        held_out_rows: testing.rows.len(),
        chosen: chosen.names(),
        rms_before: None,
        rms_after: None,
        by_observable,
        by_level: Vec::new(),
        by_band: Vec::new(),
    }
}

/// Adds a group to the sums over all; relative errors of responses stand for themselves.
fn pool(pooled: &mut Compared, one: &Compared, counts: bool) {
    let sums = [&mut pooled.before, &mut pooled.after].into_iter();
    for (sum, errors) in sums.zip([&one.before, &one.after]) {
        if counts {
            sum.square += errors.square;
            sum.floor += errors.floor;
            sum.rows += errors.rows;
        }
        sum.chi += errors.chi;
        sum.data += errors.data;
    }
}
