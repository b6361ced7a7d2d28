//! Simulation and measurement compared.

use super::problem::{Problem, wrapped};
use crate::model::exciter::ExciterSlopes;

/// State of the simulation for one set of effects and nuisance values.
#[derive(Debug, Clone)]
pub(crate) struct Evaluation {
    /// (measured - simulated)/u.
    pub(crate) residual: Vec<f64>,
    /// 1/u, lowered where an effect leaves scatter open.
    pub(crate) weight: Vec<f64>,
    /// Sum of squares, priors and the logarithm of widened uncertainties: -2 ln posterior.
    pub(crate) objective: f64,
    /// Rows whose balance was not reached.
    pub(crate) diverged: usize,
}

impl Evaluation {
    /// Logarithms of the variances, up to a constant.
    pub(super) fn variance_ln(&self) -> Vec<f64> {
        self.weight.iter().map(|w| -2.0 * w.ln()).collect()
    }

    /// The residual with the weights of another evaluation.
    pub(super) fn residual_as_weighted_by(&self, other: &Self) -> Vec<f64> {
        let weights = self.weight.iter().zip(&other.weight);
        let reweighed = self.residual.iter().zip(weights);
        reweighed
            .map(|(r, (own, others))| r / own * others)
            .collect()
    }
}

/// Values of each row that the slopes against the nuisances need.
#[derive(Debug, Clone, Default)]
pub(crate) struct Responses {
    /// Slopes of drive and current against the values of the exciter.
    pub(super) exciter: Vec<Option<ExciterSlopes>>,
    /// Share of the healthy noise in the noise of each channel.
    pub(super) noise_share: Vec<[f64; 2]>,
}

/// Change of the weighted residual between two evaluations, weights of the first.
pub(crate) fn difference(problem: &Problem, here: &Evaluation, there: &Evaluation) -> Vec<f64> {
    let mut changes = Vec::with_capacity(problem.len());
    for (observable, data) in problem.measured_observables() {
        changes.extend(data.map(|at| {
            let mut change =
                here.residual[at] / here.weight[at] - there.residual[at] / there.weight[at];
            if observable.is_phase() {
                change = wrapped(change);
            }
            change * here.weight[at]
        }));
    }
    changes
}
