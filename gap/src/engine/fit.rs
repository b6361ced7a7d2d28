//! Refinement of a set of effects: damped Gauss-Newton on the posterior.

use super::normal::{Tangent, gram};
use super::nuisance::Nuisance;
use super::problem::{Column, Evaluation, Problem};
use crate::effects::{Active, Scale};
use crate::model::predict::Memory;
use nalgebra::{Cholesky, DVector};

/// A refined set of effects.
#[derive(Clone)]
pub(crate) struct Fit {
    /// Library entries and their parameters.
    pub(crate) effects: Vec<Active<'static>>,
    /// Nuisance values in units of their uncertainty.
    pub(crate) theta: Vec<f64>,
    /// -2 ln posterior at the optimum.
    pub(crate) objective: f64,
}

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

impl Fit {
    /// Number of parameters of the effects.
    pub(crate) fn parameter_count(&self) -> usize {
        self.effects.iter().map(|e| e.parameters.len()).sum()
    }

    /// Names of the effects in library order.
    pub(crate) fn names(&self) -> Vec<&'static str> {
        self.effects.iter().map(|e| e.effect.about().id).collect()
    }

    /// Whether a library entry takes part.
    pub(crate) fn has(&self, entry: usize) -> bool {
        self.effects.iter().any(|e| e.entry == entry)
    }
}

/// Memory of balances, reused between refinements of one problem.
pub(crate) struct Workspace {
    pub(crate) memory: Vec<Memory>,
}

impl Workspace {
    pub(crate) fn new(problem: &Problem) -> Self {
        Self {
            memory: problem.memory(),
        }
    }
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

/// Change of all data, in standard deviations, that a small step of a parameter must exceed.
const STANDS_STILL: f64 = 1e-9;
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
    let (mut small, mut accepted) = (0, 0);
    for _ in 0..effort.most_steps {
        let Some(step) = linear.step(problem, damping) else {
            damping *= 10.0;
            continue;
        };
        let trial = moved(problem, fit, &step);
        let evaluation = problem.evaluate(&trial.effects, &trial.theta, &mut work.memory);
        let gain = fit.objective - evaluation.objective;
        if gain > 0.0 {
            *fit = Fit {
                objective: evaluation.objective,
                ..trial
            };
            damping = (damping * 0.1).max(1e-9);
            small = if gain < effort.enough { small + 1 } else { 0 };
            if small == 2 {
                break;
            }
            accepted += 1;
            let lagging = (accepted % RENEWAL != 0).then(|| linear.nuisance_slopes());
            linear = Linearised::with(problem, fit, lagging.as_ref(), work);
        } else {
            if damping > 1e6 {
                break;
            }
            damping *= if damping < 1e-2 { 100.0 } else { 10.0 };
        }
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
                .map(|(slot, values)| (*slot, kept(values, whole.slots[*slot].start)))
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
    fn column(&self, problem: &Problem, index: usize, weight: &[f64]) -> Option<Column> {
        let mut column = self.columns.get(index)?.clone();
        for (slot, values) in &mut column.parts {
            let range = problem.slots[*slot].clone();
            let (now, then) = (&weight[range.clone()], &self.weight[range]);
            for ((value, now), then) in values.iter_mut().zip(now).zip(then) {
                *value *= now / then;
            }
        }
        Some(column)
    }
}

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
    fn with(problem: &Problem, fit: &Fit, lagging: Option<&Slopes>, work: &mut Workspace) -> Self {
        let (evaluation, mut columns) =
            problem.linearise(&fit.effects, &fit.theta, &mut work.memory);
        let bent = fit.effects.iter().any(|e| e.effect.bends());
        let earlier = |index: usize| {
            let slopes = lagging.filter(|_| bent);
            slopes.and_then(|s| s.column(problem, index, &evaluation.weight))
        };
        if bent && lagging.is_none() {
            bent_columns(problem, fit, &evaluation, &mut columns, work);
        }
        for (index, column) in columns.iter_mut().enumerate() {
            if let Some(earlier) = earlier(index) {
                *column = earlier;
            }
        }
        let mut effects = fit.effects.clone();
        for at in 0..effects.len() {
            for index in 0..effects[at].parameters.len() {
                if let Some(earlier) = earlier(columns.len()) {
                    columns.push(earlier);
                    continue;
                }
                let original = effects[at].parameters[index];
                let (value, step) = nudged(&effects[at], index);
                effects[at].parameters[index] = value;
                let there = problem.evaluate_aside(&effects, &fit.theta, &work.memory);
                effects[at].parameters[index] = original;
                let slope = column(problem, &evaluation, &there, step);
                // What only rounding moves would be moved without bounds.
                let moves = slope.norm2() * step * step > STANDS_STILL * STANDS_STILL;
                columns.push(if moves { slope } else { Column::default() });
            }
        }
        let mut prior: Vec<f64> = problem
            .free
            .iter()
            .map(|f| f64::from(u8::from(f.bounded)))
            .collect();
        prior.resize(columns.len(), 0.0);
        Self {
            evaluation,
            columns,
            prior,
            theta: fit.theta.clone(),
        }
    }

    fn step(&self, problem: &Problem, damping: f64) -> Option<DVector<f64>> {
        let mut matrix = gram(&self.columns, &self.prior);
        let nuisances = self.theta.len();
        let mut gradient = DVector::zeros(self.columns.len());
        for (i, column) in self.columns.iter().enumerate() {
            gradient[i] = column.dot_data(problem, &self.evaluation.residual);
            if i < nuisances {
                gradient[i] -= self.prior[i] * self.theta[i];
            }
            matrix[(i, i)] *= 1.0 + damping;
        }
        Some(Cholesky::new(matrix)?.solve(&gradient))
    }

    /// The slopes against nuisances and parameters.
    pub(crate) fn all_slopes(self) -> Slopes {
        Slopes::new(self.columns, self.evaluation.weight)
    }

    /// The slopes against the nuisances alone.
    fn nuisance_slopes(self) -> Slopes {
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

/// Slopes against exciter and level where the exciter is nonlinear: its
/// harmonics depend on them too, and on more than the linear response does.
fn bent_columns(
    problem: &Problem,
    fit: &Fit,
    evaluation: &Evaluation,
    columns: &mut [Column],
    work: &mut Workspace,
) {
    const STEP: f64 = 0.01;
    let saturates = fit.effects.iter().any(|e| e.effect.saturates());
    for (index, free) in problem.free.iter().enumerate() {
        let wanted = match free.kind {
            Nuisance::Exciter(_) | Nuisance::DriveGain => true,
            Nuisance::RunReference(_) => saturates,
            _ => false,
        };
        if !wanted {
            continue;
        }
        let mut theta = fit.theta.clone();
        theta[index] += STEP;
        let there = problem.evaluate_aside(&fit.effects, &theta, &work.memory);
        columns[index] = column(problem, evaluation, &there, STEP);
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
        let of = active.effect.about().parameters.iter().zip(&active.unit);
        for (value, (parameter, unit)) in active.parameters.iter_mut().zip(of) {
            match parameter.scale {
                Scale::Log => *value *= step[at].clamp(-1.0, 1.0).exp(),
                Scale::Linear => *value += step[at] * unit,
            }
            at += 1;
        }
    }
    clamp(&mut trial.effects);
    trial
}

fn clamp(effects: &mut [Active<'static>]) {
    for active in effects {
        for (value, parameter) in active
            .parameters
            .iter_mut()
            .zip(active.effect.about().parameters)
        {
            *value = value.clamp(parameter.lower, parameter.upper);
        }
    }
}

/// Direct search over the parameters of effects that act on scatter, which slopes do not see.
fn polish(problem: &Problem, fit: &mut Fit, round: usize, work: &mut Workspace) {
    let mut size = 0.4_f64.powi(round as i32 + 1);
    for _ in 0..3 {
        for at in 0..fit.effects.len() {
            if !fit.effects[at].effect.opens() {
                continue;
            }
            for index in 0..fit.effects[at].parameters.len() {
                for direction in [1.0_f64, -1.0] {
                    let mut trial = fit.clone();
                    let parameter = trial.effects[at].effect.about().parameters[index];
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
                    clamp(&mut trial.effects);
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
