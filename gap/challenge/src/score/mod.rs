//! Score of answers to a sealed set.

mod answers;
mod rates;
mod sizes;
mod substitute;

pub use self::answers::{ScoredAnswer, read_answers};
pub use self::rates::{Rates, Share, StratumScore};
pub use self::sizes::SizeScore;
pub use self::substitute::left_by_substitutes;

use super::truth::Truth;
use calib_files::Result;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Smallest size of each effect of a case, in standard uncertainties of the whole dataset, from
/// which somebody can be asked to see it.
const VISIBLE_SIGMA: f64 = 6.0;

/// Least remainder of a withheld effect behind a substitute, in the same unit.
const LEFT_SIGMA: f64 = 3.0;

/// Everything about a set of answers.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Score {
    /// All cases.
    #[serde(flatten)]
    pub all: Rates,
    /// Those all of whose effects can be seen; of an effect that was withheld, those where its
    /// substitute leaves something, as far as that is known.
    pub visible: Rates,
    /// Detection and naming over size.
    pub sizes: Vec<SizeScore>,
}

/// Scores answers against the truth; they are matched by the SHA-256 of the dataset.
///
/// `left_sigma` is what [`left_by_substitutes`] found, or empty.
///
/// # Errors
/// [`calib_files::Error::Input`] when an answer is about a dataset that is not in the set.
pub fn score(
    answers: &[ScoredAnswer],
    truth: &Truth,
    left_sigma: &BTreeMap<String, f64>,
) -> Result<Score> {
    let pairs = answers::matched(answers, truth)?;
    let visible = pairs.iter().filter(|pair| {
        let left = left_sigma.get(&pair.truth.name);
        pair.truth.least_sigma > VISIBLE_SIGMA && left.is_none_or(|left| *left > LEFT_SIGMA)
    });
    let of_size = pairs.iter().filter(|p| p.truth.stratum == "size");
    Ok(Score {
        visible: Rates::of(visible.copied()),
        sizes: sizes::sizes(&of_size.copied().collect::<Vec<_>>()),
        all: Rates::of(pairs.into_iter()),
    })
}

#[cfg(test)]
mod tests {
    use super::answers::{Closed, Identity, Place, ScoredCause};
    use super::*;
    use crate::truth::TrueCase;

    fn case(name: &str, stratum: &str, effect: &str, without: &str, sigma: f64) -> TrueCase {
        let list = |text: &str| text.split_terminator('+').map(str::to_owned).collect();
        TrueCase {
            name: name.into(),
            stratum: stratum.into(),
            names: list(effect),
            effects: list(effect),
            stages: vec!["dut".into()],
            without: list(without),
            size_sigma: sigma,
            least_sigma: sigma,
            dataset_sha256: format!("sum of {name}"),
        }
    }

    fn answer(name: &str, verdict: &str, causes: &[(&str, f64)], p: f64) -> ScoredAnswer {
        let cause = |(effects, probability): &(&str, f64)| ScoredCause {
            effects: effects.split('+').map(str::to_owned).collect(),
            probability: *probability,
        };
        ScoredAnswer {
            verdict: verdict.into(),
            causes: causes.iter().map(cause).collect(),
            none_of_these_p_value: p,
            r#where: vec![Place {
                stage: "dut".into(),
            }],
            gap: Closed { closed: Some(0.9) },
            dataset: Identity {
                sha256: format!("sum of {name}"),
            },
        }
    }

    #[test]
    fn every_statistic_is_counted_as_defined() {
        let truth = Truth {
            seed: 1,
            cases: vec![
                case("a", "single", "x", "", 20.0),
                case("b", "single", "y", "", 20.0),
                case("c", "single", "z", "", 20.0),
                case("d", "null", "", "", 0.0),
                case("e", "null", "", "", 0.0),
                case("f", "withheld", "x", "x", 20.0),
                case("g", "pair", "x+y", "", 20.0),
                case("h", "size", "x", "", 2.0),
            ],
        };
        let answers = [
            answer("a", "explained", &[("x", 0.9), ("y", 0.1)], 0.5),
            answer("b", "ambiguous", &[("x", 0.6), ("y", 0.4)], 0.3),
            answer("d", "no_gap", &[], 0.5),
            answer("e", "explained", &[("x", 1.0)], 0.5),
            answer("f", "unexplained", &[("y", 1.0)], 0.3),
            // The order within a set means nothing.
            answer("g", "explained", &[("y+x", 1.0)], 0.4),
            answer("h", "no_gap", &[], 0.5),
        ];
        let score = score(&answers, &truth, &BTreeMap::new()).expect("scored");
        let single = &score.all.strata["single"];
        let counts = |share: Option<Share>| share.map(|s| (s.count, s.of));
        assert_eq!(counts(single.top_1), Some((1, 3)));
        assert_eq!(counts(single.truth_covered), Some((2, 3)));
        assert_eq!(counts(single.detected), Some((2, 3)));
        assert_eq!((single.unanswered, single.ambiguous.count), (1, 1));
        let null = &score.all.strata["null"];
        assert_eq!(counts(null.false_alarm), Some((1, 2)));
        assert!(null.top_1.is_none() && null.detected.is_none());
        assert_eq!(null.confidently_wrong.count, 1);
        assert_eq!(counts(score.all.strata["pair"].top_1), Some((1, 1)));
        let withheld = &score.all.strata["withheld"];
        assert!(withheld.top_1.is_none());
        assert_eq!(counts(withheld.stage_among_two), Some((1, 1)));
        // p of the withheld case: 0.3, of the singles: 0.5 and 0.3: one win, one tie.
        assert_eq!(score.all.auroc, Some(0.75));
        // Bins by hand: 0.9 right, 0.1 wrong, 0.6 wrong, 0.4 right, 1.0 right; 0.9 and 1.0 share
        // the highest bin: |1.9 - 2| + 0.1 + 0.6 + |0.4 - 1| over five.
        let error = score.all.calibration_error.expect("there are causes");
        assert!((error - 1.4 / 5.0).abs() < 1e-12, "{error}");
        let [size] = score.sizes.as_slice() else {
            panic!("one size")
        };
        assert_eq!((size.detected.count, size.named.count), (0, 0));
        // Normal distribution at 2 - 2.3263, from a table: 0.3721.
        assert!((size.best_possible - 0.3721).abs() < 1e-4);
        // Only what can be seen: neither the empty ones nor the one of two sigma.
        let visible: Vec<&str> = score.visible.strata.keys().map(String::as_str).collect();
        assert_eq!(visible, ["pair", "single", "withheld"]);
        // A substitute that leaves nothing is no failure to notice.
        let left = |sigma| BTreeMap::from([("f".to_owned(), sigma)]);
        let kept = |sigma| {
            let score = super::score(&answers, &truth, &left(sigma)).expect("scored");
            score.visible.strata.contains_key("withheld")
        };
        assert!(kept(3.1) && !kept(2.9));
    }

    #[test]
    fn an_answer_about_another_dataset_is_refused() {
        let truth = Truth {
            seed: 1,
            cases: vec![case("a", "single", "x", "", 9.0)],
        };
        let error = score(&[answer("b", "no_gap", &[], 0.5)], &truth, &BTreeMap::new())
            .expect_err("stranger");
        assert!(error.to_string().contains("sum of b"), "{error}");
    }
}
