//! One self-contained HTML page: verdict, where, which, how far, what next.

use crate::answer::{Answer, Verdict};
use std::fmt::Write;

const STYLE: &str = "body{font:16px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#1a1a1a}\
table{border-collapse:collapse;width:100%}td,th{border-bottom:1px solid #ccc;padding:.3rem .6rem;text-align:left}\
.bar{background:#2a6f97;height:.8rem}.before{background:#c1666b}.floor{background:#8d99ae}h1{font-size:1.5rem}";

/// Writes the report of one or several answers.
#[must_use]
pub fn report(answers: &[Answer]) -> String {
    let mut page = format!(
        "<!doctype html><html lang=en><meta charset=utf-8><title>Sim-to-real gap</title><style>{STYLE}</style>"
    );
    for answer in answers {
        first_screen(&mut page, answer);
        causes(&mut page, answer);
        places(&mut page, answer);
        observables(&mut page, answer);
    }
    page.push_str("</html>\n");
    page
}

fn first_screen(page: &mut String, answer: &Answer) {
    let names = answer
        .causes
        .first()
        .map_or(String::new(), |c| c.effects.join(" and "));
    let gap = &answer.gap;
    let sentence = match answer.verdict {
        Verdict::NoGap => {
            "The simulation describes the measurement within its stated uncertainties.".to_owned()
        }
        Verdict::Explained => {
            format!("The simulation lacks <b>{names}</b>. With it, what is left is noise.")
        }
        Verdict::Ambiguous => format!(
            "The simulation lacks something that these data cannot pin down; first guess: <b>{names}</b>."
        ),
        Verdict::Unexplained => {
            "There is a gap, and no effect in the library explains it.".to_owned()
        }
    };
    let _ = write!(
        page,
        "<h1>{}</h1><p>{sentence}</p>",
        escape(&answer.dataset.path)
    );
    let largest = gap.before_percent.max(1e-9);
    for (name, class, value) in [
        ("before", "before", gap.before_percent),
        ("after", "", gap.after_percent),
        ("noise alone", "floor", gap.floor_percent),
    ] {
        let width = (100.0 * value / largest).min(100.0);
        let _ = write!(
            page,
            "<div>{name}: {value:.3} %</div><div class='bar {class}' style='width:{width:.1}%'></div>"
        );
    }
    let _ = write!(
        page,
        "<p>Scored on {} rows that took no part in the choice.</p><p><b>Next:</b> {}</p>",
        gap.held_out_rows,
        escape(&answer.next_measurement)
    );
}

fn causes(page: &mut String, answer: &Answer) {
    page.push_str(
        "<h2>Which</h2><table><tr><th>Cause<th>Probability<th>Stability<th>Parameters</tr>",
    );
    for cause in &answer.causes {
        let values: Vec<String> = cause
            .parameters
            .values()
            .flatten()
            .map(|(n, e)| format!("{n} = {:.4e} &plusmn; {:.1e}", e.value, e.u))
            .collect();
        let _ = write!(
            page,
            "<tr><td>{}<td>{:.3}<td>{:.2}<td>{}</tr>",
            cause.effects.join(" + "),
            cause.probability,
            cause.stability,
            values.join("<br>")
        );
    }
    page.push_str("</table>");
}

fn places(page: &mut String, answer: &Answer) {
    page.push_str("<h2>Where</h2><table><tr><th>Stage<th>Observable<th>Along<th>From<th>To<th>Kind<th>Share</tr>");
    for p in &answer.r#where {
        let _ = write!(
            page,
            "<tr><td>{}<td>{}<td>{}<td>{:.4}<td>{:.4}<td>{}<td><div class=bar style='width:{:.0}%'></div></tr>",
            p.stage,
            p.observable,
            p.axis,
            p.from,
            p.to,
            p.class,
            100.0 * p.share
        );
    }
    page.push_str("</table>");
}

fn observables(page: &mut String, answer: &Answer) {
    page.push_str("<h2>How far</h2><table><tr><th>Observable<th>Before<th>After<th>Noise<th>&chi; before<th>&chi; after</tr>");
    for (name, gap) in &answer.gap.by_observable {
        let _ = write!(
            page,
            "<tr><td>{name}<td>{:.4} %<td>{:.4} %<td>{:.4} %<td>{:.2}<td>{:.2}</tr>",
            gap.before_percent, gap.after_percent, gap.floor_percent, gap.chi_before, gap.chi_after
        );
    }
    page.push_str("</table>");
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
