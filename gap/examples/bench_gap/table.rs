//! Rates of a stratum, with what the issue of each asks for.

use super::case::{Outcome, VISIBLE_SIGMA};
use super::reliability::{self, LEFT_SIGMA, Stratum};
use calib_gap::{Group, Verdict};
use std::fmt::Write;

/// Probability from which a set is possible.
const POSSIBLE: f64 = 0.05;
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

/// A rate: its name, hits and cases.
type Rate = (&'static str, (usize, usize));

/// The cases of a stratum by what may be asked of them.
struct Cases<'a> {
    every: Vec<&'a Outcome>,
    /// Those whose effect stands out of the noise.
    visible: Vec<&'a Outcome>,
    /// Those of which any substitute leaves something.
    left: Vec<&'a Outcome>,
}

/// Rates of a stratum.
fn rates(stratum: &str, all: &[Outcome]) -> Vec<Rate> {
    let cases = Cases {
        every: all.iter().collect(),
        visible: all.iter().filter(|o| o.sigma > VISIBLE_SIGMA).collect(),
        left: all.iter().filter(|o| o.left_sigma > LEFT_SIGMA).collect(),
    };
    match stratum {
        "null" | "off2u" => vec![(
            "false alarm",
            share(&cases.every, |o| !o.is(Verdict::NoGap)),
        )],
        "ratio" => rates_of_ratios(&cases),
        "triples" | "opened" => rates_of_several(&cases),
        "beside" => rates_beside(&cases),
        "withheld" | "later_withheld" | "record_withheld" => rates_of_withheld(&cases),
        "form" | "record_form" => rates_of_forms(&cases),
        "noise_1.2" | "noise_2" | "misread" | "memory" => rates_of_noise(&cases),
        "unkind" => rates_under_noise(&cases),
        _ => rates_of_named(&cases),
    }
}

/// Where nothing is wrong but the noise: what it is, and no cause.
fn rates_of_noise(cases: &Cases<'_>) -> Vec<Rate> {
    let quiet = |o: &Outcome| o.is(Verdict::NoGap) || o.is(Verdict::Data);
    let named = |o: &Outcome| {
        let first = o.answer.causes.first();
        !quiet(o) && first.is_some_and(|c| c.probability > POSSIBLE)
    };
    let of = |is: &dyn Fn(&Outcome) -> bool| share(&cases.every, is);
    vec![
        ("false explained", of(&|o| o.is(Verdict::Explained))),
        ("a name of p > 0.05 beside a gap", of(&named)),
        ("called data", of(&|o| o.is(Verdict::Data))),
        ("called unexplained", of(&|o| o.is(Verdict::Unexplained))),
        ("data: factors, memory or rows right", of(&says_what)),
    ]
}

/// Most that a factor may be off, relative.
const FACTOR_OFF: f64 = 0.1;
/// Most that a memory may be off: what 200 rows know of it, three times.
const MEMORY_OFF: f64 = 0.15;

/// Whether an answer says how the noise differs from what is stated, and nothing else.
fn says_what(outcome: &Outcome) -> bool {
    let (noise, truth) = (&outcome.answer.noise, &outcome.unkind);
    let misread: Vec<usize> = truth.misread.iter().map(|row| row + 1).collect();
    // The noise columns state no uncertainty of their own and are as they should be.
    let every = [
        Group::Ratio,
        Group::Drive,
        Group::Current,
        Group::RefHarmonics,
        Group::DutHarmonics,
        Group::Dc,
    ];
    let factor_right = |group: &Group| {
        let found = noise.factor_on_u.get(group).copied().unwrap_or(1.0);
        (found / truth.factor.unwrap_or(1.0) - 1.0).abs() < FACTOR_OFF
    };
    let memory_right = |group: &Group| {
        let found = noise.memory.get(group).copied().unwrap_or(0.0);
        (found - truth.memory.unwrap_or(0.0)).abs() < MEMORY_OFF
    };
    outcome.is(Verdict::Data)
        && noise.outlier_rows == misread
        && every.iter().all(memory_right)
        // Rows that remember say less of how much they scatter.
        && (truth.memory.is_some() || every.iter().all(factor_right))
}

/// Where an effect has another form than the library's: its name, and no claim that the form is known.
fn rates_of_forms(cases: &Cases<'_>) -> Vec<Rate> {
    let among = |o: &Outcome| {
        let first = o.answer.causes.first();
        first.is_some_and(|c| o.truth.iter().all(|t| c.effects.contains(t)))
    };
    let holds =
        |o: &Outcome| among(o) && (o.is(Verdict::Explained) || o.is(Verdict::PartlyExplained));
    vec![
        ("name first, visible", share(&cases.visible, is_first)),
        (
            "name in the first set, visible",
            share(&cases.visible, among),
        ),
        (
            "the same, explained or in part",
            share(&cases.visible, holds),
        ),
        (
            "called unexplained, visible",
            share(&cases.visible, |o| o.is(Verdict::Unexplained)),
        ),
    ]
}

/// Where the library has the effect and the noise is not what is stated.
fn rates_under_noise(cases: &Cases<'_>) -> Vec<Rate> {
    let kind = |is: &dyn Fn(&Outcome) -> bool| -> Vec<&Outcome> {
        let visible = |o: &&&Outcome| o.sigma > VISIBLE_SIGMA * o.unkind.hides();
        let of_kind = cases.every.iter().filter(visible).copied();
        of_kind.filter(|o| is(o)).collect()
    };
    let misread = kind(&|o| !o.unkind.misread.is_empty());
    let has_partner = |o: &Outcome| {
        let first = o.answer.causes.first();
        first.is_some_and(|c| c.effects.len() > o.truth.len())
    };
    vec![
        ("top 1, all kinds", share(&kind(&|_| true), is_first)),
        (
            "top 1, 1.2 u",
            share(&kind(&|o| o.unkind.factor == Some(1.2)), is_first),
        ),
        (
            "top 1, 2 u",
            share(&kind(&|o| o.unkind.factor == Some(2.0)), is_first),
        ),
        ("top 1, misread rows", share(&misread, is_first)),
        (
            "top 1, memory",
            share(&kind(&|o| o.unkind.memory.is_some()), is_first),
        ),
        ("spurious partner", share(&kind(&|_| true), has_partner)),
    ]
}

/// Where only the ratio was measured: the truth among few sets, and no more certainty than there is.
fn rates_of_ratios(cases: &Cases<'_>) -> Vec<Rate> {
    let listed = |o: &Outcome| {
        let causes = o.answer.causes.iter();
        causes.filter(|c| c.probability > POSSIBLE).count()
    };
    let several = cases.visible.iter().copied().filter(|o| listed(o) > 1);
    vec![
        ("covered, visible", share(&cases.visible, is_covered)),
        ("covered, all", share(&cases.every, is_covered)),
        ("at most 4 sets", share(&cases.visible, |o| listed(o) <= 4)),
        (
            "several sets called ambiguous",
            share(&several.collect::<Vec<_>>(), |o| {
                o.is(Verdict::Ambiguous) || o.answer.causes[0].probability > 0.8
            }),
        ),
    ]
}

/// Where the library lacks the effect: no name for it, and the right part of the chain.
fn rates_of_withheld(cases: &Cases<'_>) -> Vec<Rate> {
    let in_part = |o: &Outcome| o.is(Verdict::PartlyExplained);
    let unexplained = |o: &Outcome| o.is(Verdict::Unexplained) || in_part(o);
    let doubted = |o: &Outcome| o.answer.probability_other > 0.5;
    vec![
        (
            "unexplained or in part, > 3 sigma left",
            share(&cases.left, unexplained),
        ),
        ("of these in part", share(&cases.left, in_part)),
        ("outside the library p > 0.5", share(&cases.left, doubted)),
        (
            "stage among first two, > 3 sigma left",
            share(&cases.left, Outcome::stage_found),
        ),
        ("no answer claimed, all", share(&cases.every, unexplained)),
    ]
}

/// Size of each of several effects beside the others where it is asked for by name, in sigma.
const CONDITIONAL_SIGMA: f64 = 12.0;
/// Correlation of two shapes from which their names count as one.
const SAME_SHAPE: f64 = 0.95;

/// Whether the leading set is the true one, or has names of the same shape in it: of what such a name
/// replaces, 1 - 0.95^2 of the square is left at most.
fn is_first_by_shape(outcome: &Outcome) -> bool {
    let Some(first) = outcome.answer.causes.first() else {
        return false;
    };
    let sizes = outcome.truth.iter().zip(&outcome.conditional_sigma);
    let replaced = sizes.filter(|(name, _)| !first.effects.contains(name));
    let square: f64 = replaced.map(|(_, sigma)| sigma * sigma).sum();
    first.effects.len() == outcome.truth.len()
        && outcome.left_sigma.powi(2) <= (1.0 - SAME_SHAPE * SAME_SHAPE) * square
}

/// Where three effects are at work, each large enough beside the others.
fn rates_of_several(cases: &Cases<'_>) -> Vec<Rate> {
    let large = |o: &&&Outcome| {
        let mut sizes = o.conditional_sigma.iter();
        sizes.all(|sigma| *sigma >= CONDITIONAL_SIGMA)
    };
    let large: Vec<&Outcome> = cases.every.iter().filter(large).copied().collect();
    let partly = |o: &Outcome| {
        let first = o.answer.causes.first();
        first.is_some_and(|c| c.effects.iter().all(|name| o.truth.contains(name)))
    };
    vec![
        ("all first, each > 12 sigma", share(&large, is_first)),
        (
            "the same, or of their shape",
            share(&large, |o| is_first(o) || is_first_by_shape(o)),
        ),
        ("no wrong name in the first set", share(&large, partly)),
        (
            "called unexplained",
            share(&large, |o| o.is(Verdict::Unexplained)),
        ),
        (
            "called explained in part",
            share(&large, |o| o.is(Verdict::PartlyExplained)),
        ),
    ]
}

/// Where one effect is at least thirty times the other: both, or honestly one.
fn rates_beside(cases: &Cases<'_>) -> Vec<Rate> {
    let far_apart = |o: &&&Outcome| match o.conditional_sigma[..] {
        [small, large] => large > VISIBLE_SIGMA && large > 30.0 * small,
        _ => false,
    };
    let apart: Vec<&Outcome> = cases.every.iter().filter(far_apart).copied().collect();
    let one = |o: &Outcome| {
        let first = o.answer.causes.first();
        first.is_some_and(|c| c.effects == o.truth[1..])
    };
    // To claim that one is all there is, where the other shows, is not honest.
    let shows = |o: &Outcome| o.conditional_sigma[0] > CONDITIONAL_SIGMA;
    let honest = |o: &Outcome| one(o) && !(shows(o) && o.is(Verdict::Explained));
    vec![
        (
            "both, or honestly one",
            share(&apart, |o| is_first(o) || honest(o)),
        ),
        ("both", share(&apart, is_first)),
        (
            "one that claims to be all",
            share(&apart, |o| one(o) && !honest(o)),
        ),
        (
            "called unexplained",
            share(&apart, |o| o.is(Verdict::Unexplained)),
        ),
    ]
}

/// Where the library has the effects: their names.
fn rates_of_named(cases: &Cases<'_>) -> Vec<Rate> {
    vec![
        ("top 1, visible", share(&cases.visible, is_first)),
        ("in set > 5 %, visible", share(&cases.visible, is_covered)),
        ("top 1, all", share(&cases.every, is_first)),
        (
            "called unexplained, visible",
            share(&cases.visible, |o| o.is(Verdict::Unexplained)),
        ),
        (
            "called explained in part, visible",
            share(&cases.visible, |o| o.is(Verdict::PartlyExplained)),
        ),
    ]
}

/// Whether the truth is the most probable set.
pub(super) fn is_first(outcome: &Outcome) -> bool {
    outcome.place().is_some_and(|p| p.0 == 0)
}

/// Whether the truth is among the possible sets.
fn is_covered(outcome: &Outcome) -> bool {
    outcome.place().is_some_and(|p| p.1 > POSSIBLE)
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
        let named = share(&inside, is_first).0;
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
            let right = is_first(outcome);
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
    let mut closed: Vec<f64> = all
        .iter()
        .filter_map(|o| o.answer.gap.size.closed)
        .collect();
    if all.iter().any(|o| !o.truth.is_empty()) && !stratum.ends_with("withheld") {
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
pub(super) fn auroc(all: &[Stratum<'_>]) -> Option<f64> {
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
pub(super) fn json(seed: u64, points: &[Stratum<'_>], records: &[Stratum<'_>]) -> String {
    let strata: serde_json::Map<String, serde_json::Value> = points
        .iter()
        .chain(records)
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
                .filter_map(|o| o.answer.gap.size.closed)
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
    let value = serde_json::json!({
        "seed": seed,
        "strata": strata,
        "auroc": auroc(points),
        "reliability": reliability::json(points),
        "reliability_of_records": reliability::json(records),
    });
    serde_json::to_string_pretty(&value).unwrap_or_default()
}
