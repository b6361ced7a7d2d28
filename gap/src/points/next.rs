//! What to measure next.

use super::places::observable;
use crate::answer::{Cause, Verdict, Where};
use crate::effects::list;
use crate::engine::problem::Problem;
use crate::engine::structure::Structure;

/// The measurement that would tell, in words.
pub(super) fn next_measurement(
    verdict: Verdict,
    causes: &[Cause],
    left: &Structure,
    problem: &Problem,
) -> String {
    let about = |id: &str| list().into_iter().find(|a| a.id == id);
    match verdict {
        Verdict::NoGap => "none needed: repeat the plan after the next change of the rig".into(),
        Verdict::Explained => {
            let first = causes.first().map_or("", |c| c.effects[0]);
            format!(
                "to confirm {first}: {}",
                about(first).map_or("repeat with another run", |a| a.separate_by)
            )
        }
        Verdict::Ambiguous => match causes {
            [first, second, ..] => {
                let differing = first
                    .effects
                    .iter()
                    .find(|e| !second.effects.contains(*e))
                    .unwrap_or(&first.effects[0]);
                let how = about(differing).map_or("more points", |a| a.separate_by);
                format!(
                    "to tell {} from {}: {how}",
                    first.effects.join("+"),
                    second.effects.join("+")
                )
            }
            _ => "repeat the points with the smallest probability of noise in another run".into(),
        },
        Verdict::Unexplained => {
            let worst = left
                .outcomes
                .iter()
                .max_by(|a, b| a.z.abs().total_cmp(&b.z.abs()));
            let (name, axis) =
                worst.map_or(("ratio", "frequency_hz"), |w| (observable(w.slot), w.axis));
            let band = (problem.facts.lowest_hz, problem.facts.highest_hz);
            format!(
                "more points of {name} along {axis} between {} Hz and {} Hz, in at least two runs",
                band.0, band.1
            )
        }
    }
}

/// What tells where bumps come from.
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
