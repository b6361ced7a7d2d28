//! Refinement of a set of effects: damped Gauss-Newton on the posterior.

use super::fit::{Fit, Workspace};
use super::higher::higher_harmonics;
use super::linear::Linearised;
use super::polish::polish;
use super::problem::Problem;
use super::slopes::Slopes;
use super::step::{clamp, moved};
use crate::effects::Active;

/// How far a refinement goes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Effort {
    pub(crate) most_steps: usize,
    /// Gain of the objective below which it stops.
    pub(crate) enough: f64,
}

impl Effort {
    pub(crate) const FULL: Self = Self {
        most_steps: 25,
        enough: 1e-2,
    };
    /// Enough to see whether a set is within reach of the best.
    pub(crate) const GLANCE: Self = Self {
        most_steps: 5,
        enough: 1.0,
    };
}

/// Refines effects and nuisances from a start.
pub(crate) fn refine(
    problem: &Problem,
    effects: Vec<Active<'static>>,
    theta: Vec<f64>,
    effort: Effort,
    work: &mut Workspace,
) -> Fit {
    refine_with(problem, effects, theta, None, effort, work)
}

/// The same; the first step takes the slopes that are known of part of the set.
pub(crate) fn refine_with(
    problem: &Problem,
    effects: Vec<Active<'static>>,
    theta: Vec<f64>,
    slopes: Option<&Slopes>,
    effort: Effort,
    work: &mut Workspace,
) -> Fit {
    let mut fit = Fit {
        effects,
        theta,
        objective: f64::INFINITY,
    };
    clamp(&mut fit.effects);
    descend(problem, &mut fit, slopes, effort, work);
    unstretch(problem, &mut fit, effort, work);
    if fit.effects.iter().any(|e| e.effect.opens()) {
        // Slopes see the mean, the search sees the scatter: each moves the other's optimum.
        let rounds = if effort.most_steps < Effort::FULL.most_steps {
            1
        } else {
            3
        };
        for round in 0..rounds {
            let before = fit.objective;
            polish(problem, &mut fit, round, work);
            descend(problem, &mut fit, None, effort, work);
            if before - fit.objective < 0.1 {
                break;
            }
        }
    }
    fit
}

/// Noise beyond this many of its standard uncertainties is stretched.
const STRETCHED: f64 = 3.0;

/// Puts stretched noise back where it is stated, if the search then describes the data better.
///
/// Higher harmonics count as noise or do not, for a whole dataset. A start from a set without them
/// has stretched the noise in their place, and at that noise they are better not counted.
fn unstretch(problem: &Problem, fit: &mut Fit, effort: Effort, work: &mut Workspace) {
    let stated = problem.stated_noise(&fit.theta);
    let mut moved = stated.iter().zip(&fit.theta);
    if !moved.any(|(to, from)| (to - from).abs() > STRETCHED)
        || higher_harmonics(problem, fit, work).is_none()
    {
        return;
    }
    let mut other = Fit {
        theta: stated,
        ..fit.clone()
    };
    descend(problem, &mut other, None, effort, work);
    if other.objective < fit.objective {
        *fit = other;
    }
}

/// Moves a fit to its optimum on a similar problem: by slopes alone.
pub(crate) fn follow(
    problem: &Problem,
    mut fit: Fit,
    slopes: &Slopes,
    effort: Effort,
    work: &mut Workspace,
) -> Fit {
    descend(problem, &mut fit, Some(slopes), effort, work);
    fit
}

/// Accepted steps between renewals of the slopes of a nonlinear exciter.
const RENEWAL: usize = 4;

/// Damped Gauss-Newton steps until the objective stands still.
fn descend(
    problem: &Problem,
    fit: &mut Fit,
    slopes: Option<&Slopes>,
    effort: Effort,
    work: &mut Workspace,
) {
    let mut damping = 1e-4;
    let mut linear = Linearised::with(problem, fit, slopes, work);
    fit.objective = linear.evaluation.objective;
    let mut equations = linear.equations(problem);
    let (mut small, mut accepted) = (0, 0);
    for _ in 0..effort.most_steps {
        let Some(step) = equations.step(damping) else {
            damping *= 10.0;
            continue;
        };
        let trial = moved(problem, fit, &step);
        let found = problem.respond(&trial.effects, &trial.theta, &mut work.memory);
        let objective = found.0.objective;
        let gain = fit.objective - objective;
        if gain > 0.0 {
            *fit = Fit { objective, ..trial };
            damping = (damping * 0.1).max(1e-9);
            small = if gain < effort.enough { small + 1 } else { 0 };
            if small == 2 {
                break;
            }
            accepted += 1;
            let lagging = (accepted % RENEWAL != 0).then(|| linear.nuisance_slopes());
            linear = Linearised::at(problem, fit, found, lagging.as_ref(), work);
            equations = linear.equations(problem);
        } else {
            if damping > 1e6 {
                break;
            }
            damping *= if damping < 1e-2 { 100.0 } else { 10.0 };
        }
    }
}
