//! The verdict on a search over the points of a calibrator.

use super::evaluation::difference;
use super::fit::{Fit, Workspace};
use super::lack_of_fit::{LackOfFit, examine};
use super::problem::Problem;
use super::search::Search;
use crate::estimation::verdict::{Evidence, Verdict, conclude};
use crate::model::effect::Active;
use crate::thresholds;

/// Result of a search, and the remainder of the data.
pub(crate) struct Judgement {
    pub(crate) verdict: Verdict,
    /// Residuals of the nominal simulation.
    pub(crate) nominal_left: LackOfFit,
    /// Residuals of the best set.
    pub(crate) left: LackOfFit,
}

/// Judges what the nominal simulation and the best set of a search leave.
pub(crate) fn judge(problem: &Problem, found: &Search, work: &mut Workspace) -> Judgement {
    let nominal_left = examine(problem, &found.nominal, work);
    let best = found.best();
    let left = if best.effects.is_empty() {
        nominal_left.clone()
    } else {
        examine(problem, best, work)
    };
    let mut none = found.sets.iter().filter(|set| set.fit.effects.is_empty());
    let leading = found.sets.first().filter(|set| !set.fit.effects.is_empty());
    let verdict = conclude(&Evidence {
        none: none.next().map_or(0.0, |set| set.probability),
        leading: leading.map(|set| set.probability),
        p_nominal: nominal_left.p_value,
        p_value: left.p_value,
    });
    Judgement {
        verdict,
        nominal_left,
        left,
    }
}

/// Whether two effects of a set undo each other in some observable, to within a tenth.
///
/// Two independent causes do not have sizes so well matched: the pair imitates
/// one cause that the library lacks.
pub(crate) fn cancels(problem: &Problem, fit: &Fit) -> bool {
    if fit.effects.len() < 2 {
        return false;
    }
    let at =
        |effects: &[Active<'static>]| problem.evaluate(effects, &fit.theta, &mut problem.memory());
    let none = at(&[]);
    let alone = |effect| difference(problem, &none, &at(std::slice::from_ref(effect)));
    let alone: Vec<Vec<f64>> = fit.effects.iter().map(alone).collect();
    let mut pairs = alone.iter().enumerate();
    pairs.any(|(at, a)| alone[at + 1..].iter().any(|b| undo(problem, a, b)))
}

/// Whether two changes undo each other in some response.
fn undo(problem: &Problem, only_a: &[f64], only_b: &[f64]) -> bool {
    problem
        .measured_observables()
        .filter(|(observable, _)| observable.group().is_response())
        .any(|(_, data)| {
            let (va, vb) = (&only_a[data.clone()], &only_b[data]);
            let size = |v: &mut dyn Iterator<Item = f64>| v.map(|x| x * x).sum::<f64>().sqrt();
            let (na, nb) = (size(&mut va.iter().copied()), size(&mut vb.iter().copied()));
            let sum = size(&mut va.iter().zip(vb).map(|(x, y)| x + y));
            na > thresholds::CANCELLED_SIGMA
                && nb > thresholds::CANCELLED_SIGMA
                && sum < thresholds::CANCELLED_SHARE * na.min(nb)
        })
}
