//! Harmonics above those that are reported: are they noise to this instrument?

use super::evaluation::Evaluation;
use super::problem::Problem;
use crate::model::prediction::Prediction;
use crate::observable::{Channel, Observable};

/// Noise with the harmonics above 5 in it, for all rows at once.
///
/// "What is left" after harmonics 2..5 holds the higher ones; an instrument
/// that takes its noise between the harmonics leaves them out. It is one or the
/// other for a whole dataset, so the better of the two speaks.
///
/// All of them, as one that samples counts them: those beyond half its rate are folded
/// back. Or roughly as many, where filters or a finite sum keep some out.
#[derive(Default)]
pub(super) struct Remainders {
    all: Counted,
    roughly: Counted,
}

/// The noise as one way of counting has it, and what the dataset gains by it.
#[derive(Default)]
struct Counted {
    data: Vec<(usize, f64, f64)>,
    gain: f64,
}

impl Counted {
    /// Takes the difference of one value, with a variance that stays open, in the place of what
    /// `without` the higher harmonics costs.
    fn add(&mut self, problem: &Problem, at: usize, difference: f64, open: f64, without: f64) {
        let u = problem.uncertainty(at);
        let ratio = 1.0 + open / (u * u);
        let weight = 1.0 / (u * ratio.sqrt());
        self.data.push((at, difference * weight, weight));
        self.gain += without - ((difference * weight).powi(2) + ratio.ln());
    }
}

impl Remainders {
    /// Noise with the harmonics above 5 in it.
    pub(super) fn compare(
        &mut self,
        problem: &Problem,
        index: usize,
        prediction: &Prediction,
        evaluation: &Evaluation,
    ) {
        for (channel, of) in Channel::BOTH.into_iter().enumerate() {
            let observable = Observable::noise(of);
            let power = prediction.noise_power_v2[channel];
            let added = prediction.remainder_v2[channel];
            if power <= 0.0 || added <= 1e-9 * power {
                continue;
            }
            let Some(at) = problem.datum(index, observable) else {
                continue;
            };
            let rise = 0.5 * (1.0 + added / power).ln();
            let difference = problem.measured[at] - prediction.value[observable] - rise;
            let open = prediction.open[observable];
            let widened = |share: f64| open + (share * rise).powi(2);
            let carried = widened(prediction.remainder_carried[channel]);
            let rough = widened(prediction.remainder_open[channel]);
            let narrowed = (problem.uncertainty(at) * evaluation.weight[at]).powi(2);
            let without = evaluation.residual[at].powi(2) + (1.0 / narrowed).ln();
            self.all.add(problem, at, difference, carried, without);
            self.roughly.add(problem, at, difference, rough, without);
        }
    }

    /// Takes the higher harmonics into the noise if the whole dataset gains by it.
    pub(super) fn settle(self, evaluation: &mut Evaluation) {
        let better = if self.all.gain > self.roughly.gain {
            self.all
        } else {
            self.roughly
        };
        if better.gain > 0.0 {
            for (at, residual, weight) in better.data {
                evaluation.residual[at] = residual;
                evaluation.weight[at] = weight;
            }
            evaluation.objective -= better.gain;
        }
    }
}
