//! The first screen: what was found, where, how sure, how far, what next.

use super::chain::chain;
use super::{escape, plain};
use crate::answer::{Answer, Verdict};
use std::fmt::Write;

/// Writes the first screen of one answer.
pub(super) fn first_screen(page: &mut String, answer: &Answer) {
    let (badge, class) = match answer.verdict {
        Verdict::NoGap => ("no gap", "good"),
        Verdict::Explained => ("explained", "good"),
        Verdict::Ambiguous => ("not decided yet", "open"),
        Verdict::Unexplained => ("not explained", "bad"),
    };
    let _ = write!(
        page,
        "<p class=path>{}</p><h1>{} <span class='badge {class}'>{badge}</span></h1><p class=lead>{}</p>",
        escape(&answer.dataset.path),
        headline(answer),
        sentence(answer)
    );
    if answer.gap.by_observable.contains_key("output") {
        // An oscillator has no chain.
    } else if answer.verdict != Verdict::NoGap {
        page.push_str(&chain(&suspects(answer)));
    }
    bars(page, answer);
    page.push_str(&elsewhere(answer));
    let _ = write!(
        page,
        "<p class=next><b>What to do next:</b> {}.</p>",
        escape(&answer.next_measurement)
    );
}

fn headline(answer: &Answer) -> String {
    let first = answer.causes.first();
    let words = first.map_or(String::new(), |cause| {
        let all = cause.effects.iter().filter_map(|id| plain::effect(id));
        all.collect::<Vec<_>>().join(", and ")
    });
    match answer.verdict {
        Verdict::NoGap => "Simulation and measurement agree".into(),
        Verdict::Explained => format!("The simulation does not know that {words}"),
        Verdict::Ambiguous => "More than one cause fits these data".into(),
        Verdict::Unexplained => "Something is missing that has no name here".into(),
    }
}

fn sentence(answer: &Answer) -> String {
    let gap = &answer.gap;
    let names = |at: usize| {
        answer
            .causes
            .get(at)
            .map_or(String::new(), |cause| cause.effects.join(" + "))
    };
    match answer.verdict {
        Verdict::NoGap => "What differs is no more than the stated uncertainties allow.".into(),
        Verdict::Explained => format!(
            "Once <code>{}</code> is added, the simulation misses the measurement by {} instead of {}; \
             the measurement's own noise is {}. The name is held to be right with a probability of {}.",
            names(0),
            percent(gap.after_percent),
            percent(gap.before_percent),
            percent(gap.floor_percent),
            probability(answer.causes.first().map_or(0.0, |c| c.probability)),
        ),
        Verdict::Ambiguous => {
            let list: Vec<String> = answer
                .causes
                .iter()
                .filter(|cause| cause.probability > 0.05)
                .map(|cause| {
                    format!(
                        "<code>{}</code> ({})",
                        cause.effects.join(" + "),
                        probability(cause.probability)
                    )
                })
                .collect();
            format!(
                "These fit about equally well: {}. The measurement named below tells them apart.",
                list.join(", ")
            )
        }
        Verdict::Unexplained => unexplained(answer, &names(0)),
    }
}

fn unexplained(answer: &Answer, best: &str) -> String {
    let place = answer.r#where.first().map_or(String::new(), |place| {
        format!(
            " It points to {} and shows in {}, {}.",
            plain::stage(place.stage),
            plain::observable(place.observable),
            escape(&plain::range(place.axis, place.from, place.to)),
        )
    });
    let closed = match (best, answer.gap.closed) {
        ("", _) | (_, None) => String::new(),
        (best, Some(closed)) => format!(
            " The nearest known cause, <code>{best}</code>, closes {:.0} % of the gap and leaves more than noise: it is not the answer.",
            100.0 * closed
        ),
    };
    format!("No known cause, alone or in pairs, describes it.{place}{closed}")
}

fn suspects(answer: &Answer) -> Vec<&'static str> {
    let named: Vec<&str> = answer
        .causes
        .iter()
        .filter(|c| c.probability > 0.05)
        .flat_map(|c| c.effects.iter().copied())
        .collect();
    let of_causes = crate::effects::list()
        .into_iter()
        .filter(|about| named.contains(&about.id))
        .map(|about| about.stage.name());
    let places = answer.r#where.iter().take(1).map(|place| place.stage);
    match answer.verdict {
        Verdict::NoGap => Vec::new(),
        Verdict::Unexplained => places.collect(),
        _ => of_causes.collect(),
    }
}

fn bars(page: &mut String, answer: &Answer) {
    let gap = &answer.gap;
    let largest = gap.before_percent.max(gap.after_percent).max(1e-9);
    let added = match answer.verdict {
        Verdict::NoGap => None,
        Verdict::Explained => Some("with the cause added"),
        Verdict::Ambiguous => Some("with the first of them added"),
        Verdict::Unexplained => Some("with the nearest known cause"),
    };
    page.push_str("<div class=bars>");
    for (name, class, value) in [
        (Some("simulation as it is"), "before", gap.before_percent),
        (added, "after", gap.after_percent),
        (Some("measurement noise alone"), "floor", gap.floor_percent),
    ] {
        let Some(name) = name else { continue };
        let width = (100.0 * value / largest).clamp(0.3, 100.0);
        let _ = write!(
            page,
            "<span>{name}</span><span class=track><span class='bar {class}' style='width:{width:.1}%'></span></span><b>{}</b>",
            percent(value)
        );
    }
    let _ = write!(
        page,
        "</div><p class=small>How far simulation and measurement lie apart (root mean square), on {} {} that took no part in finding the cause.</p>",
        gap.held_out_rows,
        if gap.by_observable.contains_key("output") {
            "samples"
        } else {
            "points"
        }
    );
}

/// Whether the cause holds at levels and frequencies that it was not fitted to.
fn elsewhere(answer: &Answer) -> String {
    let slices = answer.gap.by_level.iter().chain(&answer.gap.by_band);
    let gaps = slices.filter_map(|slice| Some((slice, slice.closed?)));
    let worst = gaps.min_by(|a, b| a.1.total_cmp(&b.1));
    let (Verdict::Explained | Verdict::Ambiguous, Some((slice, closed))) = (answer.verdict, worst)
    else {
        return String::new();
    };
    let level = answer.gap.by_level.iter().any(|l| std::ptr::eq(l, slice));
    let unit = match (level, answer.gap.rms_before.is_some()) {
        (true, true) => "",
        (true, false) => "\u{a0}m/s\u{b2}",
        (false, _) => "\u{a0}Hz",
    };
    let place = format!(
        "{} to {}{unit}",
        super::short(slice.from),
        super::short(slice.to)
    );
    let words = if closed > HOLDS {
        format!(
            "It holds where it was not fitted: at levels and in bands that were left out, {:.0}\u{a0}% of the gap or more is closed.",
            100.0 * closed
        )
    } else if slice.chosen.is_empty() {
        format!("Only the data from {place} show it: the others alone would not have named it.")
    } else {
        format!(
            "Do not rely on it from {place}: fitted without these data, it closes only {:.0}\u{a0}% of the gap there.",
            100.0 * closed.max(0.0)
        )
    };
    format!("<p class=small>{words}</p>")
}

/// Share of the gap closed at which a cause is said to hold on data left out.
const HOLDS: f64 = 0.9;

fn percent(value: f64) -> String {
    format!("{}\u{a0}%", super::short(value))
}

/// Never states a certainty.
fn probability(value: f64) -> String {
    if value > 0.999 {
        "more than 99.9\u{a0}%".into()
    } else {
        format!("{:.1}\u{a0}%", 100.0 * value)
    }
}
