//! Harmonics above those that are reported: are they noise to this instrument?

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
