//! The problem linearised at a fit: slopes against nuisances and parameters.

use super::column::Column;
use super::evaluation::{Evaluation, Responses};
use super::fit::{Fit, Workspace};
use super::normal::{Tangent, gram};
use super::nuisance::Nuisance;
use super::nuisance_columns::nuisance_columns;
use super::problem::Problem;
use super::response::response_change;
use super::slopes::Slopes;
use crate::effects::{Active, Scale};
use crate::model::row::RATIO;
use nalgebra::{Cholesky, DMatrix, DVector};

/// Change of all data, in standard deviations, that a small step of a parameter must exceed.
const STANDS_STILL: f64 = 1e-9;

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
        let mut matrix = self.matrix.clone();
        for i in 0..matrix.nrows() {
            matrix[(i, i)] *= 1.0 + damping;
        }
        Some(Cholesky::new(matrix)?.solve(&self.gradient))
    }
}

/// Slope against one parameter of one effect.
fn parameter_column(
    problem: &Problem,
    fit: &Fit,
    (at, index): (usize, usize),
    here: &Evaluation,
    work: &Workspace,
) -> Column {
    let active = &fit.effects[at];
    let (value, step) = nudged(active, index);
    let mut there = active.clone();
    there.parameters[index] = value;
    let slope = if acts_alone(fit, at) {
        let mut change = response_change(problem, active, &there, &here.weight);
        change.scale(1.0 / step);
        change
    } else {
        let mut effects = fit.effects.clone();
        effects[at] = there;
        let there = problem.evaluate_aside(&effects, &fit.theta, &work.memory);
        column(problem, here, &there, step)
    };
    // What only rounding moves would be moved without bounds.
    let moves = slope.norm2() * step * step > STANDS_STILL * STANDS_STILL;
    if moves { slope } else { Column::default() }
}

/// Whether an effect just multiplies responses, and no other one of the set makes harmonics.
fn acts_alone(fit: &Fit, at: usize) -> bool {
    fit.effects[at].effect.is_linear() && !fit.effects.iter().any(|e| e.effect.distorts())
}

/// Slopes against exciter and level where the exciter is nonlinear: its
/// harmonics depend on them too, and on more than the linear response does.
fn bent_columns(
    problem: &Problem,
    fit: &Fit,
    evaluation: &Evaluation,
    columns: &mut [Column],
    work: &Workspace,
) {
    const STEP: f64 = 0.01;
    let aside = |index: usize| {
        let mut theta = fit.theta.clone();
        theta[index] += STEP;
        let there = problem.evaluate_aside(&fit.effects, &theta, &work.memory);
        column(problem, evaluation, &there, STEP)
    };
    let mut level = None;
    for (index, free) in problem.free.iter().enumerate() {
        if matches!(free.kind, Nuisance::Exciter(_) | Nuisance::DriveGain) {
            columns[index] = aside(index);
        }
        if free.kind == Nuisance::DriveGain && free.bounded {
            level = Some(index);
        }
    }
    if !fit.effects.iter().any(|e| e.effect.saturates()) {
        return;
    }
    for (index, free) in problem.free.iter().enumerate() {
        let Nuisance::RunReference(run) = free.kind else {
            continue;
        };
        let Some(level) = level else {
            columns[index] = aside(index);
            continue;
        };
        // The level of a run moves as all levels do, and the ratio the other way.
        let mut of_run = columns[level].only(problem, |row| row.run == run);
        of_run.scale(free.unit / problem.free[level].unit);
        for (slot, values) in std::mem::take(&mut columns[index].parts) {
            if slot == RATIO {
                of_run.add_part(slot, values);
            }
        }
        columns[index] = of_run;
    }
}

/// Slope of the weighted prediction from two evaluations; weights are those of the first.
fn column(problem: &Problem, here: &Evaluation, there: &Evaluation, step: f64) -> Column {
    let residual: Vec<f64> = there
        .residual
        .iter()
        .zip(&there.weight)
        .zip(&here.weight)
        .map(|((r, wt), wh)| r / wt * wh)
        .collect();
    let mut column = Column::difference(problem, &residual, &here.residual, 1.0 / step);
    for (slot, values) in &mut column.parts {
        if super::problem::is_phase(*slot) {
            // A phase that crossed half a turn between the two evaluations carries no slope.
            values
                .iter_mut()
                .filter(|v| (v.abs() * step) > 1.0 / 1e-3)
                .for_each(|v| *v = 0.0);
        }
    }
    column
}

/// A parameter moved by a small step, and that step in internal units.
fn nudged(active: &Active<'_>, index: usize) -> (f64, f64) {
    let parameter = active.effect.about().parameters[index];
    let value = active.parameters[index];
    let (there, step) = match parameter.scale {
        Scale::Log => (value * 1.0005, 0.0005_f64.ln_1p()),
        Scale::Linear => {
            let unit = active.unit[index];
            let size = 1e-4 * value.abs().max(unit);
            (value + size, size / unit)
        }
    };
    if there > parameter.upper {
        match parameter.scale {
            Scale::Log => (value / 1.0005, -step),
            Scale::Linear => (value - step * active.unit[index], -step),
        }
    } else {
        (there, step)
    }
}
