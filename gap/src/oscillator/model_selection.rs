//! How the sets of terms that were tried compare.

use super::answer::term_parameters;
use super::fit::{Fitted, residual};
use super::lack_of_fit::Left;
use super::model::TERMS;
use super::run::Run;
use crate::answer::Cause;
use crate::estimation::selection::{bootstrap, cost_of_cause, cost_of_parameter, probabilities};
use crate::thresholds;
use calib_effects::Of;

/// Sets of one size, and how they compare.
pub(super) struct Tried<'a> {
    sets: &'a [Fitted],
    /// Independent samples.
    samples: f64,
    /// Share by which squared errors may exceed the least and still count as equal.
    tied: f64,
}

/// A set among those of its size.
pub(super) struct Weighed<'a> {
    pub(super) fit: &'a Fitted,
    pub(super) probability: f64,
    /// -2 ln of the posterior probability above that of the best.
    pub(super) above_best: f64,
}

impl<'a> Tried<'a> {
    /// Sets of which the best leaves `left`.
    pub(super) fn new(sets: &'a [Fitted], left: &Left) -> Self {
        let noise = left.leaves_noise();
        Self {
            sets,
            samples: left.independent(left.samples),
            tied: if noise { 0.0 } else { thresholds::AS_GOOD },
        }
    }

    /// The sets, most probable first.
    pub(super) fn weighed(&self) -> Vec<Weighed<'a>> {
        let scores = self.scores(self.sets.iter(), self.sets.iter().map(|f| f.square));
        let least = scores.iter().copied().fold(f64::INFINITY, f64::min);
        let weighed = self.sets.iter().zip(probabilities(&scores)).zip(&scores);
        let mut list: Vec<Weighed<'a>> = weighed
            .map(|((fit, probability), score)| Weighed {
                fit,
                probability,
                above_best: score - least,
            })
            .collect();
        list.sort_by(|a, b| a.above_best.total_cmp(&b.above_best));
        list
    }

    /// -2 ln of the posterior probability of each set with its sum of squared errors.
    fn scores<'f>(
        &self,
        fits: impl Iterator<Item = &'f Fitted>,
        squares: impl Iterator<Item = f64> + Clone,
    ) -> Vec<f64> {
        let least = squares.clone().fold(f64::INFINITY, f64::min);
        let least = least * (1.0 + self.tied);
        let score = |(fit, square): (&Fitted, f64)| {
            let square = square.max(least).max(f64::MIN_POSITIVE);
            self.samples * square.ln() + cost_of_last(fit, self.samples)
        };
        fits.zip(squares).map(score).collect()
    }

    /// Sets that are worth listing. Errors are correlated over a few periods of the resonance: where
    /// samples are drawn again, `stretch` of them come together.
    pub(super) fn causes(&self, part: &Run, stretch: usize) -> Vec<Cause> {
        let mut listed = self.weighed();
        listed.retain(|w| w.probability > thresholds::LISTED_PROBABILITY);
        let squares = listed.iter().map(|w| {
            let left = residual(&w.fit.values, part).unwrap_or_default();
            let stretches = left.chunks_exact(stretch.max(1));
            stretches.map(|s| s.iter().map(|r| r * r).sum()).collect()
        });
        let squares: Vec<Vec<f64>> = squares.collect();
        let stability = bootstrap(&squares, |sums| {
            self.scores(listed.iter().map(|w| w.fit), sums.into_iter())
        });
        let causes = listed.iter().zip(stability);
        causes
            .map(|(set, stability)| Cause {
                effects: names_of(set.fit),
                probability: set.probability,
                delta_bic: set.above_best,
                stability,
                stability_over_runs: None,
                cautions: Vec::new(),
                parameters: term_parameters(set.fit, part.interval_s),
            })
            .map(|cause| cause.with_cautions(Of::Oscillator))
            .collect()
    }
}

/// Cost of the last term of a set, in -2 ln of the posterior probability.
pub(super) fn cost_of_last(fit: &Fitted, samples: f64) -> f64 {
    fit.terms.last().map_or(0.0, |term| {
        let term = &TERMS[*term];
        let odds = if term.leading {
            1.0
        } else {
            thresholds::ODDS_OF_LEADING
        };
        let parameters = cost_of_parameter(samples.max(std::f64::consts::E));
        term.values.len() as f64 * parameters + cost_of_cause(odds * TERMS.len() as f64)
    })
}

/// Names of the terms of a fit.
pub(super) fn names_of(fit: &Fitted) -> Vec<&'static str> {
    fit.terms.iter().map(|t| TERMS[*t].entry.id).collect()
}
