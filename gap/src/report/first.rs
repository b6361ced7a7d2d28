//! Text of the first screen beyond the fields of an answer.

use super::plain;
use crate::answer::{Answer, Cause, Verdict, Where};
use crate::summary::three_digits;
use crate::thresholds;
use calib_effects::{Of, Stage, effect};

/// The effects of a cause in words that need no training.
pub(super) fn words(cause: &Cause) -> Vec<&'static str> {
    let entries = cause.effects.iter().filter_map(|id| effect(id));
    entries.map(|entry| entry.plain).collect()
}

/// A place where simulation and measurement differ, as a sentence.
pub(super) fn place(place: &Where) -> String {
    format!(
        "It points to {} and shows in {}, {}.",
        place.stage.plain(),
        place.observable.plain(),
        plain::range(place.axis, place.from, place.to)
    )
}

/// Stages of the chain that are suspected.
pub(super) fn suspects(answer: &Answer) -> Vec<Stage> {
    let named: Vec<&str> = answer
        .causes
        .iter()
        .filter(|c| c.probability > thresholds::POSSIBLE_PROBABILITY)
        .flat_map(|c| c.effects.iter().copied())
        .collect();
    let of_causes = calib_effects::entries(Of::Calibrator)
        .filter(|entry| named.contains(&entry.id))
        .map(|entry| entry.stage);
    let places = answer.r#where.iter().take(1).map(|place| place.stage);
    match answer.verdict {
        Verdict::NoGap | Verdict::Data => Vec::new(),
        Verdict::Unexplained => places.collect(),
        _ => of_causes.collect(),
    }
}

/// Whether the cause holds at levels and frequencies that it was not fitted to.
pub(super) fn elsewhere(answer: &Answer) -> Option<String> {
    let slices = answer.gap.by_level.iter().chain(&answer.gap.by_band);
    let gaps = slices.filter_map(|slice| Some((slice, slice.size.closed?)));
    let worst = gaps.min_by(|a, b| a.1.total_cmp(&b.1));
    let claims = matches!(
        answer.verdict,
        Verdict::Explained | Verdict::PartlyExplained | Verdict::Ambiguous
    );
    let (slice, closed) = worst.filter(|_| claims)?;
    let level = answer.gap.by_level.iter().any(|l| std::ptr::eq(l, slice));
    let unit = match (level, answer.gap.rms_before.is_some()) {
        (true, true) => "",
        (true, false) => "\u{a0}m/s\u{b2}",
        (false, _) => "\u{a0}Hz",
    };
    let place = format!(
        "{} to {}{unit}",
        three_digits(slice.from),
        three_digits(slice.to)
    );
    let words = if closed > thresholds::HOLDS {
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
    Some(words)
}
