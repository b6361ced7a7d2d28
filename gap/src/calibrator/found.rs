//! Sets that are worth a try, those that were refined, and what they say about others.

use super::candidate::PredictedGain;
use super::fit::Fit;
use super::linear::Slopes;
use super::problem::Problem;
use crate::effects::library;
use crate::model::effect::Shows;
use crate::thresholds;
use std::rc::Rc;

/// All fits so far.
pub(super) struct Found<'a> {
    problem: &'a Problem,
    pub(super) fits: Vec<Fit>,
}

impl<'a> Found<'a> {
    pub(super) fn new(problem: &'a Problem) -> Self {
        Self {
            problem,
            fits: Vec::new(),
        }
    }

    /// Keeps a fit that came to a value.
    pub(super) fn keep(&mut self, fit: Fit) {
        if fit.objective.is_finite() && fit.objective < f64::MAX {
            self.fits.push(fit);
        }
    }

    /// Sets of a size.
    pub(super) fn of_size(&self, size: usize) -> impl Iterator<Item = &Fit> {
        self.fits.iter().filter(move |f| f.effects.len() == size)
    }

    /// The best set of a size.
    pub(super) fn leader(&self, size: usize) -> Option<&Fit> {
        let of_size = self.of_size(size);
        of_size.min_by(|a, b| a.objective.total_cmp(&b.objective))
    }

    /// Library entries of the sets of a size.
    pub(super) fn tried(&self, size: usize) -> Vec<Vec<usize>> {
        self.of_size(size).map(entries).collect()
    }

    /// Whether a fit leaves what noise leaves: one per datum within three standard
    /// deviations, and no nominal value stretched.
    pub(super) fn is_noise(&self, fit: &Fit) -> bool {
        let mut nominal = self.problem.free.iter().zip(&fit.theta);
        self.problem.is_noise(fit.objective)
            && nominal
                .all(|(free, theta)| !free.bounded || theta.abs() < thresholds::NOMINAL_STRETCHED)
    }

    /// Remainder of a fit, in -2 ln likelihood, beyond noise, which is one per datum.
    pub(super) fn beyond_noise(&self, fit: &Fit) -> f64 {
        fit.objective - self.problem.len() as f64
    }

    /// Whether the best set of a size leaves noise, or little of what the best below it leaves beyond
    /// that. Where one more effect does not, none is the one that lacks.
    pub(super) fn closes(&self, size: usize) -> bool {
        let beyond = |size| {
            let leader = self.leader(size);
            leader.map_or(f64::INFINITY, |fit| self.beyond_noise(fit))
        };
        let noise = self.problem.most_of_noise() - self.problem.len() as f64;
        beyond(size) < noise.max(thresholds::CLOSES * beyond(size - 1))
    }

    /// Objective, after a few steps, from which a set of a size is not refined further; `nominal` is that without effects.
    ///
    /// It lacks a share of the best set's gain, and half of what that gains over the best set of one effect less: where
    /// one effect takes nearly all of a gap, every partner of it lacks less than a share of the whole.
    ///
    /// A set without an effect that scatters competes with its like alone where the best set leaves more than noise.
    pub(super) fn within_reach(&self, size: usize, nominal: f64, scatters: bool) -> f64 {
        let all = self.leader(size);
        if let Some(leader) = all.filter(|fit| self.is_noise(fit)) {
            return leader.objective.min(nominal) + thresholds::OUT_OF_REACH;
        }
        let leads = |size| {
            let of_size = self.of_size(size);
            let competing = of_size.filter(|fit| scatters || !self::scatters(fit));
            competing.fold(nominal, |best, fit| fit.objective.min(best))
        };
        let best = leads(size);
        let share = thresholds::REACH_SHARE * (nominal - best);
        let half = thresholds::HALF * (leads(size - 1) - best);
        best + thresholds::OUT_OF_REACH.max(share.min(half))
    }

    /// Drops extensions that cannot compete even if they gain more than the screening predicts.
    ///
    /// An effect that scatters can pass a gap off as noise, and then leads any one of several effects that are there:
    /// where the leading set leaves more than noise, a set without such an effect competes with its like alone, if
    /// what is added to it is more than a correction.
    ///
    /// Beside a part of it that leaves noise only, a set is worth a try where it promises `worth` more than that part.
    pub(super) fn drop_hopeless(&self, extensions: &mut Vec<Extension>, size: usize, worth: f64) {
        let cost = |f: &Fit| f.objective + thresholds::EFFECT_COST * f.effects.len() as f64;
        let least = |best: f64, fit| cost(fit).min(best);
        let best = self.fits.iter().fold(f64::INFINITY, least);
        let steady = self.fits.iter().filter(|f| !scatters(f));
        let best_steady = if self.fits.iter().any(|f| self.is_noise(f)) {
            best
        } else {
            steady.fold(f64::INFINITY, least)
        };
        let found = &self.fits;
        extensions.retain(|extension| {
            let entries = extension.entries();
            // Hardly better than a part of it that leaves noise only: the part is the better base for the same set.
            let worse = found.iter().any(|f| {
                f.effects.len() < size
                    && f.objective < extension.predicted + worth
                    && self.is_noise(f)
                    && f.effects.iter().all(|e| entries.contains(&e.entry))
            });
            let gain = extension.predicted_gain.gain;
            let is_cause = gain > thresholds::CAUSE_SHARE * self.beyond_noise(&extension.base.fit);
            let best = if is_cause && !extension.scatters() {
                best_steady
            } else {
                best
            };
            !worse
                && extension.predicted - thresholds::GAIN_SLACK * extension.predicted_gain.gain
                    + thresholds::EFFECT_COST * (size as f64)
                    < best + thresholds::COMPETING
        });
    }

    /// So many of the best sets of a size, and the best without an effect that scatters.
    pub(super) fn leaders(&self, size: usize, nominal: f64, most: usize) -> Vec<Fit> {
        let bases = self.bases(size, nominal);
        let steady = bases.iter().skip(most).find(|f| !scatters(f)).cloned();
        let mut leaders: Vec<Fit> = bases.into_iter().take(most).collect();
        if leaders.iter().all(scatters) {
            leaders.extend(steady);
        }
        leaders
    }

    /// Best sets of a size, and the best of each kind of observable.
    pub(super) fn bases(&self, size: usize, nominal: f64) -> Vec<Fit> {
        let mut list: Vec<Fit> = self.of_size(size).cloned().collect();
        list.sort_by(|a, b| a.objective.total_cmp(&b.objective));
        list.retain(|f| f.objective < nominal - thresholds::WORTH_REFINING);
        let mut kept: Vec<Fit> = Vec::new();
        let mut of_kind = [0; 3];
        for fit in list {
            let first = fit.effects.first();
            let kind = first.map_or(Shows::Response, |e| e.effect.shows()) as usize;
            if kept.len() < thresholds::BASES || of_kind[kind] < thresholds::BASES_OF_A_KIND {
                of_kind[kind] += 1;
                kept.push(fit);
            }
        }
        kept
    }
}

/// A set to which effects are added, with its slopes.
pub(super) struct Base {
    pub(super) fit: Fit,
    pub(super) slopes: Option<Slopes>,
}

/// An effect to add to a base, with the objective that the screening predicts.
pub(super) struct Extension {
    pub(super) predicted: f64,
    pub(super) base: Rc<Base>,
    pub(super) predicted_gain: PredictedGain,
}

impl Extension {
    pub(super) fn new(base: &Rc<Base>, predicted_gain: PredictedGain) -> Self {
        Self {
            predicted: base.fit.objective - predicted_gain.gain,
            base: Rc::clone(base),
            predicted_gain,
        }
    }

    /// Places in the library of the effects of the set, ascending.
    pub(super) fn entries(&self) -> Vec<usize> {
        let mut entries = entries(&self.base.fit);
        entries.push(self.predicted_gain.entry);
        entries.sort_unstable();
        entries
    }

    /// Whether an effect of the set shows as noise.
    pub(super) fn scatters(&self) -> bool {
        let added = library()[self.predicted_gain.entry];
        added.scatters() || scatters(&self.base.fit)
    }

    /// Whether the base holds an effect of the same name.
    pub(super) fn repeats(&self) -> bool {
        let name = library()[self.predicted_gain.entry].entry().id;
        let mut there = self.base.fit.effects.iter();
        there.any(|e| e.effect.entry().id == name)
    }
}

/// Whether an effect of a set shows as noise.
fn scatters(fit: &Fit) -> bool {
    let mut effects = fit.effects.iter();
    effects.any(|e| e.effect.scatters())
}

/// Places in the library of the effects of a set, ascending.
pub(super) fn entries(fit: &Fit) -> Vec<usize> {
    let mut entries: Vec<usize> = fit.effects.iter().map(|e| e.entry).collect();
    entries.sort_unstable();
    entries
}

/// The candidates of the largest predicted gains, overall and in each kind of observable.
pub(super) fn chosen(
    predicted: &[PredictedGain],
    overall: usize,
    per_kind: usize,
    floor: f64,
) -> Vec<PredictedGain> {
    let mut counts = [0; 3];
    let mut list = Vec::new();
    for (rank, predicted_gain) in predicted.iter().enumerate() {
        let count = &mut counts[predicted_gain.shows as usize];
        let in_kind = *count < per_kind && predicted_gain.gain > thresholds::WORTH_REFINING;
        if (predicted_gain.gain > floor && rank < overall) || in_kind {
            *count += 1;
            list.push(predicted_gain.clone());
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::super::candidate::active;
    use super::super::example::measured;
    use super::*;

    /// A fit with so many effects of the library, from the first one on.
    fn fit(problem: &Problem, effects: usize, objective: f64) -> Fit {
        let effect = |entry: usize| active(entry, vec![1.0; library()[entry].parameters().len()]);
        Fit {
            effects: (0..effects).map(effect).collect(),
            theta: vec![0.0; problem.free.len()],
            objective,
        }
    }

    fn problem() -> Problem {
        let (rig, points) = measured(&[]);
        Problem::new(&rig, &points)
    }

    /// One effect takes 1e9 of a gap down to 8e4, a second one to 2e4: a partner that leaves 7.9e4 took nothing, though
    /// it lacks a ten-thousandth of the whole.
    #[test]
    fn a_partner_of_a_gross_cause_is_within_reach_by_what_partners_gain() {
        let problem = problem();
        let mut found = Found::new(&problem);
        found.keep(fit(&problem, 1, 8e4));
        // The first of its size is.
        assert_eq!(found.within_reach(2, 1e9, true), 1e9 + 60.0);
        found.keep(fit(&problem, 2, 2e4));
        assert_eq!(found.within_reach(2, 1e9, true), 5e4);
        // Of a small gap a share of the whole is less than that.
        assert_eq!(found.within_reach(2, 1e5, true), 2e4 + 1600.0);
        // One that scatters leaves what others left uncertain: it puts only its like out of reach.
        let scatters = library().iter().position(|effect| effect.scatters());
        let tone = Fit {
            effects: vec![active(scatters.unwrap(), vec![1.0, 1.0])],
            ..fit(&problem, 1, 1e3)
        };
        found.keep(tone);
        let reach = [true, false].map(|scatters| found.within_reach(1, 1e9, scatters));
        assert_eq!(reach, [1e3 + 0.02 * (1e9 - 1e3), 8e4 + 0.02 * (1e9 - 8e4)]);
        // Beside a set that leaves noise only little is within reach.
        found.keep(fit(&problem, 2, 10.0));
        assert_eq!(found.within_reach(2, 1e9, true), 70.0);
    }

    /// A third effect that promises 10 where a pair in the set leaves noise is what noise promises; 30 is not.
    #[test]
    fn a_set_that_promises_little_more_than_a_part_that_leaves_noise_is_dropped() {
        let problem = problem();
        let mut found = Found::new(&problem);
        found.keep(fit(&problem, 2, 50.0));
        let other = Fit {
            effects: vec![active(2, vec![1.0]), active(0, vec![1.0])],
            ..fit(&problem, 0, 100.0)
        };
        let base = Rc::new(Base {
            fit: other,
            slopes: None,
        });
        let left = |gain: f64, worth: f64| {
            let predicted_gain = PredictedGain {
                entry: 1,
                gain,
                parameters: vec![1.0],
                shift: None,
                shows: Shows::Response,
            };
            let mut extensions = vec![Extension::new(&base, predicted_gain)];
            found.drop_hopeless(&mut extensions, 3, worth);
            extensions.len()
        };
        assert_eq!([left(60.0, 25.0), left(80.0, 25.0)], [0, 1]);
        assert_eq!([left(40.0, 0.0), left(60.0, 0.0)], [0, 1]);
    }
}
