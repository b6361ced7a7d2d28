//! The verdict: from the probability of the leading set, and from what it leaves.

use crate::answer::{Cause, Verdict};
use crate::engine::fit::Workspace;
use crate::engine::problem::Problem;
use crate::engine::search::Search;
use crate::engine::structure::{Structure, examine};

/// Structure left by the best set at which "none of these" is the answer.
pub(crate) const NONE_BELOW: f64 = 0.01;
/// Structure left by the nominal simulation at which there is a gap without a name.
const GAP_BELOW: f64 = 5e-4;
/// Probability above which a set leads clearly.
const CLEAR: f64 = 0.8;
/// Smallest probability that is listed.
pub(crate) const LISTED: f64 = 0.01;
/// Probability above which a set is possible beside the leading one. No effect at all is such a set:
/// where it is possible none is claimed.
const POSSIBLE: f64 = 0.05;

/// What the nominal simulation leaves, and the best set of a search: the same where it has no effect.
pub(crate) fn left_by(
    problem: &Problem,
    found: &Search,
    work: &mut Workspace,
) -> (Structure, Structure) {
    let nominal_left = examine(problem, &found.nominal, work);
    let best = found.best();
    let left = if best.effects.is_empty() {
        nominal_left.clone()
    } else {
        examine(problem, best, work)
    };
    (nominal_left, left)
}

/// Verdict on a search, on what its best set leaves and on what the nominal simulation leaves.
pub(crate) fn verdict(found: &Search, left: &Structure, nominal_left: &Structure) -> Verdict {
    let mut none = found.sets.iter().filter(|set| set.fit.effects.is_empty());
    let doubtful = none.any(|set| set.probability > POSSIBLE);
    if doubtful && nominal_left.p_value >= GAP_BELOW {
        return Verdict::NoGap;
    }
    let leads = found.sets.first().filter(|set| !set.fit.effects.is_empty());
    conclude(leads.map(|set| set.probability), left.p_value)
}

/// Verdict from the probability of the leading set, if there is one, and the p-value of what is left.
pub(crate) fn conclude(leading: Option<f64>, p_value: f64) -> Verdict {
    match leading {
        None if p_value < GAP_BELOW => Verdict::Unexplained,
        None => Verdict::NoGap,
        Some(_) if p_value < NONE_BELOW => Verdict::Unexplained,
        Some(probability) if probability >= CLEAR => Verdict::Explained,
        Some(_) => Verdict::Ambiguous,
    }
}

/// The leading set with each other that these data leave possible.
pub(crate) fn hardly_separated(causes: &[Cause], verdict: Verdict) -> Vec<Vec<String>> {
    let name = |c: &Cause| c.effects.join("+");
    match causes {
        [first, rest @ ..] if verdict != Verdict::NoGap => {
            let possible = rest.iter().filter(|c| c.probability > POSSIBLE);
            possible.map(|c| vec![name(first), name(c)]).collect()
        }
        _ => Vec::new(),
    }
}
