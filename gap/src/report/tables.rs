//! The numbers behind the first screen.

use super::{escape, plain, short};
use crate::answer::{Answer, Estimate};
use crate::engine::gap::Slice;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Candidates with probability and parameters.
pub(super) fn causes(page: &mut String, answer: &Answer) {
    page.push_str("<h2>Which: candidates</h2>");
    if answer.causes.is_empty() {
        page.push_str("<p>No candidate reaches a probability of 1 %.</p>");
        return;
    }
    page.push_str("<div class=scroll><table><tr><th>Cause<th>In words<th>Probability<th>&Delta;BIC<th>Best in repeats<th>Parameters, with standard uncertainty</tr>");
    for cause in &answer.causes {
        let words: Vec<&str> = cause
            .effects
            .iter()
            .filter_map(|id| plain::effect(id))
            .collect();
        let values = cause
            .parameters
            .iter()
            .map(|(id, values)| format!("<code>{id}</code><br>{}", estimates(values)));
        let values: Vec<String> = values.collect();
        let _ = write!(
            page,
            "<tr><td><code>{}</code><td>{}<td><span class=track><span class='bar after' style='width:{:.1}%'></span></span>{:.3}<td>{:.1}<td>{:.0} %{}<td>{}</tr>",
            cause.effects.join(" + "),
            words.join("; "),
            100.0 * cause.probability,
            cause.probability,
            cause.delta_bic,
            100.0 * cause.stability,
            cause.stability_over_runs.map_or(String::new(), |s| format!(
                "<br>{:.0} % without a run",
                100.0 * s
            )),
            values.join("<br>")
        );
    }
    page.push_str("</table></div><p class=small>Best in repeats: share of datasets, drawn again from these rows, in which this cause would lead; then share of the runs without any one of which it would lead.</p>");
}

fn estimates(values: &BTreeMap<&'static str, Estimate>) -> String {
    let one =
        |(name, e): (&&str, &Estimate)| format!("{name} = {:.5e} &plusmn; {:.1e}", e.value, e.u);
    values.iter().map(one).collect::<Vec<_>>().join("<br>")
}

/// Stages and the structure that points to them.
pub(super) fn places(page: &mut String, answer: &Answer) {
    if answer.r#where.is_empty() {
        return;
    }
    page.push_str("<h2>Where: stages</h2><div class=scroll><table><tr><th>Stage<th>Shows in<th>Along<th>From<th>To<th>Kind<th>Share of the excess<th>p of noise</tr>");
    for p in &answer.r#where {
        let _ = write!(
            page,
            "<tr><td>{}<td>{}<td>{}<td>{}<td>{}<td>{}<td><span class=track><span class='bar before' style='width:{:.0}%'></span></span>{:.0} %<td>{:.1e}</tr>",
            p.stage,
            p.observable,
            escape(p.axis),
            short(p.from),
            short(p.to),
            p.class,
            100.0 * p.share,
            100.0 * p.share,
            p.p_value
        );
    }
    page.push_str("</table></div>");
}

/// Before and after by observable, on held-out rows.
pub(super) fn observables(page: &mut String, answer: &Answer) {
    page.push_str("<h2>How far: before and after on rows that took no part</h2><div class=scroll><table><tr><th>Observable<th>Before<th>After<th>Noise<th>Closed<th>&chi; before<th>&chi; after</tr>");
    for (name, gap) in &answer.gap.by_observable {
        let closed = gap
            .closed
            .map_or("no gap".to_owned(), |c| format!("{:.1} %", 100.0 * c));
        let _ = write!(
            page,
            "<tr><td>{name}<td>{} %<td>{} %<td>{} %<td>{closed}<td>{:.2}<td>{:.2}</tr>",
            short(gap.before_percent),
            short(gap.after_percent),
            short(gap.floor_percent),
            gap.chi_before,
            gap.chi_after
        );
    }
    page.push_str("</table></div>");
    let gap = &answer.gap;
    if let (Some(before), Some(after)) = (gap.rms_before, gap.rms_after) {
        let _ = write!(
            page,
            "<p>Simulation error (r.m.s., unit of the output): {before:.4e} before, {after:.4e} after.</p>"
        );
    }
    let chosen = match gap.chosen.as_slice() {
        [] => "nothing".to_owned(),
        some => some.join(" + "),
    };
    let _ = write!(
        page,
        "<p class=small>Chosen on the other rows: {chosen}. Probability that noise alone leaves as much structure as the best cause does: {:.3}.</p>",
        answer.none_of_these_p_value
    );
}

/// Before and after on levels and bands that the fit has not seen.
pub(super) fn slices(page: &mut String, answer: &Answer) {
    let gap = &answer.gap;
    if gap.by_level.is_empty() && gap.by_band.is_empty() {
        return;
    }
    let record = gap.rms_before.is_some();
    page.push_str(
        "<h2>How far: at levels and in bands that the fit did not see</h2><p class=small>",
    );
    page.push_str(if record {
        "Stretches of the held-out record by their largest output, and the spectrum of the errors on it, relative to the whole output."
    } else {
        "Each level, and each band, is left out in turn, and predicted from all the others. Where the others do not show the cause, it is not added."
    });
    page.push_str(" &chi; is the difference in units of the measurement's uncertainty, over all that was measured: 1 is noise. Bars: <span class='key before'></span> simulation as it is, <span class='key after'></span> with the cause.</p>");
    let unit = if record { "" } else { " m/s\u{b2}" };
    for (title, unit, slices) in [
        ("By level", unit, &gap.by_level),
        ("By band", " Hz", &gap.by_band),
    ] {
        if !slices.is_empty() {
            table_of(page, title, unit, slices);
        }
    }
}

fn table_of(page: &mut String, title: &str, unit: &str, slices: &[Slice]) {
    let of_slice = |s: &Slice| s.chi_before.max(s.chi_after);
    let largest = slices.iter().map(of_slice).fold(1e-9, f64::max);
    let width = |value: f64| (100.0 * value / largest).clamp(0.3, 100.0);
    let _ = write!(
        page,
        "<h3>{title}</h3><div class=scroll><table><tr><th>From, to<th>&chi;<th>&chi; before<th>&chi; after<th>Before<th>After<th>Noise<th>Closed<th>Cause that the others show</tr>"
    );
    for slice in slices {
        let closed = slice
            .closed
            .map_or("no gap".to_owned(), |c| format!("{:.1} %", 100.0 * c));
        let chosen = match slice.chosen.as_slice() {
            [] => "none".to_owned(),
            some => some.join(" + "),
        };
        let _ = write!(
            page,
            "<tr><td>{} .. {}{unit}{}<td><span class=track><span class='bar before' style='width:{:.1}%'></span><span class='bar after' style='width:{:.1}%'></span></span><td>{:.2}<td>{:.2}<td>{} %<td>{} %<td>{} %<td>{closed}<td>{chosen}</tr>",
            short(slice.from),
            short(slice.to),
            if slice.beyond {
                "<br><small>beyond what was fitted</small>"
            } else {
                ""
            },
            width(slice.chi_before),
            width(slice.chi_after),
            slice.chi_before,
            slice.chi_after,
            short(slice.before_percent),
            short(slice.after_percent),
            short(slice.floor_percent),
        );
    }
    page.push_str("</table></div>");
}

/// Fitted nominal parameters and what was read.
pub(super) fn background(page: &mut String, answer: &Answer) {
    page.push_str("<details><summary>Nominal parameters and dataset</summary><p>Fitted within their stated uncertainty before anything was called a gap:</p><div class=scroll><table>");
    for (name, estimate) in &answer.nominal_parameters {
        let _ = write!(
            page,
            "<tr><td>{name}<td>{:.6e}<td>&plusmn; {:.1e}</tr>",
            estimate.value, estimate.u
        );
    }
    let dataset = &answer.dataset;
    let _ = write!(
        page,
        "</table></div><p>{} rows of {}; columns {}; SHA-256 {}</p></details>",
        dataset.rows,
        escape(&dataset.path),
        escape(&dataset.columns_used.join(", ")),
        dataset.sha256
    );
}
