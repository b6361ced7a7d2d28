//! Slopes by a small step: what the closed forms for a linear row do not know.

use super::closed_form::response_change;
use super::evaluation::Evaluation;
use super::fit::{Fit, Workspace};
use super::nuisance::Nuisance;
use super::problem::{Column, Problem};
use crate::model::effect::Active;
use crate::observable::Observable;
use crate::thresholds;
use calib_effects::Scale;

/// Slopes of data, and of the logarithm of their variance where an effect leaves part of it open.
pub(super) struct ParameterSlopes {
    pub(super) data: Column,
    pub(super) variance: Column,
}

/// Slopes against one parameter of one effect.
pub(super) fn parameter_slopes(
    problem: &Problem,
    fit: &Fit,
    (at, index): (usize, usize),
    here: &Evaluation,
    work: &Workspace,
) -> ParameterSlopes {
    let active = &fit.effects[at];
    let (value, step) = nudged(active, index);
    let mut there = active.clone();
    there.parameters[index] = value;
    let mut variance = Column::default();
    let slope = if acts_alone(fit, at) {
        let mut change = response_change(problem, active, &there, &here.weight);
        change.scale(1.0 / step);
        change
    } else {
        let mut effects = fit.effects.clone();
        effects[at] = there;
        let there = problem.evaluate_beside(&effects, &fit.theta, &work.memory);
        if here.weight != there.weight {
            let logarithms = [here, &there].map(Evaluation::variance_ln);
            let [here, there] = &logarithms;
            variance = Column::difference(problem, here, there, 1.0 / step);
        }
        column(problem, here, &there, step)
    };
    // What only rounding moves would be moved without bounds.
    let moves = slope.norm2() * step * step > thresholds::STANDS_STILL * thresholds::STANDS_STILL;
    let data = if moves { slope } else { Column::default() };
    ParameterSlopes { data, variance }
}

/// Whether an effect just multiplies responses, and no other one of the set makes harmonics.
fn acts_alone(fit: &Fit, at: usize) -> bool {
    fit.effects[at].effect.is_linear() && !fit.effects.iter().any(|e| e.effect.distorts())
}

/// Slopes against exciter and level where the exciter is nonlinear: its
/// harmonics depend on them too, and on more than the linear response does.
pub(super) fn nonlinear_columns(
    problem: &Problem,
    fit: &Fit,
    evaluation: &Evaluation,
    columns: &mut [Column],
    work: &Workspace,
) {
    let finite_difference = |index: usize| {
        let mut theta = fit.theta.clone();
        theta[index] += thresholds::NUISANCE_STEP;
        let there = problem.evaluate_beside(&fit.effects, &theta, &work.memory);
        column(problem, evaluation, &there, thresholds::NUISANCE_STEP)
    };
    let mut level = None;
    for (index, free) in problem.free.iter().enumerate() {
        if matches!(free.kind, Nuisance::Exciter(_) | Nuisance::DriveGain) {
            columns[index] = finite_difference(index);
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
        columns[index] = match level {
            Some(level) => {
                let units = free.unit / problem.free[level].unit;
                of_run(problem, &columns[level], &columns[index], run, units)
            }
            None => finite_difference(index),
        };
    }
}

/// The level of a run moves as all levels do, times `units`, and the ratio the other way, as before.
fn of_run(problem: &Problem, level: &Column, before: &Column, run: usize, units: f64) -> Column {
    let mut of_run = level.clone();
    for (observable, values) in &mut of_run.parts {
        let rows = &problem.row_of[problem.data_of(*observable)];
        for (value, row) in values.iter_mut().zip(rows) {
            *value *= f64::from(u8::from(problem.rows[*row].run == run));
        }
    }
    of_run.scale(units);
    let ratio = before.parts.iter();
    for (observable, values) in ratio.filter(|(o, _)| *o == Observable::Ratio) {
        of_run.add_part(*observable, values.clone());
    }
    of_run
}

/// Slope of the weighted prediction from two evaluations; weights are those of the first.
fn column(problem: &Problem, here: &Evaluation, there: &Evaluation, step: f64) -> Column {
    let residual = there.residual_as_weighted_by(here);
    let mut column = Column::difference(problem, &residual, &here.residual, 1.0 / step);
    for (observable, values) in &mut column.parts {
        if observable.is_phase() {
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
    let parameter = active.effect.parameters()[index];
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
