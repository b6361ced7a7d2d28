//! Data a diagnosis is scored on: rows, or a dataset, that took no part in it.

use super::cross_validation;
use super::fit::{Fit, Workspace};
use super::holdout::{score_on, split};
use super::limits::Limits;
use super::problem::Problem;
use super::search::{Search, search};
use crate::answer::Verdict;
use crate::dataset::{Dataset, Rig};
use crate::estimation::gap::Gap;

/// Where the score comes from, with the rig as it is stated there.
pub(super) enum Unseen<'a> {
    /// Another dataset of the same calibrator.
    Other(Box<Problem>, &'a Rig),
    /// Part of the rows.
    Rows(Box<Part>, &'a Rig),
}

/// Rows that take no part, and what a search on the others found.
pub(super) struct Part {
    training: Problem,
    testing: Problem,
    found: Search,
}

impl<'a> Unseen<'a> {
    /// Points of `validate` if there are any, else a third of the rows.
    pub(super) fn new(
        dataset: &'a Dataset,
        problem: &Problem,
        validate: Option<&'a Dataset>,
        limits: &Limits,
    ) -> Self {
        let other = validate.and_then(|other| {
            let problem = Problem::from_dataset(&other.rig, &other.measured)?;
            Some(Self::Other(Box::new(problem), &other.rig))
        });
        other.unwrap_or_else(|| {
            let (training, testing) = split(problem, &dataset.rig);
            let part = Part {
                found: search(&training, limits),
                training,
                testing,
            };
            Self::Rows(Box::new(part), &dataset.rig)
        })
    }

    /// The rows that were searched by themselves, and what was found there.
    pub(super) fn searched(&self) -> Option<(&Problem, &Search)> {
        match self {
            Self::Other(..) => None,
            Self::Rows(part, _) => Some((&part.training, &part.found)),
        }
    }

    /// The gap with the plain simulation and with the best set of a search on all rows of `problem`.
    pub(super) fn gap(
        &self,
        problem: &Problem,
        [nominal, best]: [&Fit; 2],
        verdict: Verdict,
        work: &mut Workspace,
    ) -> Gap {
        let (gap, [by_level, by_band]) = match self {
            Self::Other(other, rig) => (
                score_on(problem, other, nominal, best),
                cross_validation::of_other(problem, other, rig, nominal, best),
            ),
            Self::Rows(part, rig) => (
                part.gap(verdict),
                cross_validation::left_out(problem, rig, nominal, best, work),
            ),
        };
        Gap {
            by_level,
            by_band,
            ..gap
        }
    }
}

impl Part {
    /// Scores what was chosen on the others; nothing where there is no gap.
    fn gap(&self, verdict: Verdict) -> Gap {
        let nominal = &self.found.nominal;
        let chosen = match self.found.sets.first() {
            Some(best) if verdict != Verdict::NoGap => &best.fit,
            _ => nominal,
        };
        score_on(&self.training, &self.testing, nominal, chosen)
    }
}
