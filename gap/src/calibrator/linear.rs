//! The problem linearised at a fit: slopes against nuisances and parameters, of now or of an earlier step.

use super::closed_form::nuisance_columns;
use super::evaluation::{Evaluation, Responses};
use super::finite_difference::{nonlinear_columns, parameter_slopes};
use super::fit::{Fit, Workspace};
use super::problem::{Column, Problem, Tangent};
use crate::estimation::tangent::Equations;

/// The problem linearised at a fit.
pub(crate) struct Linearised {
    pub(crate) evaluation: Evaluation,
    pub(crate) columns: Vec<Column>,
    pub(crate) prior: Vec<f64>,
    theta: Vec<f64>,
    /// Slopes of the logarithms of the variances, and the parameter each is against.
    variances: Vec<(usize, Column)>,
}

impl Linearised {
    pub(crate) fn new(problem: &Problem, fit: &Fit, work: &mut Workspace) -> Self {
        Self::with(problem, fit, None, work)
    }

    /// Linearises with earlier slopes, where new ones are expensive.
    pub(super) fn with(
        problem: &Problem,
        fit: &Fit,
        lagging: Option<&Slopes>,
        work: &mut Workspace,
    ) -> Self {
        let (evaluation, responses) = problem.respond(&fit.effects, &fit.theta, &mut work.memory);
        Self::at(problem, fit, (evaluation, &responses), lagging, work)
    }

    /// Linearises where the fit has been evaluated.
    pub(super) fn at(
        problem: &Problem,
        fit: &Fit,
        (evaluation, responses): (Evaluation, &Responses),
        lagging: Option<&Slopes>,
        work: &Workspace,
    ) -> Self {
        let nonlinear = fit.effects.iter().any(|e| e.effect.makes_nonlinear());
        let lagging = lagging.filter(|_| nonlinear);
        let earlier = |index: usize| lagging.and_then(|s| s.column(problem, index, &evaluation));
        let mut columns = nuisance_columns(problem, &evaluation, responses, &fit.theta);
        if nonlinear && lagging.is_none() {
            nonlinear_columns(problem, fit, &evaluation, &mut columns, work);
        }
        for (index, column) in columns.iter_mut().enumerate() {
            if let Some(earlier) = earlier(index) {
                *column = earlier;
            }
        }
        let mut variances = Vec::new();
        for (at, active) in fit.effects.iter().enumerate() {
            for index in 0..active.parameters.len() {
                if let Some(column) = earlier(columns.len()) {
                    columns.push(column);
                    continue;
                }
                let slopes = parameter_slopes(problem, fit, (at, index), &evaluation, work);
                if !slopes.variance.parts.is_empty() {
                    variances.push((columns.len(), slopes.variance));
                }
                columns.push(slopes.data);
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
            variances,
        }
    }

    /// The normal equations of the next step.
    pub(super) fn equations(&self, problem: &Problem) -> Equations {
        let residual = &self.evaluation.residual;
        let mut equations =
            Equations::new(problem, &self.columns, &self.prior, residual, &self.theta);
        if self.variances.is_empty() {
            return equations;
        }
        // A variance is too small by as much as the square of its deviate is above one. The curvature is the mean of
        // the expected (Fisher) and the observed one, which bounds steps where a variance is many times too small.
        let excess: Vec<f64> = residual.iter().map(|r| r * r - 1.0).collect();
        let curvature: Vec<f64> = excess.iter().map(|e| 1.0 + 0.5 * e).collect();
        for (at, variance) in &self.variances {
            equations.gradient[*at] += 0.5 * variance.dot_data(problem, &excess);
            let curved = variance.weighted(problem, &curvature);
            for (other, beside) in &self.variances {
                equations.matrix[(*at, *other)] += 0.5 * curved.dot(beside);
            }
        }
        equations
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

/// Slopes taken at an earlier step, or at a smaller set: against the nuisances,
/// then perhaps against the parameters of the first effects.
pub(crate) struct Slopes {
    columns: Vec<Column>,
    /// Weights that the columns hold.
    weight: Vec<f64>,
}

impl Slopes {
    /// Slopes with the weights they hold.
    pub(crate) fn new(columns: Vec<Column>, weight: Vec<f64>) -> Self {
        Self { columns, weight }
    }

    /// The slopes of those rows of a problem that are a problem of their own.
    pub(crate) fn of_part(
        &self,
        whole: &Problem,
        part: &Problem,
        keep: &dyn Fn(usize) -> bool,
    ) -> Self {
        let kept = |values: &[f64], from: usize| -> Vec<f64> {
            let data = values.iter().enumerate();
            let inside = data.filter(|(at, _)| keep(whole.row_of[from + at]));
            inside.map(|(_, value)| *value).collect()
        };
        let of_part = |column: &Column| Column {
            parts: column
                .parts
                .iter()
                .map(|(o, values)| (*o, kept(values, whole.data_of(*o).start)))
                .collect(),
        };
        // Without its rows, a run has no gain.
        let at = |kind| whole.free.iter().position(|free| free.kind == kind);
        let nuisances = part.free.iter().filter_map(|free| at(free.kind));
        let columns = nuisances.chain(whole.free.len()..self.columns.len());
        Self {
            columns: columns.map(|at| of_part(&self.columns[at])).collect(),
            weight: kept(&self.weight, 0),
        }
    }

    /// Column of a parameter, with the weights of now.
    pub(super) fn column(
        &self,
        problem: &Problem,
        index: usize,
        here: &Evaluation,
    ) -> Option<Column> {
        let mut column = self.columns.get(index)?.clone();
        for (observable, values) in &mut column.parts {
            let range = problem.data_of(*observable);
            let (now, then) = (&here.weight[range.clone()], &self.weight[range]);
            for ((value, now), then) in values.iter_mut().zip(now).zip(then) {
                *value *= now / then;
            }
        }
        Some(column)
    }
}

#[cfg(test)]
mod tests {
    use super::super::example::{measured, named};
    use super::*;
    use crate::dataset::Quantity;

    /// Points whose drive scatters by so much, and a tone of 0.02 m/s2 beside the block.
    fn scattered(scatter: f64) -> (Problem, Fit) {
        let (mut rig, mut points) = measured(&[]);
        rig.digitiser.sample_rate_hz = Some(50_000.0);
        rig.digitiser.block_samples = Some(10_000.0);
        rig.digitiser.noise_v = Some(Quantity {
            value: 1e-5,
            u: 1e-7,
        });
        for (at, point) in points.iter_mut().enumerate() {
            let by = scatter * (3.7 * at as f64).sin();
            point.ref_v = point.ref_v.map(|v| v * by.exp());
        }
        let problem = Problem::new(&rig, &points);
        let fit = Fit {
            effects: vec![named("ambient_vibration", 2, &[0.03, 0.02, 12.0])],
            theta: vec![0.0; problem.free.len()],
            objective: 0.0,
        };
        (problem, fit)
    }

    /// Where a tone is many times too small, a step cannot bring more than there is. By the expected curvature alone
    /// it promised hundreds of times as much, and each damping was tried in vain.
    #[test]
    fn no_step_of_a_variance_predicts_more_gain_than_there_is() {
        let (problem, fit) = scattered(0.2);
        let mut work = Workspace::new(&problem);
        let there = Linearised::new(&problem, &fit, &mut work);
        let equations = there.equations(&problem);
        let step = equations.step(1e-4).expect("it has slopes");
        let (predicted, left) = (equations.predicted(&step), there.evaluation.objective);
        assert!(
            predicted > 0.01 * left && predicted < left,
            "{predicted} of {left}"
        );
    }

    /// A tone beside the block leaves variances open, and moves nothing else: without them the gradient against
    /// its size and its frequency would be zero.
    #[test]
    fn the_gradient_is_that_of_the_objective_where_variances_are_open() {
        let (problem, mut fit) = scattered(2e-3);
        let mut work = Workspace::new(&problem);
        let gradient = Linearised::new(&problem, &fit, &mut work)
            .equations(&problem)
            .gradient;
        for index in 1..3 {
            let value = fit.effects[0].parameters[index];
            let mut objective = |step: f64| {
                fit.effects[0].parameters[index] = value * step.exp();
                let there = problem.evaluate(&fit.effects, &fit.theta, &mut work.memory);
                there.objective
            };
            let expected = -(objective(1e-4) - objective(-1e-4)) / 4e-4;
            fit.effects[0].parameters[index] = value;
            let found = gradient[problem.free.len() + index];
            assert!(
                (found - expected).abs() < 0.02 * expected.abs(),
                "{index}: {found} {expected}"
            );
        }
    }
}
