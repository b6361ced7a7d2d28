//! A fit after a step of nuisances and parameters, within physical bounds.

use super::fit::Fit;
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
