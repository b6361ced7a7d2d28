//! Data a diagnosis is scored on: rows, or a dataset, that took no part in it.

use super::cross_validation;
use super::fit::{Fit, Workspace};
use super::holdout::{score_on, split};
use super::noise::Noise;
use super::problem::Problem;
use super::refine::{FULL, refine};
use super::search::{Limits, Search, search_from};
use crate::answer::Verdict;
use crate::dataset::{Dataset, Rig};
use crate::estimation::gap::Gap;
use crate::estimation::verdict::stands;
use crate::observable::Observable;
use crate::thresholds;
use std::cell::RefCell;

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
    /// Sets that the search did not try, fitted since.
    since: RefCell<Vec<Fit>>,
}

impl<'a> Unseen<'a> {
    /// Points of `validate` if there are any, else a third of the rows; the others are searched from what was found
    /// there `before`, with other uncertainties.
    pub(super) fn new(
        dataset: &'a Dataset,
        problem: &Problem,
        validate: Option<&'a Dataset>,
        limits: &Limits,
        before: Option<&Self>,
    ) -> Self {
        let other = validate.and_then(|other| {
            let problem = Problem::from_dataset(&other.rig, &other.measured)?;
            Some(Self::Other(Box::new(problem), &other.rig))
        });
        other.unwrap_or_else(|| {
            let (training, testing) = split(problem, &dataset.rig);
            let part = Part {
                found: search_from(&training, limits, before.and_then(Self::searched)),
                training,
                testing,
                since: RefCell::default(),
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

    /// Noise that is not what is stated, by what a search on part of the rows has found: nothing, the
    /// best single effect and the best set.
    pub(super) fn noise(&self, dataset: &Dataset, problem: &Problem) -> Option<Noise> {
        let Self::Rows(part, _) = self else {
            return None;
        };
        // What a set leaves uncertain looks like noise, whatever it is.
        let certain = |fit: &&Fit| {
            part.training.is_noise(fit.objective) || self.scatter_is_seen(problem, fit)
        };
        let sets = part.found.sets.iter().map(|set| &set.fit);
        let (mut sets, mut singles) = (sets.clone(), sets.filter(|fit| fit.effects.len() == 1));
        let fits = sets.find(certain).into_iter().chain(singles.find(certain));
        let mut fits: Vec<Fit> = fits.chain([&part.found.nominal]).cloned().collect();
        fits.dedup_by_key(|fit| fit.names());
        for fit in &mut fits {
            fit.theta = problem.translate(&part.training, &fit.theta);
        }
        Noise::of(
            problem,
            &dataset.rig,
            fits.into_iter(),
            &mut Workspace::new(problem),
        )
    }

    /// Strikes sets that the unseen rows speak against.
    pub(super) fn veto(&self, problem: &Problem, found: &mut Search) {
        let plain = self.misfit(problem, &found.nominal);
        let stands = |fit: &Fit| {
            let partners = (0..fit.effects.len()).filter(|_| fit.effects.len() > 1);
            let without = partners.map(|at| self.misfit_without(problem, fit, at));
            let clean = problem.is_noise(fit.objective);
            stands(self.misfit(problem, fit), plain, without, clean)
                && (clean || self.scatter_is_seen(problem, fit))
        };
        found.strike(stands);
    }

    /// Whether the noise of the unseen rows shows each effect of a set that only scatters. To leave uncertain what a
    /// set does not describe is no evidence.
    fn scatter_is_seen(&self, problem: &Problem, fit: &Fit) -> bool {
        let of_noise = |fit: &Fit| self.misfit_of(problem, fit, Observable::is_noise);
        let here = of_noise(fit);
        let mut effects = fit.effects.iter().enumerate();
        effects.all(|(at, active)| {
            !active.effect.scatters()
                || here + thresholds::PARTNER_HELPS < of_noise(&without(fit, at))
        })
    }

    /// Whether a set leaves noise, and each of its effects many times what noise is where it alone is left out: on
    /// unseen rows, too much for a correction of the others' form.
    pub(super) fn needs_each(&self, problem: &Problem, fit: &Fit) -> bool {
        if !problem.is_noise(fit.objective) {
            return false;
        }
        let needed = thresholds::NO_CORRECTION * self.misfit(problem, fit).abs();
        let mut each = 0..fit.effects.len();
        each.all(|at| self.misfit_without(problem, fit, at) > needed)
    }

    /// Misfit of the unseen rows without one effect of a set, the others kept as they are.
    fn misfit_without(&self, problem: &Problem, fit: &Fit, at: usize) -> f64 {
        self.misfit(problem, &without(fit, at))
    }

    /// The gap with one set, fitted to the others.
    pub(super) fn gap_with(&self, problem: &Problem, found: &Search, fit: &Fit) -> Gap {
        match self {
            Self::Other(other, _) => score_on(problem, other, &found.nominal, fit),
            Self::Rows(part, _) => {
                let fit = part.fitted(problem, fit);
                score_on(&part.training, &part.testing, &part.found.nominal, &fit)
            }
        }
    }

    /// -2 ln likelihood of the unseen rows by a set that was fitted to the others, and of the nominal
    /// values it takes: where they may go as far as they like, they stand in for an effect in any row.
    fn misfit(&self, problem: &Problem, fit: &Fit) -> f64 {
        self.misfit_of(problem, fit, |_| true)
    }

    /// Misfit of some observables.
    fn misfit_of(&self, problem: &Problem, fit: &Fit, counts: impl Fn(Observable) -> bool) -> f64 {
        let (testing, from, fit) = match self {
            Self::Other(other, _) => (&**other, problem, fit.clone()),
            Self::Rows(part, _) => (&part.testing, &part.training, part.fitted(problem, fit)),
        };
        let theta = testing.translate(from, &fit.theta);
        let at = testing.evaluate(&fit.effects, &theta, &mut testing.memory());
        let counted = testing.measured_observables();
        let counted = counted.filter(|(observable, _)| counts(*observable));
        let data = counted.flat_map(|(_, data)| data).map(|datum| {
            let (r, w) = (at.residual[datum], at.weight[datum]);
            r * r - 2.0 * (w * testing.uncertainty(datum)).ln()
        });
        let stated = from.free.iter().zip(&fit.theta).filter(|(f, _)| f.bounded);
        data.sum::<f64>() + stated.map(|(_, value)| value * value).sum::<f64>()
    }

    /// The gap with the plain simulation and with the best set of a search on all rows of `problem`.
    pub(super) fn gap(
        &self,
        problem: &Problem,
        found: &Search,
        verdict: Verdict,
        work: &mut Workspace,
    ) -> Gap {
        let (nominal, best) = (&found.nominal, found.best());
        let (gap, [by_level, by_band]) = match self {
            Self::Other(other, rig) => (
                score_on(problem, other, nominal, best),
                cross_validation::of_other(problem, other, rig, nominal, best),
            ),
            Self::Rows(part, rig) => (
                part.gap(problem, found, verdict),
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
    /// A set as it is fitted to the rows that take part.
    fn fitted(&self, problem: &Problem, fit: &Fit) -> Fit {
        if fit.effects.is_empty() {
            return self.found.nominal.clone();
        }
        let names = fit.sorted_names();
        let mut since = self.since.borrow_mut();
        let same = self.found.every.iter().chain(since.iter());
        let same = same.filter(|f| f.sorted_names() == names);
        let best = same.min_by(|a, b| a.objective.total_cmp(&b.objective));
        if let Some(best) = best {
            return best.clone();
        }
        let theta = self.training.translate(problem, &fit.theta);
        let mut work = Workspace::new(&self.training);
        let fitted = refine(&self.training, fit.effects.clone(), theta, FULL, &mut work);
        since.push(fitted.clone());
        fitted
    }

    /// Scores what was chosen on the others; nothing where there is no gap. The set that leads on all rows where
    /// a veto has struck what leads there, or where it pays there as well: too few rows are searched for fewer effects.
    fn gap(&self, problem: &Problem, found: &Search, verdict: Verdict) -> Gap {
        let nominal = &self.found.nominal;
        let leads = self.found.sets.first().map(|set| &set.fit);
        let listed = |fit: &&Fit| {
            let mut sets = found.sets.iter();
            sets.any(|set| set.fit.sorted_names() == fit.sorted_names())
        };
        let chosen = match (verdict, leads.filter(listed)) {
            (Verdict::NoGap | Verdict::Data, _) => nominal.clone(),
            (_, leads) => {
                let best = self.fitted(problem, found.best());
                leads
                    .filter(|fit| !pays(&best, fit))
                    .unwrap_or(&best)
                    .clone()
            }
        };
        score_on(&self.training, &self.testing, nominal, &chosen)
    }
}

/// A set without one of its effects, the others as they are.
fn without(fit: &Fit, at: usize) -> Fit {
    let mut less = fit.clone();
    less.effects.remove(at);
    less
}

/// Whether a set describes the rows better than another, both fitted to them, by more than one effect costs and those
/// that it has more of.
fn pays(set: &Fit, other: &Fit) -> bool {
    let more = 1 + set.effects.len().saturating_sub(other.effects.len());
    other.objective - set.objective > thresholds::EFFECT_COST * more as f64
}
