//! A case with its answer.

use super::answers::{ScoredAnswer, ScoredCause};
use crate::truth::{TrueCase, Truth};
use calib_files::{Error, Result};
use std::collections::BTreeMap;

/// Probability above which a set counts as offered.
const OFFERED: f64 = 0.05;

/// A case with its answer, if there is one.
#[derive(Clone, Copy)]
pub(super) struct Pair<'a> {
    pub(super) truth: &'a TrueCase,
    pub(super) answer: Option<&'a ScoredAnswer>,
}

/// All cases of a set, with their answers.
pub(super) fn matched<'a>(answers: &'a [ScoredAnswer], truth: &'a Truth) -> Result<Vec<Pair<'a>>> {
    let mut by_sum: BTreeMap<&str, &ScoredAnswer> = BTreeMap::new();
    for answer in answers {
        by_sum.insert(&answer.dataset.sha256, answer);
    }
    let known = |sum: &str| truth.cases.iter().any(|case| case.dataset_sha256 == sum);
    if let Some(stranger) = by_sum.keys().find(|sum| !known(sum)) {
        return Err(Error::input(
            "answers",
            format!(
                "hold one about a dataset with SHA-256 {stranger}, which is not in the sealed set"
            ),
            "diagnose the folders of the set as they were sealed",
        ));
    }
    let pair = |case: &'a TrueCase| Pair {
        truth: case,
        answer: by_sum.get(case.dataset_sha256.as_str()).copied(),
    };
    Ok(truth.cases.iter().map(pair).collect())
}

impl Pair<'_> {
    pub(super) fn is(&self, verdict: &str) -> bool {
        self.answer.is_some_and(|answer| answer.verdict == verdict)
    }

    pub(super) fn is_true_set(&self, effects: &[String]) -> bool {
        let mut sorted = effects.to_vec();
        sorted.sort();
        sorted == self.truth.names
    }

    pub(super) fn alarmed(&self) -> bool {
        self.answer.is_some_and(|a| a.verdict != "no_gap")
    }

    pub(super) fn named(&self) -> bool {
        let first = self.answer.and_then(|a| a.causes.first());
        self.alarmed() && first.is_some_and(|cause| self.is_true_set(&cause.effects))
    }

    pub(super) fn offered(&self) -> impl Iterator<Item = &ScoredCause> {
        let causes = self.answer.map_or(&[][..], |a| a.causes.as_slice());
        causes.iter().filter(|c| c.probability > OFFERED)
    }

    pub(super) fn stage_found(&self) -> bool {
        let places = self.answer.map_or(&[][..], |a| a.r#where.as_slice());
        let mut first = places.iter().take(2);
        first.any(|place| self.truth.stages.contains(&place.stage))
    }
}
