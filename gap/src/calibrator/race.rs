//! Refinement of a proposed set: a few steps, and all of them where it is within reach.

use super::candidate::{PredictedGain, active};
use super::fit::{Fit, Workspace};
use super::found::{Extension, Found};
use super::problem::Problem;
use super::refine::{FULL, moved, refine, refine_with};
use crate::effects::library;
use crate::estimation::descent::Effort;
use crate::model::effect::Active;

/// Refines a proposed set and keeps what it finds; `nominal` is the objective without effects.
pub(super) fn race(
    problem: &Problem,
    extension: &Extension,
    nominal: f64,
    found: &mut Found<'_>,
    work: &mut Workspace,
) {
    let size = extension.base.fit.effects.len() + 1;
    let within = found.within_reach(size, nominal, extension.scatters());
    let effort = Effort { within, ..FULL };
    found.keep(refined(problem, extension, effort, work));
}

/// The set from where the screening expects it.
fn refined(problem: &Problem, extension: &Extension, effort: Effort, work: &mut Workspace) -> Fit {
    let predicted_gain = &extension.predicted_gain;
    let base = shifted(problem, &extension.base.fit, predicted_gain, work);
    let effect = library()[predicted_gain.entry];
    // A second bend changes the slopes of the first.
    let slopes = extension
        .base
        .slopes
        .as_ref()
        .filter(|_| !effect.makes_nonlinear());
    let effects = with(
        &base,
        predicted_gain.entry,
        predicted_gain.parameters.clone(),
    );
    let theta = base.theta.clone();
    let fit = refine_with(problem, effects, theta, slopes, effort, work);
    if effect.makes_nonlinear() && base.effects.is_empty() {
        of_other_size(problem, predicted_gain.entry, fit, effort, work)
    } else {
        fit
    }
}

/// The screening of a bent exciter is linear in its size: tries the other sizes too.
fn of_other_size(
    problem: &Problem,
    entry: usize,
    mut fit: Fit,
    effort: Effort,
    work: &mut Workspace,
) -> Fit {
    let starts = library()[entry].starts(&problem.facts);
    for start in starts.into_iter().skip(1) {
        let other = vec![active(entry, start.members[0].clone())];
        let there = problem.evaluate(&other, &fit.theta, &mut work.memory);
        if there.objective < fit.objective {
            let theta = fit.theta.clone();
            let again = refine(problem, other, theta, effort, work);
            if again.objective < fit.objective {
                fit = again;
            }
        }
    }
    fit
}

/// The base moved to where the screening expects it beside the new effect, if that is an improvement.
fn shifted(
    problem: &Problem,
    base: &Fit,
    predicted_gain: &PredictedGain,
    work: &mut Workspace,
) -> Fit {
    let there = match &predicted_gain.shift {
        Some(shift) => moved(problem, base, shift),
        None => Fit {
            theta: problem.stated_noise(&base.theta),
            ..base.clone()
        },
    };
    let mut objective = |base: &Fit| {
        let effects = with(
            base,
            predicted_gain.entry,
            predicted_gain.parameters.clone(),
        );
        let found = problem.evaluate(&effects, &base.theta, &mut work.memory);
        found.objective
    };
    if objective(&there) < objective(base) {
        there
    } else {
        base.clone()
    }
}

/// The effects of a set and one more.
fn with(base: &Fit, entry: usize, parameters: Vec<f64>) -> Vec<Active<'static>> {
    let mut effects = base.effects.clone();
    effects.push(active(entry, parameters));
    effects
}
