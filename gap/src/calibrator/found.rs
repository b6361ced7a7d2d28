//! The sets that were refined, and what they say about others.

use super::fit::Fit;
use super::problem::Problem;
use super::proposal::{Plan, entries};
use crate::effects::Shows;
use crate::thresholds;

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

    /// Whether the best set of a size leaves noise, or little of what the best below it leaves beyond
    /// that. Where one more effect does not, none is the one that lacks.
    pub(super) fn closes(&self, size: usize) -> bool {
        let count = self.problem.len() as f64;
        let beyond = |size| {
            let leader = self.leader(size);
            leader.map_or(f64::INFINITY, |fit| fit.objective - count)
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
