//! The best values beside those where a search stopped, and what is left there.
//!
//! A search ends a little beside the best values, and they move with how much
//! data count. A test of a direction that hardly differs from one of theirs
//! would enlarge the rest of the way.

use super::fit::Fit;
use super::normal::Tangent;
use super::problem::Problem;
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
        let step = tangent.solve(&gradient(problem, fit, tangent, &left));
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

/// Slope of the objective against nuisances and parameters, zero where they cannot move.
fn gradient(problem: &Problem, fit: &Fit, tangent: &Tangent, left: &[f64]) -> DVector<f64> {
    let nuisances = problem.free.iter().zip(&fit.theta);
    let pulled = nuisances.map(|(free, value)| if free.bounded { *value } else { 0.0 });
    let pulled = pulled.chain(std::iter::repeat(0.0));
    // A parameter stays at its bound.
    let stays = fit.effects.iter().flat_map(|effect| {
        let bounds = effect.effect.about().parameters.iter();
        let values = bounds.zip(&effect.parameters);
        values.map(|(bound, value)| *value <= bound.lower || *value >= bound.upper)
    });
    let moves = std::iter::repeat_n(true, problem.free.len()).chain(stays.map(|stays| !stays));
    let columns = tangent.columns.iter().zip(moves).zip(pulled);
    let gradient = columns.map(|((column, moves), pulled)| {
        if moves {
            column.dot_data(problem, left) - pulled
        } else {
            0.0
        }
    });
    DVector::from_iterator(tangent.columns.len(), gradient)
}
