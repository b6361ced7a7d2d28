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
        for index in 0..active.parameters.len() {
            let [lowest, highest] = bounds(problem, active, index);
            active.parameters[index] = active.parameters[index].max(lowest).min(highest);
        }
    }
}

/// Bounds of a parameter of an effect: those of the library, and of the data.
fn bounds(problem: &Problem, active: &Active<'_>, index: usize) -> [f64; 2] {
    let parameter = active.effect.parameters()[index];
    let of_library = [parameter.lower, parameter.upper];
    match active.effect.within(&problem.facts) {
        Some([lowest, highest]) if index == 0 => {
            [of_library[0].max(lowest), of_library[1].min(highest)]
        }
        _ => of_library,
    }
}

/// Places, among all free values, of parameters at a bound that the data would move beyond it.
pub(super) fn pressed(problem: &Problem, fit: &Fit, gradient: &DVector<f64>) -> Vec<usize> {
    let effects = fit.effects.iter();
    let parameters = effects.flat_map(|e| (0..e.parameters.len()).map(move |index| (e, index)));
    let places = (problem.free.len()..).zip(parameters);
    let outwards = places.filter(|(at, (active, index))| {
        let [lowest, highest] = bounds(problem, active, *index);
        let value = active.parameters[*index];
        (value <= lowest && gradient[*at] < 0.0) || (value >= highest && gradient[*at] > 0.0)
    });
    outwards.map(|(at, _)| at).collect()
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
