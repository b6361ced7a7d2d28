//! An answer in words.

use calib_gap::{
    Answer, Cause, Confirmation, Estimate, Gap, PLACE_P_VALUE, Verdict, Where, three_digits,
};
use std::fmt::Write;

/// The answer for a terminal.
pub(super) fn answer(answer: &Answer) -> String {
    let mut text = String::new();
    let dataset = &answer.dataset;
    let held = match dataset.input_held {
        Some(true) => ", the input held between them",
        _ => "",
    };
    let _ = writeln!(text, "{} ({} rows{held})", dataset.path, dataset.rows);
    let _ = writeln!(text, "  {}", answer.summary);
    let _ = writeln!(text, "  {}", verdict(answer.verdict));
    // A gap too faint to be claimed has no cause, only what it might be.
    let word = match answer.verdict {
        Verdict::NoGap | Verdict::Data => "perhaps",
        _ => "cause",
    };
    for one in &answer.causes {
        cause(&mut text, word, one);
    }
    if !matches!(answer.verdict, Verdict::NoGap | Verdict::Data) {
        let _ = writeln!(
            text,
            "  other   {:<44} probability {:.3}",
            "a cause outside the library", answer.probability_other
        );
    }
    for one in places(answer) {
        place(&mut text, one);
    }
    let _ = writeln!(
        text,
        "  noise would leave as much structure with probability {:.2e}",
        answer.none_of_these_p_value
    );
    gap(&mut text, &answer.gap);
    slices(&mut text, answer);
    let _ = write!(text, "  next    {}", answer.next_measurement);
    text + &(answer.confirmation.as_ref()).map_or(String::new(), confirmation)
}

fn verdict(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::NoGap => {
            "no gap: the simulation describes the data within the stated uncertainties"
        }
        Verdict::Explained => "explained: one cause leads clearly, and what it leaves is noise",
        Verdict::Ambiguous => "ambiguous: these data cannot tell the causes below apart",
        Verdict::PartlyExplained => {
            "partly explained: the cause closes half of the gap or more, and more than noise is left"
        }
        Verdict::Unexplained => {
            "unexplained: no cause in the library closes half of the gap at every level and in every band"
        }
        Verdict::Data => "data: stated uncertainties or single rows are what does not fit",
    }
}

/// A cause that leads or might, with its parameters.
fn cause(text: &mut String, word: &str, cause: &Cause) {
    let over_runs = cause.stability_over_runs.map_or(String::new(), |share| {
        format!(" and in {:.0} % with a run left out", 100.0 * share)
    });
    let _ = writeln!(
        text,
        "  {word:<7} {:<44} probability {:.3}, best in {:.0} % of repeats{over_runs}",
        cause.effects.join(" + "),
        cause.probability,
        100.0 * cause.stability,
    );
    for caution in &cause.cautions {
        let _ = writeln!(text, "            but {caution}");
    }
    for (effect, estimates) in &cause.parameters {
        for (name, Estimate { value, u, .. }) in estimates {
            let _ = writeln!(
                text,
                "            {effect}: {name} = {value:.6e}  (u = {u:.1e})"
            );
        }
    }
}

/// Where the gap lies. Once it is explained, a place that noise would show as well is left out.
fn places(answer: &Answer) -> impl Iterator<Item = &Where> {
    let is_explained = answer.verdict == Verdict::Explained;
    let shown = move |(at, place): &(usize, &Where)| {
        *at == 0 || !is_explained || place.p_value < PLACE_P_VALUE
    };
    let all = answer.r#where.iter().enumerate();
    all.filter(shown).map(|(_, place)| place)
}

/// A place of the gap.
fn place(text: &mut String, place: &Where) {
    let shape = place.shape.as_ref();
    let shape = shape.map_or(String::new(), |shape| format!(", as {shape}"));
    let along: Vec<&str> = place.or_along.iter().map(|axis| axis.name()).collect();
    let also = match along.is_empty() {
        true => String::new(),
        false => format!(" (or {})", along.join(", ")),
    };
    let _ = writeln!(
        text,
        "  where   {} in {} along {}{also}, {:.4} .. {:.4} ({}{shape}), share {:.0} %, p = {:.1e}",
        place.stage,
        place.observable,
        place.axis.name(),
        place.from,
        place.to,
        place.class,
        100.0 * place.share,
        place.p_value
    );
}

/// How far the gap shrinks.
fn gap(text: &mut String, gap: &Gap) {
    let size = &gap.size;
    let closed = size.closed.map_or(String::new(), |share| {
        format!(", {:.1} % of it closed", 100.0 * share)
    });
    let _ = writeln!(
        text,
        "  gap     {:.3} % before, {:.3} % after, {:.3} % noise, on {} rows that took no part{closed}",
        100.0 * size.before_rel,
        100.0 * size.after_rel,
        100.0 * size.floor_rel,
        gap.held_out_rows
    );
}

/// How it does on levels and bands it was not fitted on.
fn slices(text: &mut String, answer: &Answer) {
    let record = answer.gap.rms_before.is_some();
    let unit = if record { "" } else { " m/s2" };
    if !(answer.gap.by_level.is_empty() && answer.gap.by_band.is_empty()) {
        let how = if record {
            "the held-out record, by its largest output and by its spectrum"
        } else {
            "each level and each band left out, and predicted from the others"
        };
        let _ = writeln!(text, "          {how}:");
    }
    for (what, unit, slices) in [
        ("level", unit, &answer.gap.by_level),
        ("band ", " Hz", &answer.gap.by_band),
    ] {
        for slice in slices {
            let size = &slice.size;
            let note = match (slice.beyond, slice.chosen == answer.gap.chosen) {
                (true, true) => "  (extrapolated)",
                (true, false) => "  (extrapolated; the others show another cause, or none)",
                (false, true) => "",
                (false, false) => "  (the others show another cause, or none)",
            };
            let range = format!(
                "{} .. {}{unit}",
                three_digits(slice.from),
                three_digits(slice.to)
            );
            let _ = writeln!(
                text,
                "  {what}   {range:<22} {:>7.3} % to {:>6.3} % (noise {:.3} %), chi {:.2} to {:.2}{note}",
                100.0 * size.before_rel,
                100.0 * size.after_rel,
                100.0 * size.floor_rel,
                size.chi_before,
                size.chi_after
            );
        }
    }
}

/// Result of the firmware on the emulated rig.
fn confirmation(confirmation: &Confirmation) -> String {
    let effects = confirmation.effects.join(" and ");
    let refused = confirmation.refused;
    let Some(gap) = &confirmation.gap else {
        return format!("\n  confirm {effects}: the firmware refuses all {refused} points with it");
    };
    let mut text = format!(
        "\n  confirm {effects} added to the emulated rig: the records of the firmware miss the \
         measurement by {:.3} % instead of {:.3} %, on {} rows ({refused} refused)",
        100.0 * gap.after_rel,
        100.0 * gap.before_rel,
        gap.rows,
    );
    for (name, distance) in &confirmation.by_observable {
        let _ = write!(
            text,
            "\n            {name}: {:.3} % before, {:.3} % after",
            100.0 * distance.before_rel,
            100.0 * distance.after_rel
        );
    }
    text
}
