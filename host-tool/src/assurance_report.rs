//! The report on check standards and references, one page that stands alone: control charts for level and scatter, what
//! speaks against the latest, E_n, the drift they share and the interval that follows.

use crate::Result;
use crate::assurance::{AssuranceReport, Charts, CheckState};
use crate::self_check::ReferenceState;
use calib_certificate::{minute, page};
use calib_metrology::common_drift::CommonDrift;
use calib_output::number::fixed;
use calib_plot::{Axis, Ink, Mark, Plot, Point, Scale};
use serde::Serialize;

const TEMPLATE: &str = include_str!("assurance_report.html");
/// Seconds of a Julian year, and the year times are counted from.
const YEAR_S: f64 = 31_557_600.0;
const FIRST_YEAR: f64 = 1970.0;

/// Values at hand for the template.
#[derive(Serialize)]
struct Page {
    made: String,
    sections: Vec<Section>,
}

/// A heading and what is known below it.
#[derive(Serialize)]
struct Section {
    title: String,
    facts: Vec<Fact>,
    /// Drawings, as SVG.
    plots: Vec<String>,
    remark: Option<&'static str>,
}

#[derive(Serialize)]
struct Fact {
    name: &'static str,
    value: String,
    /// It speaks against the results.
    bad: bool,
}

fn fact(name: &'static str, value: impl Into<String>) -> Fact {
    let value = value.into();
    let bad = false;
    Fact { name, value, bad }
}

/// The report as HTML, made at a time, s since 1970-01-01 UTC.
///
/// # Errors
/// [`Error::Input`](crate::Error::Input) where the template does not render.
pub fn html(report: &AssuranceReport, at_s: i64) -> Result<String> {
    let standards = report.standards.iter().zip(0..).map(standard);
    let references = report.references.iter().map(reference);
    let values = Page {
        made: at(at_s),
        sections: standards
            .chain(references)
            .chain(
                report
                    .common_drift
                    .iter()
                    .map(|shared| drift(report, shared)),
            )
            .collect(),
    };
    Ok(page("assurance_report.html", TEMPLATE, &values)?)
}

fn at(unix_time_s: i64) -> String {
    minute(unix_time_s.max(0) as u64)
}

fn standard((state, index): (&CheckState, usize)) -> Section {
    let latest = state.last_unix_time_s.map_or("never".to_owned(), at);
    let mut facts = vec![
        Fact {
            bad: !state.in_control || state.overdue,
            ..fact("stands", state.words())
        },
        fact("frequency", format!("{} Hz", state.standard.frequency_hz)),
        fact(
            "measured",
            format!("{} times, the latest {latest}", state.results),
        ),
        fact(
            "wanted",
            format!("every {} days", state.standard.every_days),
        ),
    ];
    facts.extend(state.standard.certified.map(|certified| {
        let stated = format!(
            "{:.5} mV/(m/s²), U = {:.2} %",
            1e3 * certified.sensitivity_v_per_ms2,
            100.0 * certified.expanded_uncertainty_rel
        );
        fact("its certificate", stated)
    }));
    let against = "E_n of the latest against it";
    facts.extend(state.e_n.map(|e_n| fact(against, fixed(e_n, 2))));
    let signals = state.signals.iter();
    facts.extend(signals.map(|signal| fact("against the latest", signal.text())));
    let plots = state.chart.iter().flat_map(|charts| {
        [
            level(charts).svg(&format!("level-{index}")),
            scatter(charts).svg(&format!("scatter-{index}")),
        ]
    });
    Section {
        title: format!("Check standard {}", state.standard.serial),
        facts,
        plots: plots.collect(),
        remark: state
            .chart
            .is_none()
            .then_some("Too few results for a chart."),
    }
}

fn reference(state: &ReferenceState) -> Section {
    let latest = at(state.last_unix_time_s);
    let mut facts = vec![
        fact("stands", state.words()),
        fact("instrument", state.instrument_serial.as_str()),
        fact("certificate", state.reference_certificate.as_str()),
        fact(
            "checked",
            format!("{} times, the latest {latest}", state.checks),
        ),
    ];
    let changes = state.latest.iter();
    facts.extend(changes.map(|change| fact("latest", change.words())));
    let signals = state.signals.iter();
    facts.extend(signals.map(|signal| fact("against the latest", signal.text())));
    of_facts(format!("Reference {}", state.reference_serial), facts)
}

fn drift(report: &AssuranceReport, drift: &CommonDrift) -> Section {
    let shared = format!(
        "{} % a year, U = {:.3} %",
        fixed(100.0 * drift.drift_rel_per_year, 3),
        100.0 * drift.expanded_rel_per_year
    );
    let whose = match (drift.is_significant(), drift.standards) {
        (false, _) => "less than its uncertainty: none is shown",
        (true, 1) => "of one series, which cannot tell its sensor from the reference",
        (true, _) => "the reference's, by as much the other way, or the instrument's",
    };
    let mut facts = vec![
        fact("drift they share", shared),
        fact(
            "by",
            format!("{} results of {} series", drift.results, drift.standards),
        ),
        fact("which is", whose),
    ];
    let interval = report
        .allowed_drift_rel
        .zip(report.reference_interval_years);
    facts.extend(interval.map(|(allowed, years)| {
        let said = format!(
            "{years:.1} years, when drift and U use up the {:.2} % of row 10 (ILAC-G24)",
            100.0 * allowed
        );
        fact("advised interval of the reference", said)
    }));
    of_facts("All check standards together".to_owned(), facts)
}

fn of_facts(title: String, facts: Vec<Fact>) -> Section {
    Section {
        title,
        facts,
        plots: Vec::new(),
        remark: None,
    }
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
