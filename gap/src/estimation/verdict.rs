//! The verdict: from the probability of the leading set, and from what it leaves.

use serde::Serialize;

/// The four outcomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The simulation describes the data within the stated uncertainties.
    NoGap,
    /// One set of effects leads clearly and what is left is noise.
    Explained,
    /// Two or more sets cannot be told apart with these data.
    Ambiguous,
    /// Even the best set leaves significant structure.
    Unexplained,
}

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
pub(crate) const POSSIBLE: f64 = 0.05;

/// What a verdict is drawn from: probabilities of sets, and p-values of what is left.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Evidence {
    /// Probability of no cause at all.
    pub(crate) none: f64,
    /// Probability of the leading set, if it has a cause.
    pub(crate) leading: Option<f64>,
    /// P-value of what the nominal simulation leaves.
    pub(crate) p_nominal: f64,
    /// P-value of what the leading set leaves.
    pub(crate) p_value: f64,
}

/// The verdict on a search.
pub(crate) fn conclude(evidence: &Evidence) -> Verdict {
    if evidence.none > POSSIBLE && evidence.p_nominal >= GAP_BELOW {
        return Verdict::NoGap;
    }
    match evidence.leading {
        None if evidence.p_value < GAP_BELOW => Verdict::Unexplained,
        None => Verdict::NoGap,
        Some(_) if evidence.p_value < NONE_BELOW => Verdict::Unexplained,
        Some(probability) if probability >= CLEAR => Verdict::Explained,
        Some(_) => Verdict::Ambiguous,
    }
}
