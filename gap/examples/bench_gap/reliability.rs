//! Reliability of the stated probability: of all answers stated with p, which share is right.

use super::case::{Outcome, VISIBLE_SIGMA, is_withheld};
use calib_gap::Verdict;
use std::fmt::Write;

/// A substitute that leaves less is as good as the truth.
pub(super) const LEFT_SIGMA: f64 = 3.0;
/// Share of the weight on cases whose cause the library lacks, where those are counted.
const OUTSIDE: f64 = 0.25;
/// Characters of a full bar.
const BAR: f64 = 40.0;

/// Results of a stratum, with its name and its table.
pub(super) type Stratum<'a> = (&'a str, String, Vec<Outcome>);

/// Classes of answers.
const CLASSES: usize = 10;

/// A set that is listed, as an answer.
#[derive(Clone, Copy)]
struct Stated {
    probability: f64,
    /// Number of its case: the order of equal probabilities, which mixes the strata.
    index: u64,
    right: bool,
    weight: f64,
}

/// How answers are put into classes.
#[derive(Clone, Copy)]
enum By {
    /// By tenths of the range.
    Width,
    /// As many in each, in the order of the probability.
    Count,
}

/// Answers of about the same probability.
#[derive(Clone, Copy, Default)]
struct Class {
    /// Sums of weights, of stated probabilities, and of right answers.
    weight: f64,
    stated: f64,
    right: f64,
    count: usize,
}

impl Class {
    fn add(&mut self, answer: Stated) {
        self.weight += answer.weight;
        self.stated += answer.weight * answer.probability;
        self.right += answer.weight * f64::from(u8::from(answer.right));
        self.count += 1;
    }

    fn mean(&self, sum: f64) -> f64 {
        sum / self.weight.max(f64::MIN_POSITIVE)
    }
}

/// Answers that claim a cause, each with whether the library lacks the true one.
fn claimed<'a>(all: &'a [Stratum<'_>]) -> impl Iterator<Item = (&'a Outcome, bool)> {
    let of = |(stratum, _, outcomes): &'a Stratum<'_>| {
        let outside = is_withheld(stratum);
        // A substitute that leaves less is as good as the truth.
        let counts = move |o: &&Outcome| !outside || o.left_sigma > LEFT_SIGMA;
        outcomes.iter().filter(counts).map(move |o| (o, outside))
    };
    let visible = |o: &Outcome| o.sigma > VISIBLE_SIGMA * o.unkind.hides();
    let claims = |o: &Outcome| !o.is(Verdict::NoGap) && !o.is(Verdict::Data);
    let asked = move |o: &Outcome| !o.truth.is_empty() && visible(o) && claims(o);
    all.iter().flat_map(of).filter(move |(o, _)| asked(o))
}

/// Every set that is listed, in the order of the probability.
fn answers(all: &[Stratum<'_>], with_outside: bool) -> Vec<Stated> {
    let inside = claimed(all).filter(|(_, outside)| !outside).count() as f64;
    let lacking = claimed(all).filter(|(_, outside)| *outside).count() as f64;
    let heavy = inside / lacking.max(1.0) * OUTSIDE / (1.0 - OUTSIDE);
    let counts = claimed(all).filter(|(_, outside)| with_outside || !outside);
    let of = |(outcome, outside): (&Outcome, bool)| -> Vec<Stated> {
        let listed = outcome.answer.causes.iter();
        let stated = listed.map(|cause| Stated {
            probability: cause.probability,
            index: outcome.index,
            right: !outside && outcome.is_right(cause),
            weight: if outside { heavy } else { 1.0 },
        });
        stated.collect()
    };
    let mut answers: Vec<Stated> = counts.flat_map(of).collect();
    answers.sort_by(|a, b| {
        let by_probability = a.probability.total_cmp(&b.probability);
        by_probability.then(a.index.cmp(&b.index))
    });
    answers
}

/// The classes that hold an answer.
fn classes(answers: &[Stated], by: By) -> Vec<Class> {
    let mut classes = [Class::default(); CLASSES];
    for (place, answer) in answers.iter().enumerate() {
        let at = match by {
            By::Width => (answer.probability * CLASSES as f64) as usize,
            By::Count => place * CLASSES / answers.len(),
        };
        classes[at.min(CLASSES - 1)].add(*answer);
    }
    classes.into_iter().filter(|c| c.count > 0).collect()
}

/// The diagrams, with and without causes outside the library.
pub(super) fn text(all: &[Stratum<'_>]) -> String {
    let mut text = String::new();
    for with_outside in [true, false] {
        let share = if with_outside { 100.0 * OUTSIDE } else { 0.0 };
        let answers = answers(all, with_outside);
        for (by, how) in [(By::Width, "by tenths"), (By::Count, "of equal count")] {
            let _ = writeln!(
                text,
                "stated and right, {share:.0} % of the causes outside the library, classes {how}"
            );
            for class in classes(&answers, by) {
                let (stated, right) = (class.mean(class.stated), class.mean(class.right));
                let bar = "#".repeat((BAR * right).round() as usize);
                let _ = writeln!(
                    text,
                    "  {stated:.3} {right:.3} of {:>4}  {bar}",
                    class.count
                );
            }
        }
    }
    text
}

/// The tables as JSON.
pub(super) fn json(all: &[Stratum<'_>]) -> serde_json::Value {
    let class = |c: Class| {
        serde_json::json!({
            "stated": c.mean(c.stated),
            "right": c.mean(c.right),
            "answers": c.count,
        })
    };
    let of = |with_outside: bool, by: By| -> Vec<serde_json::Value> {
        let classes = classes(&answers(all, with_outside), by);
        classes.into_iter().map(class).collect()
    };
    serde_json::json!({
        "outside_share": OUTSIDE,
        "with_outside": of(true, By::Width),
        "within": of(false, By::Width),
        "with_outside_by_count": of(true, By::Count),
        "within_by_count": of(false, By::Count),
    })
}
