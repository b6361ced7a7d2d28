//! Answers as they were given.

use crate::truth::{TrueCase, Truth};
use calib_files::{Error, Result, text};
use calib_gap::POSSIBLE_PROBABILITY;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// Fields of an answer that scoring needs; anybody's diagnosis can write them.
#[derive(Clone, Debug, Deserialize)]
pub struct ScoredAnswer {
    pub(super) verdict: String,
    pub(super) causes: Vec<ScoredCause>,
    pub(super) none_of_these_p_value: f64,
    #[serde(default)]
    pub(super) r#where: Vec<Place>,
    pub(super) gap: Closed,
    pub(super) dataset: Identity,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct ScoredCause {
    pub(super) effects: Vec<String>,
    pub(super) probability: f64,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct Place {
    pub(super) stage: String,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct Closed {
    pub(super) closed: Option<f64>,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct Identity {
    pub(super) sha256: String,
}

/// Reads answers: JSON lines, or one JSON array.
///
/// # Errors
/// [`Error::File`]; [`Error::Input`] with the line.
pub fn read_answers(path: &Path) -> Result<Vec<ScoredAnswer>> {
    let text = text::read(path)?;
    let broken = |line: usize, error: serde_json::Error| {
        let place = format!("{}:{line}", path.display());
        let hint = "answers are what `calib gap diagnose --json-lines` prints";
        Error::input(place, error.to_string(), hint)
    };
    if text.trim_start().starts_with('[') {
        return serde_json::from_str(&text).map_err(|e| broken(e.line(), e));
    }
    let lines = text.lines().enumerate();
    let filled = lines.filter(|(_, line)| !line.trim().is_empty());
    filled
        .map(|(at, line)| serde_json::from_str(line).map_err(|e| broken(at + 1, e)))
        .collect()
}

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
        causes
            .iter()
            .filter(|c| c.probability > POSSIBLE_PROBABILITY)
    }

    pub(super) fn stage_found(&self) -> bool {
        let places = self.answer.map_or(&[][..], |a| a.r#where.as_slice());
        let mut first = places.iter().take(2);
        first.any(|place| self.truth.stages.contains(&place.stage))
    }
}
