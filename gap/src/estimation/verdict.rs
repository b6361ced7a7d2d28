//! The verdict: from the probability of the leading set, and from what it leaves.

use super::gap::{Gap, Slice};
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
    /// No set closes half of the gap and holds at every level and in every band that shows it.
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
    let holds = gap.size.chi_after <= thresholds::EXPLAINED_CHI;
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
    gap.size
        .closed
        .is_some_and(|closed| closed >= thresholds::HALF)
        && holds(&gap.by_level)
        && holds(&gap.by_band)
}

/// Whether a set closes a part of the gap in every slice that has more than a hundredth of it.
fn holds(slices: &[Slice]) -> bool {
    let square = |slice: &Slice| slice.size.before_rel.powi(2);
    let all: f64 = slices.iter().map(square).sum();
    let mut counts = slices
        .iter()
        .filter(|slice| square(slice) > thresholds::LITTLE * all);
    counts.all(|slice| {
        let least = if slice.beyond {
            -thresholds::EVERYWHERE
        } else {
            thresholds::EVERYWHERE
        };
        slice.size.closed.is_none_or(|closed| closed >= least)
    })
}

/// The verdict once causes outside the library have their share of the probability, `leading` being what the first
/// cause keeps: one beside which another outside is twice as probable explains no more than a part.
pub(crate) fn doubted(verdict: Verdict, leading: Option<f64>, gap: &Gap) -> Verdict {
    match verdict {
        Verdict::Explained if leading.is_some_and(|p| p < thresholds::ONE_OF_THREE) => {
            match explains_part(gap) {
                true => Verdict::PartlyExplained,
                false => Verdict::Unexplained,
            }
        }
        verdict => verdict,
    }
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
    use crate::estimation::gap::GapSize;
    use std::collections::BTreeMap;

    fn slice(before_rel: f64, closed: f64) -> Slice {
        Slice {
            from: 0.0,
            to: 1.0,
            rows: 10,
            beyond: false,
            chosen: Vec::new(),
            size: GapSize {
                before_rel,
                after_rel: 0.0,
                floor_rel: 0.0,
                closed: Some(closed),
                chi_before: 10.0,
                chi_after: 1.0,
            },
        }
    }

    fn gap(closed: f64, by_band: Vec<Slice>) -> Gap {
        Gap {
            size: GapSize {
                before_rel: 0.4,
                after_rel: 0.04,
                floor_rel: 0.001,
                closed: Some(closed),
                chi_before: 100.0,
                chi_after: 10.0,
            },
            held_out_rows: 100,
            chosen: Vec::new(),
            rms_before: None,
            rms_after: None,
            by_observable: BTreeMap::new(),
            by_level: Vec::new(),
            by_band,
        }
    }

    /// The pendulum of the measured sets: 40 % in one band, 1.5 % in another, which gets worse.
    #[test]
    fn a_band_with_nearly_nothing_of_the_gap_does_not_undo_a_cause() {
        let heard = |small| {
            heard(
                Verdict::Unexplained,
                &gap(0.9, vec![slice(40.0, 0.9), slice(small, -3.0)]),
                false,
            )
        };
        assert_eq!(heard(1.5), Verdict::PartlyExplained);
        assert_eq!(heard(10.0), Verdict::Unexplained);
    }

    #[test]
    fn a_cause_beside_a_more_probable_other_does_not_explain() {
        let of =
            |leading, closed| doubted(Verdict::Explained, Some(leading), &gap(closed, Vec::new()));
        assert_eq!(of(0.98, 0.9), Verdict::Explained);
        assert_eq!(of(0.24, 0.9), Verdict::PartlyExplained);
        assert_eq!(of(0.24, 0.4), Verdict::Unexplained);
        assert_eq!(
            doubted(Verdict::NoGap, Some(0.24), &gap(0.9, Vec::new())),
            Verdict::NoGap
        );
    }

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
