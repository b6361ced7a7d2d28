//! How often answers are right, by kind of case.

use super::answers::Pair;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Bins of stated probabilities.
const PROBABILITY_BINS: usize = 10;

/// Rates over a choice of cases.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Rates {
    /// By kind of case.
    pub strata: BTreeMap<String, StratumScore>,
    /// Mean distance between stated probability and share of right sets, over
    /// all sets offered where the library holds the truth.
    pub calibration_error: Option<f64>,
    /// Area under the curve of `none_of_these_p_value`, cases whose effect was
    /// withheld against single effects.
    pub auroc: Option<f64>,
}

impl Rates {
    pub(super) fn of<'a>(cases: impl Iterator<Item = Pair<'a>>) -> Self {
        let mut by_stratum: BTreeMap<String, Vec<Pair<'_>>> = BTreeMap::new();
        for pair in cases {
            let cases = by_stratum.entry(pair.truth.stratum.clone()).or_default();
            cases.push(pair);
        }
        let of = |name: &str| by_stratum.get(name).map_or(&[][..], Vec::as_slice);
        Self {
            calibration_error: calibration_error(&by_stratum),
            auroc: auroc(of("withheld"), of("single")),
            strata: by_stratum
                .iter()
                .map(|(name, cases)| (name.clone(), stratum(cases)))
                .collect(),
        }
    }
}

/// Statistics of one kind of case.
#[derive(Clone, Debug, Serialize, JsonSchema)]
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

fn stratum(cases: &[Pair<'_>]) -> StratumScore {
    let is_gap = cases.iter().any(|c| !c.truth.names.is_empty());
    let withheld = cases.iter().any(|c| c.truth.is_withheld());
    let share = |test: &dyn Fn(&Pair<'_>) -> bool| {
        Share::new(cases.iter().filter(|case| test(case)).count(), cases.len())
    };
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

/// A share of cases with its 95 % interval (Wilson).
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
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

impl Share {
    /// Wilson's interval: never outside of 0..1, and not of no width at its ends.
    pub(super) fn new(count: usize, of: usize) -> Self {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_interval_is_wilsons() {
        // Wilson 1927; 8 of 10: 0.4902 .. 0.9433 (R: binom::binom.wilson).
        let share = Share::new(8, 10);
        assert!((share.low - 0.4902).abs() < 1e-4 && (share.high - 0.9433).abs() < 1e-4);
        assert!(Share::new(0, 300).low < f64::EPSILON);
        assert!(Share::new(0, 300).high > 0.01);
    }
}
