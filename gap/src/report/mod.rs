//! One self-contained HTML page: first screen, where, which, how far, what next.
//!
//! ```text
//! first    what a reader without training sees, with [`chain`] and words from [`plain`]
//! map      residuals over frequency, level and condition
//! curve    the most probable cause's curve through the data; axes: the frame of a plot
//! trace    of a record, the error over time
//! confirmed  what the simulator says once it has the cause
//! tables   the numbers
//! ```

mod axes;
mod chain;
mod confirmed;
mod curve;
mod first;
mod map;
mod plain;
mod tables;
mod trace;

use crate::answer::{Answer, Verdict};
use crate::pictures::Pictures;
use std::fmt::Write;

const STYLE: &str = include_str!("report.css");

/// Writes the report of one or several answers.
#[must_use]
pub fn report(answers: &[Answer]) -> String {
    let mut page = format!(
        "<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport content='width=device-width'><title>Gap between simulation and measurement</title><style>{STYLE}</style>"
    );
    if answers.len() > 1 {
        contents(&mut page, answers);
    }
    for (at, answer) in answers.iter().enumerate() {
        let _ = write!(page, "<article id=d{at}>");
        one(&mut page, answer);
        page.push_str("</article>");
    }
    page.push_str("</html>\n");
    page
}

fn contents(page: &mut String, answers: &[Answer]) {
    let _ = write!(
        page,
        "<h1>{} datasets</h1><table><tr><th>Dataset<th>Verdict<th>Most probable cause<th>Before<th>After</tr>",
        answers.len()
    );
    for (at, answer) in answers.iter().enumerate() {
        let claimed = answer
            .causes
            .first()
            .filter(|_| answer.verdict != Verdict::NoGap);
        let cause = claimed.map(|c| c.effects.join(" + "));
        let _ = write!(
            page,
            "<tr><td><a href='#d{at}'>{}</a><td>{}<td>{}<td>{} %<td>{} %</tr>",
            escape(&answer.dataset.path),
            verdict(answer.verdict),
            cause.unwrap_or_default(),
            short(answer.gap.before_percent),
            short(answer.gap.after_percent)
        );
    }
    page.push_str("</table>");
}

fn verdict(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::NoGap => "no gap",
        Verdict::Explained => "explained",
        Verdict::Ambiguous => "ambiguous",
        Verdict::Unexplained => "unexplained",
    }
}

fn one(page: &mut String, answer: &Answer) {
    first::first_screen(page, answer);
    match &answer.pictures {
        Pictures::Points(residuals) => {
            map::maps(page, residuals);
            tables::places(page, answer);
            let by_level = answer
                .r#where
                .first()
                .is_some_and(|p| p.axis != "frequency_hz");
            curve::curves(page, residuals, by_level);
        }
        Pictures::Record(trace) => {
            tables::places(page, answer);
            trace::trace(page, trace);
        }
    }
    tables::causes(page, answer);
    tables::observables(page, answer);
    tables::slices(page, answer);
    if let Some(confirmation) = &answer.confirmation {
        confirmed::confirmed(page, confirmation);
    }
    let confusable: Vec<String> = answer.confusable.iter().map(|c| c.join(" or ")).collect();
    let _ = write!(
        page,
        "<h2>What next</h2><p>{}.{}</p>",
        escape(&answer.next_measurement),
        if confusable.is_empty() {
            String::new()
        } else {
            format!(" Not told apart by these data: {}.", confusable.join("; "))
        }
    );
    tables::background(page, answer);
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('\'', "&#39;")
}

/// Three significant digits, without an exponent where it reads better.
fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".into();
    }
    let decade = value.abs().log10().floor() as i32;
    if !(-4..6).contains(&decade) {
        return format!("{value:.2e}");
    }
    let text = format!("{value:.*}", (2 - decade).max(0) as usize);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_as_a_person_writes_them() {
        let shown = [0.0, 0.3099, 7.9, 10_000.0, 12.3456, 1.2e-7, -0.05].map(short);
        assert_eq!(
            shown,
            ["0", "0.31", "7.9", "10000", "12.3", "1.20e-7", "-0.05"]
        );
    }
}
