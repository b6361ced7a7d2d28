//! Sets that are worth a try, those that were refined, and what they say about others.

use super::candidate::PredictedGain;
use super::fit::Fit;
use super::linear::Slopes;
use super::problem::Problem;
use crate::effects::{Shows, library};
use crate::thresholds;
use std::rc::Rc;

/// Singles from which pairs are grown.
const BASES: usize = 7;

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
        let count = self.problem.len() as f64;
        let mut nominal = self.problem.free.iter().zip(&fit.theta);
        fit.objective < count + thresholds::NOISE_CHI_SIGMA * (2.0 * count).sqrt()
            && nominal
                .all(|(free, theta)| !free.bounded || theta.abs() < thresholds::NOMINAL_STRETCHED)
    }

    /// What a fit leaves of -2 ln likelihood beyond noise, which is one per datum.
    pub(super) fn beyond_noise(&self, fit: &Fit) -> f64 {
        fit.objective - self.problem.len() as f64
    }

    /// Whether the best set of a size leaves noise, or little of what the best below it leaves beyond
    /// that. Where one more effect does not, none is the one that lacks.
    pub(super) fn closes(&self, size: usize) -> bool {
        let count = self.problem.len() as f64;
        let beyond = |size| {
            let leader = self.leader(size);
            leader.map_or(f64::INFINITY, |fit| self.beyond_noise(fit))
        };
        let noise = thresholds::NOISE_CHI_SIGMA * (2.0 * count).sqrt();
        beyond(size) < noise.max(thresholds::CLOSES * beyond(size - 1))
    }

    /// Drops plans that cannot compete even if they gain more than the screening predicts.
    pub(super) fn drop_hopeless(&self, plans: &mut Vec<Plan>, size: usize) {
        let best = self
            .fits
            .iter()
            .map(|f| f.objective + thresholds::EFFECT_COST * f.effects.len() as f64)
            .fold(f64::INFINITY, f64::min);
        let found = &self.fits;
        plans.retain(|plan| {
            let entries = plan.entries();
            // Worse than a part of it that leaves noise only: the part is the better base for the same set.
            let worse = found.iter().any(|f| {
                f.effects.len() < size
                    && f.objective < plan.predicted
                    && self.is_noise(f)
                    && f.effects.iter().all(|e| entries.contains(&e.entry))
            });
            !worse
                && plan.predicted - thresholds::GAIN_SLACK * plan.predicted_gain.gain
                    + thresholds::EFFECT_COST * (size as f64)
                    < best + thresholds::COMPETING
        });
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
            if kept.len() < BASES || of_kind[kind] < 2 {
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
pub(super) struct Plan {
    pub(super) predicted: f64,
    pub(super) base: Rc<Base>,
    pub(super) predicted_gain: PredictedGain,
}

impl Plan {
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

    /// Whether the base holds an effect of the same name.
    pub(super) fn repeats(&self) -> bool {
        let name = library()[self.predicted_gain.entry].entry().id;
        let mut there = self.base.fit.effects.iter();
        there.any(|e| e.effect.entry().id == name)
    }
}

/// Places in the library of the effects of a set, ascending.
pub(super) fn entries(fit: &Fit) -> Vec<usize> {
    let mut entries: Vec<usize> = fit.effects.iter().map(|e| e.entry).collect();
    entries.sort_unstable();
    entries
}

/// The candidates of the largest predicted gains, overall and in each group.
pub(super) fn chosen(
    predicted: &[PredictedGain],
    overall: usize,
    per_group: usize,
    floor: f64,
) -> Vec<PredictedGain> {
    let mut counts = [0; 3];
    let mut list = Vec::new();
    for (rank, predicted_gain) in predicted.iter().enumerate() {
        let count = &mut counts[predicted_gain.group];
        let in_group = *count < per_group && predicted_gain.gain > thresholds::WORTH_REFINING;
        if (predicted_gain.gain > floor && rank < overall) || in_group {
            *count += 1;
            list.push(predicted_gain.clone());
        }
    }
    list
}
