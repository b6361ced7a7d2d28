//! The problem linearised at a fit: slopes against nuisances and parameters.

use super::aside::{bent_columns, parameter_column};
use super::column::Column;
use super::evaluation::{Evaluation, Responses};
use super::fit::{Fit, Workspace};
use super::normal::{Tangent, damped_step, gram};
use super::nuisance_columns::nuisance_columns;
use super::problem::Problem;
use super::slopes::Slopes;
use nalgebra::{DMatrix, DVector};

/// The problem linearised at a fit.
pub(crate) struct Linearised {
    pub(crate) evaluation: Evaluation,
    pub(crate) columns: Vec<Column>,
    pub(crate) prior: Vec<f64>,
    theta: Vec<f64>,
}

impl Linearised {
    pub(crate) fn new(problem: &Problem, fit: &Fit, work: &mut Workspace) -> Self {
        Self::with(problem, fit, None, work)
    }

    /// The same with earlier slopes, where new ones are expensive.
    pub(super) fn with(
        problem: &Problem,
        fit: &Fit,
        lagging: Option<&Slopes>,
        work: &mut Workspace,
    ) -> Self {
        let found = problem.respond(&fit.effects, &fit.theta, &mut work.memory);
        Self::at(problem, fit, found, lagging, work)
    }

    /// The same where the fit has been evaluated.
    pub(super) fn at(
        problem: &Problem,
        fit: &Fit,
        (evaluation, responses): (Evaluation, Responses),
        lagging: Option<&Slopes>,
        work: &Workspace,
    ) -> Self {
        let bent = fit.effects.iter().any(|e| e.effect.bends());
        let lagging = lagging.filter(|_| bent);
        let earlier = |index: usize| lagging.and_then(|s| s.column(problem, index, &evaluation));
        let mut columns = nuisance_columns(problem, &evaluation, &responses, &fit.theta);
        if bent && lagging.is_none() {
            bent_columns(problem, fit, &evaluation, &mut columns, work);
        }
        for (index, column) in columns.iter_mut().enumerate() {
            if let Some(earlier) = earlier(index) {
                *column = earlier;
            }
        }
        for (at, active) in fit.effects.iter().enumerate() {
            for index in 0..active.parameters.len() {
                let column = earlier(columns.len());
                let fresh = || parameter_column(problem, fit, (at, index), &evaluation, work);
                columns.push(column.unwrap_or_else(fresh));
            }
        }
        let bounded = problem.free.iter().map(|f| f64::from(u8::from(f.bounded)));
        let mut prior: Vec<f64> = bounded.collect();
        prior.resize(columns.len(), 0.0);
        Self {
            evaluation,
            columns,
            prior,
            theta: fit.theta.clone(),
        }
    }

    /// The normal equations of the next step.
    pub(super) fn equations(&self, problem: &Problem) -> Equations {
        let nuisances = self.theta.len();
        let mut gradient = DVector::zeros(self.columns.len());
        for (i, column) in self.columns.iter().enumerate() {
            gradient[i] = column.dot_data(problem, &self.evaluation.residual);
            if i < nuisances {
                gradient[i] -= self.prior[i] * self.theta[i];
            }
        }
        Equations {
            matrix: gram(&self.columns, &self.prior),
            gradient,
        }
    }

    /// The slopes against nuisances and parameters.
    pub(crate) fn all_slopes(self) -> Slopes {
        Slopes::new(self.columns, self.evaluation.weight)
    }

    /// The slopes against the nuisances alone.
    pub(super) fn nuisance_slopes(self) -> Slopes {
        let mut columns = self.columns;
        columns.truncate(self.theta.len());
        Slopes::new(columns, self.evaluation.weight)
    }

    /// The tangent space here, priors included.
    pub(crate) fn tangent(self) -> Option<(Evaluation, Tangent)> {
        let tangent = Tangent::new(self.columns, &self.prior)?;
        Some((self.evaluation, tangent))
    }
}

/// Normal equations of a fit, for steps of any damping.
pub(super) struct Equations {
    matrix: DMatrix<f64>,
    gradient: DVector<f64>,
}

impl Equations {
    pub(super) fn step(&self, damping: f64) -> Option<DVector<f64>> {
        damped_step(&self.matrix, &self.gradient, damping)
    }
}
