//! The report on check standards and references, one page that stands alone: control charts for level and scatter, what
//! speaks against the latest, E_n, the drift they share and the interval that follows.

use crate::assurance::{AssuranceReport, Charts, CheckState};
use crate::self_check::ReferenceState;
use calib_output::number::fixed;
use calib_plot::{Axis, Ink, Mark, Plot, Point, Scale};
use jiff::Timestamp;
use jiff::tz::TimeZone;
use std::fmt::Write;

/// Seconds of a Julian year, and the year times are counted from.
const YEAR_S: f64 = 31_557_600.0;
const FIRST_YEAR: f64 = 1970.0;

/// The report as HTML, made at a time, s since 1970-01-01 UTC.
pub fn html(report: &AssuranceReport, at_s: i64) -> String {
    let mut text = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Check standards</title><style>{STYLE}</style>\
         </head><body>\n<h1>Assurance of the validity of results</h1>\n<p>ISO/IEC 17025, 7.7.1. Made {}.</p>\n",
        minute(at_s)
    );
    if report.standards.is_empty() && report.references.is_empty() {
        text += "<p>There is no check standard, and no reference was checked.</p>\n";
    }
    for (index, state) in report.standards.iter().enumerate() {
        text += &standard(state, index);
    }
    for state in &report.references {
        text += &reference(state);
    }
    text += &drift(report);
    text + "</body></html>\n"
}

const STYLE: &str = "body{font:15px/1.45 system-ui,sans-serif;max-width:800px;margin:24px auto;padding:0 12px}\
h2{margin-top:2em;border-top:1px solid #888;padding-top:.6em}td,th{text-align:left;padding:2px 14px 2px 0}\
.bad{color:#b3261e;font-weight:bold}svg{width:100%;height:auto}";

fn standard(state: &CheckState, index: usize) -> String {
    let stands = match state.in_control && !state.overdue {
        true => escaped(&state.words()),
        false => format!("<span class=\"bad\">{}</span>", escaped(&state.words())),
    };
    let latest = state.latest_unix_time_s.map_or("never".to_owned(), minute);
    let mut facts = vec![
        ("stands", stands),
        ("frequency", format!("{} Hz", state.standard.frequency_hz)),
        (
            "measured",
            format!("{} times, the latest {latest}", state.results),
        ),
        (
            "wanted",
            format!("every {} days", state.standard.every_days),
        ),
    ];
    if let Some(certified) = state.standard.certified {
        let stated = format!(
            "{:.5} mV/(m/s²), U = {:.2} %",
            1e3 * certified.sensitivity_v_per_ms2,
            100.0 * certified.expanded_uncertainty_rel
        );
        facts.push(("its certificate", stated));
    }
    facts.extend(
        state
            .e_n
            .map(|e_n| ("E_n of the latest against it", fixed(e_n, 2))),
    );
    let signals = state.signals.iter().map(|signal| signal.text().to_owned());
    facts.extend(signals.map(|signal| ("against the latest", signal)));
    let mut text = section(&format!("Check standard {}", state.standard.serial), &facts);
    match &state.chart {
        Some(charts) => {
            text += &level(charts).svg(&format!("level-{index}"));
            text += &scatter(charts).svg(&format!("scatter-{index}"));
        }
        None => text += "<p>Too few results for a chart.</p>\n",
    }
    text
}

fn reference(state: &ReferenceState) -> String {
    let mut facts = vec![
        ("stands", escaped(&state.words())),
        ("instrument", escaped(&state.instrument_serial)),
        ("certificate", escaped(&state.reference_certificate)),
        (
            "checked",
            format!(
                "{} times, the latest {}",
                state.checks,
                minute(state.latest_unix_time_s)
            ),
        ),
    ];
    let latest = state.latest.iter().map(|change| change.words());
    facts.extend(latest.map(|words| ("latest", escaped(&words))));
    let signals = state.signals.iter().map(|signal| signal.text().to_owned());
    facts.extend(signals.map(|signal| ("against the latest", signal)));
    section(&format!("Reference {}", state.reference_serial), &facts)
}

fn drift(report: &AssuranceReport) -> String {
    let Some(drift) = &report.common_drift else {
        return String::new();
    };
    let mut facts = vec![
        (
            "drift they share",
            format!(
                "{} % a year, U = {:.3} %",
                fixed(100.0 * drift.drift_rel_per_year, 3),
                100.0 * drift.expanded_rel_per_year
            ),
        ),
        (
            "by",
            format!("{} results of {} series", drift.results, drift.standards),
        ),
        (
            "which is",
            match (drift.is_significant(), drift.standards) {
                (false, _) => "less than its uncertainty: none is shown",
                (true, 1) => "of one series, which cannot tell its sensor from the reference",
                (true, _) => "the reference's, by as much the other way, or the instrument's",
            }
            .to_owned(),
        ),
    ];
    let interval = report
        .allowed_drift_rel
        .zip(report.reference_interval_years);
    facts.extend(interval.map(|(allowed, years)| {
        let said = format!(
            "{years:.1} years, when drift and U use up the {:.2} % of row 10 (ILAC-G24)",
            100.0 * allowed
        );
        ("advised interval of the reference", said)
    }));
    section("All check standards together", &facts)
}

/// A heading and a table; values are HTML.
fn section(title: &str, facts: &[(&str, String)]) -> String {
    let mut text = format!("<h2>{}</h2>\n<table>\n", escaped(title));
    for (name, value) in facts {
        let _ = writeln!(text, "<tr><th>{name}</th><td>{value}</td></tr>");
    }
    text + "</table>\n"
}

/// Results with U over the years, between their limits.
fn level(charts: &Charts) -> Plot {
    let percent = |value: f64| 100.0 * (value / charts.mean_v_per_ms2 - 1.0);
    let values = charts.sensitivities_v_per_ms2.iter();
    let bars = values.zip(&charts.expanded_uncertainties_rel);
    let points = charts
        .unix_times_s
        .iter()
        .zip(bars)
        .map(|(&at_s, (&value, &u))| {
            let ratio = value / charts.mean_v_per_ms2;
            Point::new(years(at_s), percent(value)).with_bar(100.0 * ratio * u)
        });
    let limits = [charts.lower_v_per_ms2, charts.upper_v_per_ms2].map(percent);
    chart(
        "Level: deviation from the mean in %, bars are U, limits hold 99.73 %",
        points.collect(),
        limits,
    )
}

/// Differences from the result before, below their limit.
fn scatter(charts: &Charts) -> Plot {
    let percent = |value: f64| 100.0 * value / charts.mean_v_per_ms2;
    let times = charts.unix_times_s.iter().skip(1);
    let points = times.zip(charts.ranges_v_per_ms2());
    let points = points.map(|(&at_s, range)| Point::new(years(at_s), percent(range)));
    let limits = [0.0, percent(charts.range_limit_v_per_ms2)];
    chart(
        "Scatter: difference from the result before in %, and its limit",
        points.collect(),
        limits,
    )
}

fn chart(caption: &str, points: Vec<Point>, limits: [f64; 2]) -> Plot {
    let x = Axis::around(Scale::Linear, points.iter().map(|point| point.x)).titled("year");
    let ends = points.iter().flat_map(Point::ends).chain(limits);
    let y = Axis::around(Scale::Linear, ends);
    let places = vec![
        (x.low, limits[0], limits[1]),
        (x.high, limits[0], limits[1]),
    ];
    let ink = Ink::Blue;
    let mut plot = Plot::new(caption, x, y).with(Mark::Band { places, ink });
    plot.height = 220.0;
    plot.with(Mark::Points { points, ink })
}

fn years(at_s: i64) -> f64 {
    FIRST_YEAR + at_s as f64 / YEAR_S
}

fn minute(at_s: i64) -> String {
    let at = Timestamp::from_second(at_s).unwrap_or(Timestamp::UNIX_EPOCH);
    at.to_zoned(TimeZone::UTC)
        .strftime("%Y-%m-%d %H:%M UTC")
        .to_string()
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
