//! The best values beside those where a search stopped, and what is left there.
//!
//! A search ends a little beside the best values, and they move with how much
//! data count. A test of a direction that hardly differs from one of theirs
//! would enlarge the rest of the way.

use super::fit::Fit;
use super::problem::{Problem, Tangent};
use crate::thresholds;
use nalgebra::DVector;

/// Where the parameters of a fit stand still.
pub(crate) struct Settled {
    /// Whitened residual there, one per datum.
    pub(crate) left: Vec<f64>,
    /// Nuisances there, each in its unit.
    pub(crate) theta: Vec<f64>,
}

impl Settled {
    /// One step in the tangent space of a fit from its residual `left`.
    pub(crate) fn new(problem: &Problem, fit: &Fit, tangent: &Tangent, mut left: Vec<f64>) -> Self {
        let slope = gradient(problem, fit, tangent, &left);
        let mut step = tangent.solve(&slope);
        let movable = movable(problem, fit);
        if leaves_bounds(&movable, tangent, &step) {
            step = tangent.solve(&slope.component_mul(&movable));
        }
        for (column, by) in tangent.columns.iter().zip(step.iter()) {
            column.add_to(problem, &mut left, -by);
        }
        let theta = fit.theta.iter().zip(step.iter());
        Self {
            left,
            theta: theta.map(|(value, by)| value + by).collect(),
        }
    }
}

/// Whether a step leads beyond a bound by more than noise does. By less it may: what is left of a
/// value that stays, though the data have it a little farther out, would look like lack of fit.
fn leaves_bounds(movable: &DVector<f64>, tangent: &Tangent, step: &DVector<f64>) -> bool {
    if movable.iter().all(|moves| *moves == 1.0) {
        return false;
    }
    let covariance = tangent.covariance();
    let mut stuck = (0..step.len()).filter(|at| movable[*at] == 0.0);
    stuck.any(|at| step[at].abs() > thresholds::BOUND_SIGMA * covariance[(at, at)].sqrt())
}

/// 1 for what can move, 0 for a parameter at its bound: nuisances, then parameters.
fn movable(problem: &Problem, fit: &Fit) -> DVector<f64> {
    let parameters = fit.effects.iter().flat_map(|effect| {
        let bounds = effect.effect.parameters().iter();
        let values = bounds.zip(&effect.parameters);
        values.map(|(bound, value)| *value > bound.lower && *value < bound.upper)
    });
    let all = std::iter::repeat_n(true, problem.free.len()).chain(parameters);
    let all: Vec<f64> = all.map(|moves| f64::from(u8::from(moves))).collect();
    DVector::from_vec(all)
}

/// Slope of the objective against nuisances and parameters.
pub(super) fn gradient(
    problem: &Problem,
    fit: &Fit,
    tangent: &Tangent,
    left: &[f64],
) -> DVector<f64> {
    let nuisances = problem.free.iter().zip(&fit.theta);
    let pulled = nuisances.map(|(free, value)| if free.bounded { *value } else { 0.0 });
    let pulled = pulled.chain(std::iter::repeat(0.0));
    let columns = tangent.columns.iter().zip(pulled);
    let gradient = columns.map(|(column, pulled)| column.dot_data(problem, left) - pulled);
    DVector::from_iterator(tangent.columns.len(), gradient)
}
