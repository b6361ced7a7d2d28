//! Compares simulation and measurement, row by row.

use super::evaluation::{Evaluation, Responses};
use super::nuisance::Nuisance;
use super::problem::{Problem, wrapped};
use super::remainder::Remainders;
use crate::model::effect::Active;
use crate::model::memory::{Memory, Recall};
use crate::model::predict::predict;
use crate::model::prediction::{Nominal, Prediction};
use crate::observable::Observable;

/// Memory of all rows, as an evaluation uses it.
pub(crate) enum Memories<'a> {
    Keep(&'a mut [Memory]),
    Look(&'a [Memory]),
}

impl Memories<'_> {
    fn of(&mut self, row: usize) -> Recall<'_> {
        match self {
            Self::Keep(memory) => Recall::Keep(&mut memory[row]),
            Self::Look(memory) => Recall::Look(&memory[row]),
        }
    }
}

impl Problem {
    pub(super) fn nominal(&self, theta: &[f64]) -> Nominal {
        let mut nominal = self.base.clone();
        for (free, &value) in self.free.iter().zip(theta) {
            let change = value * free.unit;
            match free.kind {
                Nuisance::RatioGain => {
                    nominal.ratio_ln += change;
                    nominal.dut_gain *= change.exp();
                }
                Nuisance::DriveGain => {
                    nominal.drive_ln += change;
                    if free.bounded {
                        nominal.reference_gain *= change.exp();
                    }
                }
                Nuisance::Exciter(parameter) => {
                    if let Some(exciter) = nominal.exciter.as_mut() {
                        exciter[parameter] = self.exciter_value(parameter, value);
                    }
                }
                Nuisance::Noise(channel) => {
                    let channel = channel as usize;
                    nominal.noise_v[channel] *= change.exp();
                    nominal.noise_ln[channel] = nominal.noise_v[channel].ln();
                }
                Nuisance::RunReference(_) | Nuisance::RunDut(_) => {}
            }
        }
        nominal
    }

    /// Added to ln ratio and ln drive by the gains of each run.
    fn run_gains(&self, theta: &[f64]) -> Vec<[f64; 2]> {
        let runs = self.rows.iter().map(|r| r.run).max().unwrap_or(0) + 1;
        let mut gains = vec![[0.0; 2]; runs];
        for (free, &value) in self.free.iter().zip(theta) {
            match free.kind {
                Nuisance::RunReference(run) => {
                    gains[run][0] -= value * free.unit;
                    gains[run][1] += value * free.unit;
                }
                Nuisance::RunDut(run) => gains[run][0] += value * free.unit,
                _ => {}
            }
        }
        gains
    }

    /// Calls `visit(row, prediction)` for every row.
    pub(crate) fn predictions(
        &self,
        effects: &[Active<'_>],
        theta: &[f64],
        memory: Memories<'_>,
        mut visit: impl FnMut(usize, &Prediction),
    ) {
        let mut memory = memory;
        let nominal = self.nominal(theta);
        let gains = self.run_gains(theta);
        // The reference holds the level, with its gain in each run.
        let of_run: Vec<Nominal> = gains
            .iter()
            .map(|g| Nominal {
                reference_gain: nominal.reference_gain * g[1].exp(),
                ..nominal.clone()
            })
            .collect();
        for (index, row) in self.rows.iter().enumerate() {
            let mut prediction = predict(row, &of_run[row.run], effects, memory.of(index));
            prediction.value[Observable::Ratio] += gains[row.run][0];
            prediction.value[Observable::Drive] += gains[row.run][1];
            visit(index, &prediction);
        }
    }

    /// Compares simulation and measurement.
    pub(crate) fn evaluate(
        &self,
        effects: &[Active<'_>],
        theta: &[f64],
        memory: &mut [Memory],
    ) -> Evaluation {
        self.evaluate_with(effects, theta, Memories::Keep(memory), |_| {})
    }

    /// Evaluates a small step: starts from the memory and leaves it as it is.
    pub(crate) fn evaluate_beside(
        &self,
        effects: &[Active<'_>],
        theta: &[f64],
        memory: &[Memory],
    ) -> Evaluation {
        self.evaluate_with(effects, theta, Memories::Look(memory), |_| {})
    }

    /// Evaluates, and keeps the values the slopes against the nuisances need.
    pub(super) fn respond(
        &self,
        effects: &[Active<'_>],
        theta: &[f64],
        memory: &mut [Memory],
    ) -> (Evaluation, Responses) {
        let mut responses = Responses::default();
        let evaluation = self.evaluate_with(effects, theta, Memories::Keep(memory), |row| {
            responses.exciter.push(row.slopes);
            responses.noise_share.push(row.noise_share);
        });
        (evaluation, responses)
    }

    fn evaluate_with(
        &self,
        effects: &[Active<'_>],
        theta: &[f64],
        memory: Memories<'_>,
        mut visit: impl FnMut(&Prediction),
    ) -> Evaluation {
        let mut evaluation = Evaluation {
            residual: vec![0.0; self.len()],
            weight: self.stated_weight.clone(),
            objective: self.prior(theta),
            diverged: 0,
        };
        let mut remainders = Remainders::default();
        self.predictions(effects, theta, memory, |index, prediction| {
            evaluation.diverged += usize::from(prediction.diverged);
            self.compare(index, prediction, &mut evaluation);
            remainders.compare(self, index, prediction, &evaluation);
            visit(prediction);
        });
        remainders.settle(&mut evaluation);
        // A balance that fails on many rows is no description of them.
        evaluation.objective += 1e3 * evaluation.diverged as f64;
        if !evaluation.objective.is_finite() {
            evaluation.objective = f64::MAX;
        }
        evaluation
    }

    /// Nuisance values with the noise of healthy channels at its stated value: a fit
    /// without an effect that makes noise has stretched it.
    pub(crate) fn stated_noise(&self, theta: &[f64]) -> Vec<f64> {
        let relaxed = self.free.iter().zip(theta).map(|(free, value)| {
            if matches!(free.kind, Nuisance::Noise(_)) {
                0.0
            } else {
                *value
            }
        });
        relaxed.collect()
    }

    fn prior(&self, theta: &[f64]) -> f64 {
        self.free
            .iter()
            .zip(theta)
            .filter(|(f, _)| f.bounded)
            .map(|(_, t)| t * t)
            .sum()
    }

    fn compare(&self, index: usize, prediction: &Prediction, evaluation: &mut Evaluation) {
        for datum in self.of_row(index) {
            let (observable, at) = (datum.observable, datum.at);
            let mut difference = datum.measured - prediction.value[observable];
            if observable.is_phase() {
                difference = wrapped(difference);
            }
            let open = prediction.open[observable];
            if open > 0.0 {
                let ratio = 1.0 + open * self.stated_weight[at].powi(2);
                evaluation.objective += ratio.ln();
                evaluation.weight[at] = self.stated_weight[at] / ratio.sqrt();
            }
            let residual = difference * evaluation.weight[at];
            evaluation.residual[at] = residual;
            evaluation.objective += residual * residual;
        }
    }
}
