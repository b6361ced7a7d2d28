//! A fit after a step of nuisances and parameters, within physical bounds.

use super::fit::{Fit, Workspace};
use super::problem::Problem;
use crate::effects::Active;
use calib_effects::Scale;
use nalgebra::DVector;

/// A fit after a step in internal units.
pub(crate) fn moved(problem: &Problem, fit: &Fit, step: &DVector<f64>) -> Fit {
    let mut trial = fit.clone();
    let nuisances = problem.free.len();
    for (theta, (free, change)) in trial
        .theta
        .iter_mut()
        .zip(problem.free.iter().zip(step.iter()))
    {
        let longest = free.longest_step();
        *theta += change.clamp(-longest, longest);
    }
    let mut at = nuisances;
    for active in &mut trial.effects {
        let of = active.effect.parameters().iter().zip(&active.unit);
        for (value, (parameter, unit)) in active.parameters.iter_mut().zip(of) {
            match parameter.scale {
                Scale::Log => *value *= step[at].clamp(-1.0, 1.0).exp(),
                Scale::Linear => *value += step[at] * unit,
            }
            at += 1;
        }
    }
    clamp(problem, &mut trial.effects);
    trial
}

/// Takes parameters back into their bounds.
pub(super) fn clamp(problem: &Problem, effects: &mut [Active<'static>]) {
    for active in effects {
        for (value, parameter) in active.parameters.iter_mut().zip(active.effect.parameters()) {
            *value = value.clamp(parameter.lower, parameter.upper);
        }
        if let Some([lowest, highest]) = active.effect.within(&problem.facts) {
            active.parameters[0] = active.parameters[0].max(lowest).min(highest);
        }
    }
}

/// Direct search over the parameters of effects that act on scatter, which slopes do not see.
pub(super) fn polish(problem: &Problem, fit: &mut Fit, round: usize, work: &mut Workspace) {
    let mut size = 0.4_f64.powi(round as i32 + 1);
    for _ in 0..3 {
        for at in 0..fit.effects.len() {
            if !fit.effects[at].effect.opens() {
                continue;
            }
            for index in 0..fit.effects[at].parameters.len() {
                for direction in [1.0_f64, -1.0] {
                    let mut trial = fit.clone();
                    let parameter = trial.effects[at].effect.parameters()[index];
                    let value = &mut trial.effects[at].parameters[index];
                    match parameter.scale {
                        Scale::Log => *value *= (direction * size).exp(),
                        Scale::Linear => {
                            *value += direction
                                * size
                                * 0.3
                                * (parameter.upper - parameter.lower).min(3.0)
                        }
                    }
                    clamp(problem, &mut trial.effects);
                    trial.objective = problem
                        .evaluate(&trial.effects, &trial.theta, &mut work.memory)
                        .objective;
                    if trial.objective < fit.objective {
                        *fit = trial;
                        break;
                    }
                }
            }
        }
        size *= 0.4;
    }
}
