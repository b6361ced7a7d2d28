//! One self-contained HTML page: first screen, where, which, how far, what next.
//!
//! The page is a template (`page.html`) over the answers as they serialise.
//!
//! ```text
//! first    text of the first screen beyond the fields of an answer
//! map      residuals over frequency, level and condition
//! curve    the most probable cause's curve through the data; of a record, the error over time
//! plain    numbers, observables and conditions as a person reads them
//! ```

mod curve;
mod first;
mod map;
mod plain;
#[cfg(test)]
mod tests;

use crate::answer::Answer;
use crate::axis::Axis;
use crate::error::GapError;
use crate::observable::Group;
use crate::pictures::Pictures;
use crate::summary::three_digits;
use crate::thresholds;
use calib_effects::Stage;
use minijinja::value::{Serde, Value};
use minijinja::{AutoEscape, Environment, UndefinedBehavior, context};
use serde::Serialize;

const TEMPLATE: &str = include_str!("page.html");
const STYLE: &str = include_str!("report.css");

/// One answer, with what is drawn of it.
#[derive(Serialize)]
struct Section<'a> {
    answer: &'a Answer,
    /// The dataset is a record of an oscillator.
    oscillator: bool,
    /// Of each cause, its effects in words that need no training.
    words: Vec<Vec<&'static str>>,
    suspects: Vec<Stage>,
    /// Where it shows most clearly.
    place: Option<String>,
    /// Whether the cause holds on data it was not fitted to.
    elsewhere: Option<String>,
    /// None of a record.
    maps: Option<Vec<map::Pair>>,
    /// Drawings, as SVG.
    plots: Vec<String>,
}

/// The report of one or several answers as a page of HTML.
///
/// # Errors
/// [`GapError::Report`] where the template does not fit the answers.
pub fn report(answers: &[Answer]) -> Result<String, GapError> {
    let sections: Vec<Section<'_>> = answers.iter().enumerate().map(section).collect();
    let environment = environment();
    let page = environment
        .template_from_named_str("page.html", TEMPLATE)
        .and_then(|template| {
            template.render(context! { style => STYLE, sections => Value::from(Serde(sections)) })
        });
    page.map_err(|error| GapError::Report(format!("{error:#}")))
}

fn section((at, answer): (usize, &Answer)) -> Section<'_> {
    let (maps, plots) = match &answer.pictures {
        Pictures::Points(residuals) => {
            let place = answer.r#where.first();
            let by_level = place.is_some_and(|place| place.axis != Axis::Frequency);
            let curves = curve::curves(residuals, by_level);
            (Some(map::maps(residuals)), curves)
        }
        Pictures::Record(trace) => (None, vec![curve::trace(trace)]),
    };
    let drawings = plots.iter().enumerate();
    Section {
        answer,
        oscillator: maps.is_none(),
        words: answer.causes.iter().map(first::words).collect(),
        suspects: first::suspects(answer),
        place: answer.r#where.first().map(first::place),
        elsewhere: first::elsewhere(answer),
        maps,
        plots: drawings
            .map(|(n, plot)| plot.svg(&format!("d{at}-plot{n}")))
            .collect(),
    }
}

/// Data for the template: numbers and names as a person reads them.
fn environment() -> Environment<'static> {
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(|_| AutoEscape::Html);
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.add_global("POSSIBLE", thresholds::POSSIBLE_PROBABILITY);
    environment.add_filter("three_digits", three_digits);
    environment.add_filter("percent", |value: f64| {
        format!("{}\u{a0}%", three_digits(value))
    });
    environment.add_filter("fixed", |value: f64, decimals: usize| {
        format!("{value:.decimals$}")
    });
    environment.add_filter("exponent", |value: f64, digits: usize| {
        format!("{value:.digits$e}")
    });
    environment.add_filter("probability", probability);
    // A bar is never so short that it cannot be seen.
    environment.add_filter("width", |value: f64, largest: f64| {
        format!(
            "{:.1}",
            (100.0 * value / largest.max(1e-9)).clamp(0.3, 100.0)
        )
    });
    environment.add_filter("chi", map::number);
    environment.add_filter("chi_class", map::class);
    environment.add_filter("observable", |name: String| {
        Group::named(&name).map_or("", Group::plain)
    });
    environment.add_filter("stage", |name: String| {
        Stage::named(&name).map_or("", Stage::label)
    });
    environment
}

/// Never states a certainty.
fn probability(value: f64) -> String {
    if value > 0.999 {
        "more than 99.9\u{a0}%".into()
    } else {
        format!("{:.1}\u{a0}%", 100.0 * value)
    }
}
