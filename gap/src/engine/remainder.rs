//! Harmonics above those that are reported: are they noise to this instrument?

use super::evaluation::Evaluation;
use super::problem::Problem;
use crate::model::predict::Prediction;
use crate::model::row::NOISE;

/// Noise with the harmonics above 5 in it, for all rows at once.
///
/// "What is left" after harmonics 2..5 holds the higher ones; an instrument
/// that takes its noise between the harmonics leaves them out. It is one or the
/// other for a whole dataset, so the better of the two speaks.
#[derive(Default)]
pub(super) struct Remainders {
    data: Vec<(usize, f64, f64)>,
    gain: f64,
}

impl Remainders {
    /// What the noise would be with the harmonics above 5 in it.
    pub(super) fn compare(
        &mut self,
        problem: &Problem,
        index: usize,
        prediction: &Prediction,
        evaluation: &Evaluation,
    ) {
        for channel in 0..2 {
            let power = prediction.noise_power_v2[channel];
            let added = prediction.remainder_v2[channel];
            if power <= 0.0 || added <= 1e-9 * power {
                continue;
            }
            let Some(at) = problem.datum(index, NOISE + channel) else {
                continue;
            };
            let rise = 0.5 * (1.0 + added / power).ln();
            let difference = problem.measured[at] - prediction.value[NOISE + channel] - rise;
            let open = prediction.open[NOISE + channel]
                + (prediction.remainder_open[channel] * rise).powi(2);
            let u = problem.uncertainty(at);
            let ratio = 1.0 + open / (u * u);
            let weight = 1.0 / (u * ratio.sqrt());
            let before = evaluation.residual[at];
            let plain = 1.0 / (u * evaluation.weight[at]).powi(2);
            self.data.push((at, difference * weight, weight));
            self.gain += before * before + plain.ln() - (difference * weight).powi(2) - ratio.ln();
        }
    }

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
