//! Direct search over what slopes do not see.

use super::fit::{Fit, Workspace};
use super::problem::Problem;
use super::step::clamp;
use calib_effects::Scale;

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
