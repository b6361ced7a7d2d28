//! Refinement of a set of effects: damped Gauss-Newton on the posterior.

use super::evaluation::{Evaluation, Responses};
use super::fit::{Fit, Workspace};
use super::higher::higher_harmonics;
use super::linear::{Linearised, Slopes};
use super::problem::Problem;
use crate::estimation::descent::{self, Effort, LeastSquares};
use crate::estimation::tangent::Equations;
use crate::model::effect::Active;
use crate::thresholds;
use calib_effects::Scale;
use nalgebra::DVector;

/// All the steps a set is worth.
pub(crate) const FULL: Effort = Effort {
    most_steps: 25,
    within: f64::INFINITY,
    enough: 1e-2,
    share: thresholds::STEP_SHARE,
    small_steps: 2,
    damping: 1e-4,
    leap: 100.0,
};

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

/// Refines; the first step takes the slopes that are known of part of the set.
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
    clamp(problem, &mut fit.effects);
    descend(problem, &mut fit, slopes, effort, work);
    unstretch(problem, &mut fit, effort, work);
    fit
}

/// Puts stretched noise back where it is stated, if the search then describes the data better.
///
/// Higher harmonics count as noise or do not, for a whole dataset. A start from a set without them
/// has stretched the noise in their place, and at that noise they are better not counted.
fn unstretch(problem: &Problem, fit: &mut Fit, effort: Effort, work: &mut Workspace) {
    let stated = problem.stated_noise(&fit.theta);
    let mut moved = stated.iter().zip(&fit.theta);
    if !moved.any(|(to, from)| (to - from).abs() > thresholds::NOISE_STRETCHED)
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

/// Damped steps until the objective stands still; the first takes `slopes` where there are any.
fn descend(
    problem: &Problem,
    fit: &mut Fit,
    slopes: Option<&Slopes>,
    effort: Effort,
    work: &mut Workspace,
) {
    let found = problem.respond(&fit.effects, &fit.theta, &mut work.memory);
    let start = Place::new(fit.clone(), found);
    let mut descent = Descent {
        problem,
        work,
        first: slopes,
        lagging: None,
        taken: 0,
    };
    if let Some((place, _)) = descent::descend(&mut descent, start, effort) {
        *fit = place.fit;
    }
}

/// A set of effects on the way of a refinement.
struct Descent<'a> {
    problem: &'a Problem,
    work: &'a mut Workspace,
    /// Slopes that the first step takes.
    first: Option<&'a Slopes>,
    /// Slopes of the last step.
    lagging: Option<Slopes>,
    /// Steps so far.
    taken: usize,
}

/// A fit with what the simulation says there.
struct Place {
    fit: Fit,
    found: (Evaluation, Responses),
}

impl Place {
    fn new(fit: Fit, found: (Evaluation, Responses)) -> Self {
        let objective = found.0.objective;
        Self {
            fit: Fit { objective, ..fit },
            found,
        }
    }
}

impl LeastSquares for Descent<'_> {
    type State = Place;

    fn objective(&self, at: &Place) -> f64 {
        at.fit.objective
    }

    fn beyond_noise(&self, at: &Place) -> f64 {
        (at.fit.objective - self.problem.len() as f64).max(0.0)
    }

    fn equations(&mut self, at: &Place) -> Option<Equations> {
        let lagging = match self.taken {
            0 => self.first,
            taken if taken % thresholds::RENEWAL == 0 => None,
            _ => self.lagging.as_ref(),
        };
        self.taken += 1;
        let (evaluation, responses) = (at.found.0.clone(), &at.found.1);
        let found = (evaluation, responses);
        let linear = Linearised::at(self.problem, &at.fit, found, lagging, self.work);
        let mut equations = linear.equations(self.problem);
        for held in pressed(self.problem, &at.fit, &equations.gradient) {
            equations.hold(held);
        }
        self.lagging = Some(linear.nuisance_slopes());
        Some(equations)
    }

    fn moved(&mut self, from: &Place, step: &DVector<f64>) -> Option<Place> {
        let fit = moved(self.problem, &from.fit, step);
        let found = self
            .problem
            .respond(&fit.effects, &fit.theta, &mut self.work.memory);
        Some(Place::new(fit, found))
    }
}

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
fn clamp(problem: &Problem, effects: &mut [Active<'static>]) {
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
fn pressed(problem: &Problem, fit: &Fit, gradient: &DVector<f64>) -> Vec<usize> {
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

#[cfg(test)]
mod tests {
    use super::super::example::{measured, named};
    use super::*;

    /// A coil of thirteen times its stated resistance, where ten times is the bound of the library: what the data
    /// want beyond it must not spoil the steps of the others.
    #[test]
    fn a_value_at_its_bound_holds_no_other_up() {
        let (resistance, inductance) = ("nominal_resistance", "nominal_inductance");
        let (rig, points) = measured(&[(resistance, vec![12.0]), (inductance, vec![0.8])]);
        let problem = Problem::new(&rig, &points);
        let mut work = Workspace::new(&problem);
        let effects = vec![named(resistance, 0, &[8.0]), named(inductance, 0, &[0.1])];
        let theta = vec![0.0; problem.free.len()];
        let found = refine(&problem, effects, theta, FULL, &mut work);
        assert_eq!(found.effects[0].parameters, [9.0]);
        let (effects, theta) = (found.effects.clone(), found.theta.clone());
        let again = refine(&problem, effects, theta, FULL, &mut work);
        let gain = found.objective - again.objective;
        assert!(gain < FULL.enough, "{gain} of {}", found.objective);
    }
}
