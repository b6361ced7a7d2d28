//! Next measurement.

use super::lack_of_fit::LackOfFit;
use super::problem::Problem;
use crate::answer::{Cause, Verdict, Where};
use crate::axis::Axis;
use crate::observable::Group;
use calib_effects::{Of, named};

/// The measurement that would tell, in words.
pub(super) fn next_measurement(
    verdict: Verdict,
    causes: &[Cause],
    left: &LackOfFit,
    problem: &Problem,
) -> String {
    match (verdict, causes) {
        (Verdict::NoGap, _) => {
            "none needed: repeat the plan after the next change of the rig".into()
        }
        (Verdict::Explained, _) => {
            let first = causes.first().map_or("", |c| c.effects[0]);
            format!(
                "to confirm {first}: {}",
                separate_by(first).unwrap_or("repeat with another run")
            )
        }
        (Verdict::Ambiguous, [first, second, ..]) => to_tell(first, second),
        (Verdict::Ambiguous, _) => {
            "repeat the points with the smallest probability of noise in another run".into()
        }
        (Verdict::Unexplained, _) => more_points(left, problem),
    }
}

/// The measurement that tells an effect from those it is mistaken for.
fn separate_by(id: &str) -> Option<&'static str> {
    named(Of::Calibrator, id).map(|entry| entry.separate_by)
}

/// Measures the part of the first cause that the second lacks.
fn to_tell(first: &Cause, second: &Cause) -> String {
    let mut lacking = first
        .effects
        .iter()
        .filter(|e| !second.effects.contains(*e));
    let differing = lacking.next().unwrap_or(&first.effects[0]);
    format!(
        "to tell {} from {}: {}",
        first.effects.join("+"),
        second.effects.join("+"),
        separate_by(differing).unwrap_or("more points")
    )
}

/// More of what deviates most.
fn more_points(left: &LackOfFit, problem: &Problem) -> String {
    let outcomes = left.outcomes.iter();
    let worst = outcomes.max_by(|a, b| a.z.abs().total_cmp(&b.z.abs()));
    let usual = (Group::Ratio, Axis::Frequency);
    let (group, axis) = worst.map_or(usual, |w| (w.observable.group(), w.axis));
    format!(
        "more points of {} along {} between {} Hz and {} Hz, in at least two runs",
        group.name(),
        axis.name(),
        problem.facts.lowest_hz,
        problem.facts.highest_hz
    )
}

/// Measurement that tells where bumps come from.
pub(super) fn sweep(local: &[Where]) -> Option<String> {
    let range = |place: &Where| match place.from == place.to {
        true => format!("{} Hz", place.from),
        false => format!("{} .. {} Hz", place.from, place.to),
    };
    let ranges: Vec<String> = local.iter().map(range).collect();
    (!ranges.is_empty()).then(|| {
        format!(
            "a finer sweep about {}, once as it is and once mounted anew with another cable and \
             adapter: a bump that moves belongs to the mounting",
            ranges.join(", ")
        )
    })
}
