//! Reliability of the stated probability: of all answers stated with p, which share is right.

use super::case::Outcome;
use super::table::{LEFT_SIGMA, VISIBLE_SIGMA};
use calib_gap::{Cause, Verdict};
use std::fmt::Write;

/// Share of the weight on cases whose cause the library lacks, where those are counted.
const OUTSIDE: f64 = 0.25;
/// Characters of a full bar.
const BAR: f64 = 40.0;

/// Results of a stratum, with its name and its table.
type Stratum<'a> = (&'a str, String, Vec<Outcome>);

/// Answers stated with a probability of a tenth of the range.
#[derive(Clone, Copy, Default)]
struct Class {
    /// Sums of weights, of stated probabilities, and of right answers.
    weight: f64,
    stated: f64,
    right: f64,
    count: usize,
}

impl Class {
    fn mean(&self, sum: f64) -> f64 {
        sum / self.weight.max(f64::MIN_POSITIVE)
    }
}

/// Answers that claim a cause, each with whether the library lacks the true one.
fn claimed<'a>(all: &'a [Stratum<'_>]) -> impl Iterator<Item = (&'a Outcome, bool)> {
    let of = |(stratum, _, outcomes): &'a Stratum<'_>| {
        let outside = stratum.ends_with("withheld");
        // A substitute that leaves less is as good as the truth.
        let counts = move |o: &&Outcome| !outside || o.left_sigma > LEFT_SIGMA;
        outcomes.iter().filter(counts).map(move |o| (o, outside))
    };
    let visible = |o: &Outcome| o.sigma > VISIBLE_SIGMA * o.unkind.hides();
    let claims = |o: &Outcome| !o.is(Verdict::NoGap) && !o.is(Verdict::Data);
    let asked = move |o: &Outcome| !o.truth.is_empty() && visible(o) && claims(o);
    all.iter().flat_map(of).filter(move |(o, _)| asked(o))
}

/// Whether a set names what is at work: nothing that is not there, and all that shows beside the rest.
fn is_right(outcome: &Outcome, set: &Cause) -> bool {
    let truth = &outcome.truth;
    let shows = |at: usize| {
        let beside = outcome.conditional_sigma.get(at);
        beside.is_none_or(|sigma| *sigma > VISIBLE_SIGMA)
    };
    let mut asked = (0..truth.len()).filter(|at| shows(*at));
    set.effects.iter().all(|name| truth.contains(name))
        && asked.all(|at| set.effects.contains(&truth[at]))
}

/// Ten classes of the probability of every set that is listed: each is an answer.
fn classes(all: &[Stratum<'_>], with_outside: bool) -> [Class; 10] {
    let inside = claimed(all).filter(|(_, outside)| !outside).count() as f64;
    let lacking = claimed(all).filter(|(_, outside)| *outside).count() as f64;
    let heavy = inside / lacking.max(1.0) * OUTSIDE / (1.0 - OUTSIDE);
    let mut classes = [Class::default(); 10];
    for (outcome, outside) in claimed(all).filter(|(_, outside)| with_outside || !outside) {
        let weight = if outside { heavy } else { 1.0 };
        for cause in &outcome.answer.causes {
            let class = &mut classes[((cause.probability * 10.0) as usize).min(9)];
            class.weight += weight;
            class.stated += weight * cause.probability;
            class.right += weight * f64::from(u8::from(!outside && is_right(outcome, cause)));
            class.count += 1;
        }
    }
    classes
}

/// The diagram, with and without causes outside the library.
pub(super) fn text(all: &[Stratum<'_>]) -> String {
    let mut text = String::new();
    for with_outside in [true, false] {
        let share = if with_outside { 100.0 * OUTSIDE } else { 0.0 };
        let _ = writeln!(
            text,
            "stated and right, {share:.0} % of the causes outside the library"
        );
        for class in classes(all, with_outside).iter().filter(|c| c.count > 0) {
            let (stated, right) = (class.mean(class.stated), class.mean(class.right));
            let bar = "#".repeat((BAR * right).round() as usize);
            let _ = writeln!(
                text,
                "  {stated:.3} {right:.3} of {:>4}  {bar}",
                class.count
            );
        }
    }
    text
}

/// The table as JSON.
pub(super) fn json(all: &[Stratum<'_>]) -> serde_json::Value {
    let of = |with_outside: bool| -> Vec<serde_json::Value> {
        let filled = classes(all, with_outside)
            .into_iter()
            .filter(|c| c.count > 0);
        let class = |c: Class| {
            serde_json::json!({
                "stated": c.mean(c.stated),
                "right": c.mean(c.right),
                "answers": c.count,
            })
        };
        filled.map(class).collect()
    };
    serde_json::json!({"outside_share": OUTSIDE, "with_outside": of(true), "within": of(false)})
}
