//! The verdict: from the probability of the leading set, and from what it leaves.

use super::gap::Gap;
use crate::thresholds;
use schemars::JsonSchema;
use serde::Serialize;

/// The outcomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The simulation describes the data within the stated uncertainties.
    NoGap,
    /// One set of effects leads clearly and what is left is noise.
    Explained,
    /// The leading set predicts rows it was not fitted to clearly better everywhere, and more than
    /// noise is left.
    PartlyExplained,
    /// Two or more sets cannot be told apart with these data.
    Ambiguous,
    /// No set closes half of the gap.
    Unexplained,
    /// The stated uncertainties or single rows do not fit.
    Data,
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

/// The verdict once rows that took no part are heard: `gap` is of the leading set, there.
pub(crate) fn heard(verdict: Verdict, gap: &Gap, remembers: bool) -> Verdict {
    let claims = matches!(verdict, Verdict::Explained | Verdict::Ambiguous);
    let holds = gap.chi_after <= thresholds::EXPLAINED_CHI;
    match verdict {
        _ if claims && holds && !remembers => verdict,
        Verdict::Ambiguous if holds => verdict,
        Verdict::NoGap | Verdict::Data => verdict,
        _ if explains_part(gap) => Verdict::PartlyExplained,
        _ if claims && holds => Verdict::PartlyExplained,
        _ => Verdict::Unexplained,
    }
}

/// Whether a set predicts the rows clearly better, and at every level and in every band that shows
/// the gap.
fn explains_part(gap: &Gap) -> bool {
    let slices = gap.by_level.iter().chain(&gap.by_band);
    let mut shares = slices.filter_map(|slice| Some((slice.beyond, slice.closed?)));
    let least = |beyond: bool| {
        if beyond {
            -thresholds::EVERYWHERE
        } else {
            thresholds::EVERYWHERE
        }
    };
    gap.closed.is_some_and(|closed| closed >= thresholds::HALF)
        && shares.all(|(beyond, closed)| closed >= least(beyond))
}

/// Whether a set stands: it makes the unseen data no worse, and each of its effects helps there.
///
/// All are -2 ln likelihood of the unseen data: `here` with the set, `plain` without any effect, and
/// `without` one of its effects at a time. Where the set leaves noise on what it was fitted to, `clean`,
/// noise may have made it worse.
pub(crate) fn stands(
    here: f64,
    plain: f64,
    without: impl IntoIterator<Item = f64>,
    clean: bool,
) -> bool {
    let (worse, helps) = if clean {
        (thresholds::WORSE_BY_NOISE, -thresholds::WORSE_BY_NOISE)
    } else {
        (0.0, thresholds::PARTNER_HELPS)
    };
    here < plain + worse && without.into_iter().all(|less| here + helps < less)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of 100 deviates squared, an effect that is there takes 40. One that is not may add what noise adds
    /// in a sum, 4 here; where more than noise is left it has to take some out.
    #[test]
    fn a_set_stands_that_helps_with_each_of_its_effects() {
        let alone = |here, clean| stands(here, 100.0, [], clean);
        assert!(alone(60.0, true) && alone(60.0, false));
        assert!(alone(104.0, true) && !alone(104.0, false));
        assert!(!alone(140.0, true) && !alone(f64::INFINITY, true));
        let beside = |here, clean| stands(here, 100.0, [60.0, 90.0], clean);
        assert!(beside(64.0, true) && !beside(64.0, false));
        assert!(!beside(57.0, false) && beside(50.0, false));
        assert!(!beside(80.0, true));
    }
}
