//! Sums over noise: what a fit of effects that only scatter needs.

use super::problem::Evaluation;

/// Noise with the harmonics above 5 in it, for all rows at once.
///
/// "What is left" after harmonics 2..5 holds the higher ones; an instrument
/// that takes its noise between the harmonics leaves them out. It is one or the
/// other for a whole dataset, so the better of the two speaks.
#[derive(Default)]
pub(super) struct Remainders {
    pub(super) data: Vec<(usize, f64, f64)>,
    pub(super) gain: f64,
}

impl Remainders {
    /// Takes the higher harmonics into the noise if the whole dataset gains by it.
    pub(super) fn settle(self, evaluation: &mut Evaluation) {
        if self.gain > 0.0 {
            for (at, residual, weight) in self.data {
                evaluation.residual[at] = residual;
                evaluation.weight[at] = weight;
            }
            evaluation.objective -= self.gain;
        }
    }
}

/// Sums over the noise of one channel, from which its healthy noise is fitted.
#[derive(Clone, Copy, Default)]
pub(super) struct NoiseSum {
    square: f64,
    mixed: f64,
    share: f64,
    widened: f64,
}

impl NoiseSum {
    /// One more datum.
    pub(super) fn add(&mut self, difference: f64, share: f64, weight: f64, open: f64) {
        let ratio = 1.0 + open * weight * weight;
        let w2 = weight * weight / ratio;
        self.square += difference * difference * w2;
        self.mixed += difference * share * w2;
        self.share += share * share * w2;
        self.widened += ratio.ln();
    }

    /// Least sum of squares over the healthy noise with its prior of one unit.
    pub(super) fn least(&self, unit: f64) -> f64 {
        self.square + self.widened - (unit * self.mixed).powi(2) / (1.0 + unit * unit * self.share)
    }
}
