//! What part of the chain a deviation comes from, without the formula of any effect.
//!
//! An effect of some part of the chain may have any course over frequency, but not in any
//! observable: one of the reference is in the ratio and, mirrored, in the drive; one of the mount
//! turns with the device or grows with the payload; one of the exciter spares the ratio. Each
//! [`Kind`] is such a rule with free courses; the one that accounts for most of the residual, less
//! the cost of what it leaves free, is the class of the gap.

use super::kind::Kind;
use super::rules::Rules;
use crate::engine::fit::{Fit, Workspace};
use crate::engine::linear::Linearised;
use crate::engine::problem::Problem;
use crate::engine::settled::Settled;

/// A class of deviation with the chi-square it accounts for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Found {
    pub(crate) kind: Kind,
    pub(crate) gain: f64,
}

/// The two classes that account for most of what a fit leaves, the second of what the first leaves.
pub(crate) fn classes(problem: &Problem, fit: &Fit, work: &mut Workspace) -> Vec<Found> {
    let Some((evaluation, tangent)) = Linearised::new(problem, fit, work).tangent() else {
        return Vec::new();
    };
    let rules = Rules::new(problem, &evaluation.weight, &tangent, fit);
    let mut residual = Settled::new(problem, fit, &tangent, evaluation.residual).left;
    let mut found: Vec<Found> = Vec::new();
    for _ in 0..2 {
        let others = rules
            .patterns
            .iter()
            .filter(|p| found.iter().all(|f| f.kind != p.kind));
        let gains = others.map(|p| (p, p.fit(problem, &residual).1));
        let best = gains.max_by(|a, b| (a.1 - a.0.cost).total_cmp(&(b.1 - b.0.cost)));
        let Some((pattern, gain)) = best.filter(|(p, gain)| *gain > p.cost) else {
            break;
        };
        let kind = pattern.kind;
        found.push(Found { kind, gain });
        pattern.take_out(problem, &tangent, &mut residual);
    }
    found
}
