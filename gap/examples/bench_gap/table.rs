//! Rates of a stratum, with what the issue of each asks for.

use super::case::Outcome;
use calib_gap::Verdict;
use std::fmt::Write;

/// An effect smaller than this, with its form known, is not asked for by name.
const VISIBLE_SIGMA: f64 = 6.0;
/// A substitute that leaves less is as good as the truth.
const LEFT_SIGMA: f64 = 3.0;

fn share(list: &[&Outcome], is: impl Fn(&Outcome) -> bool) -> (usize, usize) {
    (list.iter().filter(|o| is(o)).count(), list.len())
}

fn quantile(values: &mut [f64], at: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let last = values.len().saturating_sub(1);
    values
        .get((at * last as f64).round() as usize)
        .copied()
        .unwrap_or(f64::NAN)
}

/// Rates of a stratum: name, hits, cases.
fn rates(stratum: &str, all: &[Outcome]) -> Vec<(&'static str, (usize, usize))> {
    let every: Vec<&Outcome> = all.iter().collect();
    let visible: Vec<&Outcome> = all.iter().filter(|o| o.sigma > VISIBLE_SIGMA).collect();
    let left: Vec<&Outcome> = all.iter().filter(|o| o.left_sigma > LEFT_SIGMA).collect();
    let top = |o: &Outcome| o.place().is_some_and(|p| p.0 == 0);
    let covered = |o: &Outcome| o.place().is_some_and(|p| p.1 > 0.05);
    let listed = |o: &Outcome| {
        o.answer
            .causes
            .iter()
            .filter(|c| c.probability > 0.05)
            .count()
    };
    match stratum {
        "null" | "off2u" => vec![("false alarm", share(&every, |o| !o.is(Verdict::NoGap)))],
        "ratio" => vec![
            ("covered, visible", share(&visible, covered)),
            ("covered, all", share(&every, covered)),
            ("at most 4 sets", share(&visible, |o| listed(o) <= 4)),
            (
                "several sets called ambiguous",
                share(
                    &visible
                        .iter()
                        .copied()
                        .filter(|o| listed(o) > 1)
                        .collect::<Vec<_>>(),
                    |o| o.is(Verdict::Ambiguous) || o.answer.causes[0].probability > 0.8,
                ),
            ),
        ],
        "withheld" => vec![
            (
                "unexplained, > 3 sigma left",
                share(&left, |o| o.is(Verdict::Unexplained)),
            ),
            (
                "stage among first two, > 3 sigma left",
                share(&left, Outcome::stage_found),
            ),
            (
                "no answer claimed, all",
                share(&every, |o| o.is(Verdict::Unexplained)),
            ),
        ],
        _ => vec![
            ("top 1, visible", share(&visible, top)),
            ("in set > 5 %, visible", share(&visible, covered)),
            ("top 1, all", share(&every, top)),
            (
                "called unexplained, visible",
                share(&visible, |o| o.is(Verdict::Unexplained)),
            ),
        ],
    }
}

/// Detection and naming over size: decade of sigma, cases, detected, named, detected at best.
fn curve(all: &[Outcome]) -> Vec<(f64, f64, usize, usize, usize, usize)> {
    let edges = [0.0, 2.0, 4.0, 6.0, 10.0, 20.0, 50.0, 200.0, f64::INFINITY];
    let bins = edges.windows(2).map(|edge| {
        let inside: Vec<&Outcome> = all
            .iter()
            .filter(|o| (edge[0]..edge[1]).contains(&o.sigma))
            .collect();
        let detected = share(&inside, |o| !o.is(Verdict::NoGap)).0;
        let named = share(&inside, |o| o.place().is_some_and(|p| p.0 == 0)).0;
        // One parameter at 1 % false alarm: the likelihood ratio needs 2.6 sigma.
        let best = share(&inside, |o| o.sigma > 2.576).0;
        (edge[0], edge[1], inside.len(), detected, named, best)
    });
    bins.collect()
}

/// Largest difference between stated probability and frequency of being right, weighted by cases.
fn calibration_error(all: &[Outcome]) -> f64 {
    let mut bins = [(0.0, 0.0, 0.0); 10];
    for outcome in all.iter().filter(|o| o.sigma > VISIBLE_SIGMA) {
        if let Some(first) = outcome.answer.causes.first() {
            let bin = &mut bins[((first.probability * 10.0) as usize).min(9)];
            let right = outcome.place().is_some_and(|p| p.0 == 0);
            *bin = (
                bin.0 + first.probability,
                bin.1 + f64::from(u8::from(right)),
                bin.2 + 1.0,
            );
        }
    }
    let count: f64 = bins.iter().map(|b| b.2).sum();
    bins.iter().map(|b| (b.0 - b.1).abs()).sum::<f64>() / count.max(1.0)
}

/// Table of a stratum.
pub(super) fn summarise(stratum: &str, all: &[Outcome]) -> String {
    let mut text = format!("{stratum}: {} cases\n", all.len());
    for (name, (hits, of)) in rates(stratum, all) {
        let _ = writeln!(
            text,
            "  {name:<40} {hits:>4} of {of:>4}  {:>6.2} %",
            100.0 * hits as f64 / of.max(1) as f64
        );
    }
    let mut closed: Vec<f64> = all.iter().filter_map(|o| o.answer.gap.closed).collect();
    if !matches!(stratum, "null" | "off2u" | "withheld") {
        let _ = writeln!(text, "  closed, median {:.4}", quantile(&mut closed, 0.5));
        let _ = writeln!(
            text,
            "  calibration error of probability {:.3}",
            calibration_error(all)
        );
    }
    if stratum == "size" {
        for (from, to, cases, detected, named, best) in curve(all) {
            let _ = writeln!(
                text,
                "  {from:>5.0} .. {to:<5.0} sigma: {cases:>4} cases, detected {detected:>4}, named {named:>4}, at best {best:>4}"
            );
        }
    }
    let mut times: Vec<f64> = all.iter().map(|o| o.time_s).collect();
    let _ = write!(
        text,
        "  processor time: median {:.2} s, worst {:.2} s",
        quantile(&mut times, 0.5),
        quantile(&mut times, 1.0)
    );
    text
}

/// Area under the curve: right sets against withheld ones by `none_of_these_p_value`.
fn area(right: &[f64], unknown: &[f64]) -> f64 {
    let mut sum = 0.0;
    for r in right {
        for u in unknown {
            sum += match r.total_cmp(u) {
                std::cmp::Ordering::Greater => 1.0,
                std::cmp::Ordering::Equal => 0.5,
                std::cmp::Ordering::Less => 0.0,
            };
        }
    }
    sum / (right.len() * unknown.len()).max(1) as f64
}

/// AUROC of `none_of_these_p_value`, if both strata were run.
pub(super) fn auroc(all: &[(&str, String, Vec<Outcome>)]) -> Option<f64> {
    let of = |name: &str| {
        all.iter()
            .find(|(stratum, ..)| *stratum == name)
            .map(|s| &s.2)
    };
    let p = |outcomes: &[Outcome]| -> Vec<f64> {
        let chosen = outcomes.iter().filter(|o| o.left_sigma > LEFT_SIGMA);
        chosen.map(|o| o.answer.none_of_these_p_value).collect()
    };
    Some(area(&p(of("single")?), &p(of("withheld")?)))
}

/// Everything as JSON.
pub(super) fn json(seed: u64, all: &[(&str, String, Vec<Outcome>)]) -> String {
    let strata: serde_json::Map<String, serde_json::Value> = all
        .iter()
        .map(|(stratum, _, outcomes)| {
            let rates: serde_json::Map<String, serde_json::Value> = rates(stratum, outcomes)
                .into_iter()
                .map(|(name, (hits, of))| {
                    (name.into(), serde_json::json!({"hits": hits, "of": of}))
                })
                .collect();
            let mut times: Vec<f64> = outcomes.iter().map(|o| o.time_s).collect();
            let mut closed: Vec<f64> = outcomes
                .iter()
                .filter_map(|o| o.answer.gap.closed)
                .collect();
            let curve: Vec<_> = if *stratum == "size" {
                curve(outcomes)
            } else {
                Vec::new()
            };
            let value = serde_json::json!({
                "cases": outcomes.len(),
                "rates": rates,
                "closed_median": quantile(&mut closed, 0.5),
                "calibration_error": calibration_error(outcomes),
                "time_median_s": quantile(&mut times, 0.5),
                "time_worst_s": quantile(&mut times, 1.0),
                "curve": curve,
            });
            ((*stratum).into(), value)
        })
        .collect();
    let value = serde_json::json!({"seed": seed, "strata": strata, "auroc": auroc(all)});
    serde_json::to_string_pretty(&value).unwrap_or_default()
}
