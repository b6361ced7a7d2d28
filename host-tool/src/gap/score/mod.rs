//! What answers to a sealed set are worth.

use super::truth::{TrueCase, Truth};
use crate::{Error, Result, text_file};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// Probability above which a set counts as offered.
const OFFERED: f64 = 0.05;
/// Edges of the sizes over which detection and naming are counted, in sigma.
const SIZE_EDGES: [f64; 7] = [1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1001.0];
/// Deviate of a one-sided test with 1 % false alarms.
const DEVIATE_OF_ONE_PERCENT: f64 = 2.326_347_874;
/// Bins of stated probabilities.
const PROBABILITY_BINS: usize = 10;

/// What scoring needs of an answer; anybody's diagnosis can write these fields.
#[derive(Clone, Debug, Deserialize)]
pub struct ScoredAnswer {
    verdict: String,
    causes: Vec<ScoredCause>,
    none_of_these_p_value: f64,
    #[serde(default)]
    r#where: Vec<Place>,
    gap: Closed,
    dataset: Identity,
}

#[derive(Clone, Debug, Deserialize)]
struct ScoredCause {
    effects: Vec<String>,
    probability: f64,
}

#[derive(Clone, Debug, Deserialize)]
struct Place {
    stage: String,
}

#[derive(Clone, Debug, Deserialize)]
struct Closed {
    closed: Option<f64>,
}

#[derive(Clone, Debug, Deserialize)]
struct Identity {
    sha256: String,
}

/// A share of cases with its 95 % interval (Wilson).
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Share {
    /// Cases that count.
    pub count: usize,
    /// Cases there are.
    pub of: usize,
    /// Their quotient.
    pub share: f64,
    /// Lower end of the 95 % interval.
    pub low: f64,
    /// Its upper end.
    pub high: f64,
}

/// Statistics of one kind of case.
#[derive(Clone, Debug, Serialize)]
pub struct StratumScore {
    /// Cases in the set.
    pub cases: usize,
    /// Cases without an answer; they count as wrong below.
    pub unanswered: usize,
    /// The best set is the true one.
    pub top_1: Option<Share>,
    /// The true set is among those above 5 % probability.
    pub truth_covered: Option<Share>,
    /// Anything but "no gap" where there is none.
    pub false_alarm: Option<Share>,
    /// Anything but "no gap" where there is one.
    pub detected: Option<Share>,
    /// "Explained" by a wrong set.
    pub confidently_wrong: Share,
    /// Verdict "unexplained".
    pub unexplained: Share,
    /// Verdict "ambiguous".
    pub ambiguous: Share,
    /// A stage of the true effects is among the first two of `where`.
    pub stage_among_two: Option<Share>,
    /// Median number of sets above 5 %.
    pub median_sets: f64,
    /// Median share of the gap closed on held-out rows.
    pub median_closed: Option<f64>,
}

/// Detection and naming of effects of one range of sizes.
#[derive(Clone, Debug, Serialize)]
pub struct SizeScore {
    /// Smallest size, standard uncertainties of the whole dataset.
    pub from_sigma: f64,
    /// Largest.
    pub to_sigma: f64,
    /// Anything but "no gap".
    pub detected: Share,
    /// The best set is the true one.
    pub named: Share,
    /// Detection by a likelihood ratio that knows form and size, with 1 % false
    /// alarms, no nominal parameter free: no diagnosis does better.
    pub best_possible: f64,
}

/// Everything about a set of answers.
#[derive(Clone, Debug, Serialize)]
pub struct Score {
    /// By kind of case.
    pub strata: BTreeMap<String, StratumScore>,
    /// Mean distance between stated probability and share of right sets, over
    /// all sets offered where the library holds the truth.
    pub calibration_error: Option<f64>,
    /// Area under the curve of `none_of_these_p_value`, cases whose effect was
    /// withheld against single effects.
    pub auroc: Option<f64>,
    /// Detection and naming over size.
    pub sizes: Vec<SizeScore>,
}

/// Reads answers: JSON lines, or one JSON array.
///
/// # Errors
/// [`Error::File`]; [`Error::Input`] with the line.
pub fn read_answers(path: &Path) -> Result<Vec<ScoredAnswer>> {
    let text = text_file::read(path)?;
    let broken = |line: usize, error: serde_json::Error| {
        let place = format!("{}:{line}", path.display());
        let hint = "answers are what `calib gap diagnose --json` prints, one per line";
        Error::input(place, error.to_string(), hint)
    };
    if text.trim_start().starts_with('[') {
        return serde_json::from_str(&text).map_err(|e| broken(e.line(), e));
    }
    let lines = text.lines().enumerate();
    let filled = lines.filter(|(_, line)| !line.trim().is_empty());
    filled
        .map(|(at, line)| serde_json::from_str(line).map_err(|e| broken(at + 1, e)))
        .collect()
}

/// Scores answers against the truth; they are matched by the SHA-256 of the dataset.
///
/// # Errors
/// [`Error::Input`] when an answer is about a dataset that is not in the set.
pub fn score(answers: &[ScoredAnswer], truth: &Truth) -> Result<Score> {
    let pairs = matched(answers, truth)?;
    let mut by_stratum: BTreeMap<String, Vec<Pair<'_>>> = BTreeMap::new();
    for pair in pairs {
        let cases = by_stratum.entry(pair.truth.stratum.clone()).or_default();
        cases.push(pair);
    }
    let of = |name: &str| by_stratum.get(name).map_or(&[][..], Vec::as_slice);
    Ok(Score {
        calibration_error: calibration_error(&by_stratum),
        auroc: auroc(of("withheld"), of("single")),
        sizes: sizes(of("size")),
        strata: by_stratum
            .iter()
            .map(|(name, cases)| (name.clone(), stratum(cases)))
            .collect(),
    })
}

/// A case with its answer, if there is one.
struct Pair<'a> {
    truth: &'a TrueCase,
    answer: Option<&'a ScoredAnswer>,
}

fn matched<'a>(answers: &'a [ScoredAnswer], truth: &'a Truth) -> Result<Vec<Pair<'a>>> {
    let mut by_sum: BTreeMap<&str, &ScoredAnswer> = BTreeMap::new();
    for answer in answers {
        by_sum.insert(&answer.dataset.sha256, answer);
    }
    let known = |sum: &str| truth.cases.iter().any(|case| case.dataset_sha256 == sum);
    if let Some(stranger) = by_sum.keys().find(|sum| !known(sum)) {
        return Err(Error::input(
            "answers",
            format!(
                "hold one about a dataset with SHA-256 {stranger}, which is not in the sealed set"
            ),
            "diagnose the folders of the set as they were sealed",
        ));
    }
    let pair = |case: &'a TrueCase| Pair {
        truth: case,
        answer: by_sum.get(case.dataset_sha256.as_str()).copied(),
    };
    Ok(truth.cases.iter().map(pair).collect())
}

impl Pair<'_> {
    fn is(&self, verdict: &str) -> bool {
        self.answer.is_some_and(|answer| answer.verdict == verdict)
    }

    fn is_true_set(&self, effects: &[String]) -> bool {
        let mut sorted = effects.to_vec();
        sorted.sort();
        sorted == self.truth.names
    }

    fn alarmed(&self) -> bool {
        self.answer.is_some_and(|a| a.verdict != "no_gap")
    }

    fn named(&self) -> bool {
        let first = self.answer.and_then(|a| a.causes.first());
        self.alarmed() && first.is_some_and(|cause| self.is_true_set(&cause.effects))
    }

    fn offered(&self) -> impl Iterator<Item = &ScoredCause> {
        let causes = self.answer.map_or(&[][..], |a| a.causes.as_slice());
        causes.iter().filter(|c| c.probability > OFFERED)
    }

    fn stage_found(&self) -> bool {
        let places = self.answer.map_or(&[][..], |a| a.r#where.as_slice());
        let mut first = places.iter().take(2);
        first.any(|place| self.truth.stages.contains(&place.stage))
    }
}

fn stratum(cases: &[Pair<'_>]) -> StratumScore {
    let is_gap = cases.iter().any(|c| !c.truth.names.is_empty());
    let withheld = cases
        .iter()
        .any(|c| c.truth.names.iter().any(|n| c.truth.without.contains(n)));
    let share = |test: &dyn Fn(&Pair<'_>) -> bool| Share::of(cases, test);
    let can_name = is_gap && !withheld;
    let mut sets: Vec<f64> = cases.iter().map(|c| c.offered().count() as f64).collect();
    let closed = cases.iter().filter_map(|c| c.answer?.gap.closed);
    StratumScore {
        cases: cases.len(),
        unanswered: cases.iter().filter(|c| c.answer.is_none()).count(),
        top_1: can_name.then(|| share(&|c| c.named())),
        truth_covered: can_name
            .then(|| share(&|c| c.offered().any(|cause| c.is_true_set(&cause.effects)))),
        false_alarm: (!is_gap).then(|| share(&|c| c.alarmed())),
        detected: is_gap.then(|| share(&|c| c.alarmed())),
        confidently_wrong: share(&|c| c.is("explained") && !c.named()),
        unexplained: share(&|c| c.is("unexplained")),
        ambiguous: share(&|c| c.is("ambiguous")),
        stage_among_two: is_gap.then(|| share(&|c| c.stage_found())),
        median_sets: median(&mut sets).unwrap_or(0.0),
        median_closed: median(&mut closed.collect::<Vec<_>>()),
    }
}

impl Share {
    fn of(cases: &[Pair<'_>], test: &dyn Fn(&Pair<'_>) -> bool) -> Self {
        Self::new(cases.iter().filter(|case| test(case)).count(), cases.len())
    }

    /// Wilson's interval: never outside of 0..1, and not of no width at its ends.
    fn new(count: usize, of: usize) -> Self {
        let n = (of as f64).max(1.0);
        let share = count as f64 / n;
        let z = 1.959_963_985_f64;
        let middle = share + z * z / (2.0 * n);
        let half = z * (share * (1.0 - share) / n + z * z / (4.0 * n * n)).sqrt();
        let whole = 1.0 + z * z / n;
        Self {
            count,
            of,
            share,
            low: ((middle - half) / whole).max(0.0),
            high: ((middle + half) / whole).min(1.0),
        }
    }
}

fn median(values: &mut [f64]) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    match values.len() {
        0 => None,
        n if n % 2 == 1 => Some(values[middle]),
        _ => Some(0.5 * (values[middle - 1] + values[middle])),
    }
}

/// Strata where the library holds the truth and there is one.
const NAMEABLE: [&str; 4] = ["single", "pair", "ratio-only", "decoy"];

fn calibration_error(by_stratum: &BTreeMap<String, Vec<Pair<'_>>>) -> Option<f64> {
    let mut bins = [(0.0, 0.0, 0.0); PROBABILITY_BINS];
    for pair in NAMEABLE
        .iter()
        .filter_map(|name| by_stratum.get(*name))
        .flatten()
    {
        for cause in pair.answer.map_or(&[][..], |a| a.causes.as_slice()) {
            let at = (cause.probability * PROBABILITY_BINS as f64) as usize;
            let bin = &mut bins[at.min(PROBABILITY_BINS - 1)];
            bin.0 += 1.0;
            bin.1 += cause.probability;
            bin.2 += f64::from(u8::from(pair.is_true_set(&cause.effects)));
        }
    }
    let all: f64 = bins.iter().map(|bin| bin.0).sum();
    let off: f64 = bins.iter().map(|bin| (bin.1 - bin.2).abs()).sum();
    (all > 0.0).then(|| off / all)
}

/// Probability that a withheld case has the smaller p-value; ties count half.
fn auroc(withheld: &[Pair<'_>], known: &[Pair<'_>]) -> Option<f64> {
    let values = |pairs: &[Pair<'_>]| -> Vec<f64> {
        let answers = pairs.iter().filter_map(|pair| pair.answer);
        answers.map(|a| a.none_of_these_p_value).collect()
    };
    let (low, high) = (values(withheld), values(known));
    let count = (low.len() * high.len()) as f64;
    let wins = |a: &f64| -> f64 {
        let win = |b: &f64| {
            if a < b {
                1.0
            } else {
                f64::from(u8::from(a == b)) / 2.0
            }
        };
        high.iter().map(win).sum()
    };
    (count > 0.0).then(|| low.iter().map(wins).sum::<f64>() / count)
}

fn sizes(cases: &[Pair<'_>]) -> Vec<SizeScore> {
    let mut scores = Vec::new();
    for edge in SIZE_EDGES.windows(2) {
        let inside = |c: &&Pair<'_>| (edge[0]..edge[1]).contains(&c.truth.size_sigma);
        let chosen: Vec<&Pair<'_>> = cases.iter().filter(inside).collect();
        let count = |test: &dyn Fn(&Pair<'_>) -> bool| {
            Share::new(chosen.iter().filter(|c| test(c)).count(), chosen.len())
        };
        let power = |c: &&Pair<'_>| normal(c.truth.size_sigma - DEVIATE_OF_ONE_PERCENT);
        if !chosen.is_empty() {
            scores.push(SizeScore {
                from_sigma: edge[0],
                to_sigma: edge[1],
                detected: count(&|c| c.alarmed()),
                named: count(&|c| c.named()),
                best_possible: chosen.iter().map(power).sum::<f64>() / chosen.len() as f64,
            });
        }
    }
    scores
}

/// Distribution function of the standard normal.
fn normal(z: f64) -> f64 {
    0.5 * statrs::function::erf::erfc(-z / std::f64::consts::SQRT_2)
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let score = score(&answers, &truth).expect("scored");
        let single = &score.strata["single"];
        let counts = |share: Option<Share>| share.map(|s| (s.count, s.of));
        assert_eq!(counts(single.top_1), Some((1, 3)));
        assert_eq!(counts(single.truth_covered), Some((2, 3)));
        assert_eq!(counts(single.detected), Some((2, 3)));
        assert_eq!((single.unanswered, single.ambiguous.count), (1, 1));
        let null = &score.strata["null"];
        assert_eq!(counts(null.false_alarm), Some((1, 2)));
        assert!(null.top_1.is_none() && null.detected.is_none());
        assert_eq!(null.confidently_wrong.count, 1);
        assert_eq!(counts(score.strata["pair"].top_1), Some((1, 1)));
        let withheld = &score.strata["withheld"];
        assert!(withheld.top_1.is_none());
        assert_eq!(counts(withheld.stage_among_two), Some((1, 1)));
        // p of the withheld case: 0.3, of the singles: 0.5 and 0.3: one win, one tie.
        assert_eq!(score.auroc, Some(0.75));
        // Bins by hand: 0.9 right, 0.1 wrong, 0.6 wrong, 0.4 right, 1.0 right; 0.9 and 1.0 share
        // the highest bin: |1.9 - 2| + 0.1 + 0.6 + |0.4 - 1| over five.
        let error = score.calibration_error.expect("there are causes");
        assert!((error - 1.4 / 5.0).abs() < 1e-12, "{error}");
        let [size] = score.sizes.as_slice() else {
            panic!("one size")
        };
        assert_eq!((size.detected.count, size.named.count), (0, 0));
        // Normal distribution at 2 - 2.3263, from a table: 0.3721.
        assert!((size.best_possible - 0.3721).abs() < 1e-4);
    }

    #[test]
    fn an_interval_is_wilsons() {
        // Wilson 1927; 8 of 10: 0.4902 .. 0.9433 (R: binom::binom.wilson).
        let share = Share::new(8, 10);
        assert!((share.low - 0.4902).abs() < 1e-4 && (share.high - 0.9433).abs() < 1e-4);
        assert!(Share::new(0, 300).low < f64::EPSILON);
        assert!(Share::new(0, 300).high > 0.01);
    }

    #[test]
    fn an_answer_about_another_dataset_is_refused() {
        let truth = Truth {
            seed: 1,
            cases: vec![case("a", "single", "x", "", 9.0)],
        };
        let error = score(&[answer("b", "no_gap", &[], 0.5)], &truth).expect_err("stranger");
        assert!(error.to_string().contains("sum of b"), "{error}");
    }
}
