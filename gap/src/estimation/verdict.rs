//! The verdict: from the probability of the leading set, and from what it leaves.

use crate::thresholds;
use schemars::JsonSchema;
use serde::Serialize;

/// The four outcomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
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

/// Grounds of a verdict: probabilities of sets, and p-values of the remainder.
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
    if evidence.none > thresholds::POSSIBLE_PROBABILITY
        && evidence.p_nominal >= thresholds::GAP_P_VALUE
    {
        return Verdict::NoGap;
    }
    match evidence.leading {
        None if evidence.p_value < thresholds::GAP_P_VALUE => Verdict::Unexplained,
        None => Verdict::NoGap,
        Some(_) if evidence.p_value < thresholds::UNEXPLAINED_P_VALUE => Verdict::Unexplained,
        Some(probability) if probability >= thresholds::EXPLAINED_PROBABILITY => Verdict::Explained,
        Some(_) => Verdict::Ambiguous,
    }
}
