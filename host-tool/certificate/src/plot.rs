//! Frequency responses as SVG: logarithmic frequency, uncertainty bars.
//!
//! The drawing is complete without a script: it prints and goes into the PDF.
//! Zooming is an affine map of positions, because a logarithmic axis is linear
//! on paper; the drawing therefore carries, hidden, the finer ticks that a
//! reader may zoom to, and the page's script moves and shows what is there.

use super::band;
use super::model::{Certificate, Point};
use super::words::Language;
use std::fmt::Write;

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 300.0;
const LEFT: f64 = 62.0;
const RIGHT: f64 = 700.0;
const TOP: f64 = 26.0;
const BOTTOM: f64 = 256.0;

/// Inline style, so that the drawing stands alone.
const STYLE: &str = "\
.plot text{font:11px 'Liberation Sans','Helvetica Neue',Arial,sans-serif;fill:#333}\
.plot .grid{stroke:#d9dde2;stroke-width:1}.plot .minor{stroke:#eef0f2;stroke-width:1}\
.plot .frame{fill:none;stroke:#555;stroke-width:1}.plot .line{fill:none;stroke:#1f5fa8;stroke-width:1.6}\
.plot .band{fill:#2e7d32;fill-opacity:.09}.plot .limit{fill:none;stroke:#2e7d32;stroke-width:1.1;stroke-dasharray:6 3}.plot .own{stroke-width:2;stroke-dasharray:none}.plot .bar{stroke:#1f5fa8;stroke-width:1.2;fill:none}.plot .dot{fill:#1f5fa8}\
.plot .reference{fill:#fff;stroke:#1f5fa8;stroke-width:2}.plot .refused{stroke:#b3261e;stroke-width:1.8}\
.plot .mid{text-anchor:middle}.plot .end{text-anchor:end}.plot .fine{display:none}";

/// One mark of a plot.
struct Mark {
    frequency_hz: f64,
    value: f64,
    half_bar: f64,
    reference: bool,
    title: String,
}

/// A vertical axis: value range and the unit in words.
struct Axis {
    low: f64,
    high: f64,
}

/// The tolerance in the unit of a plot.
#[derive(Default)]
struct Tolerance {
    /// Areas: frequency, lower, upper limit.
    areas: Vec<Vec<(f64, f64, f64)>>,
    /// Limits at the reference point alone.
    at_reference: Option<(f64, f64, f64)>,
}

/// Sensitivity in mV/(m/s2) with the deviation from the reference point.
pub(super) fn sensitivity(certificate: &Certificate, language: Language) -> String {
    let marks = marks(certificate, language, |values| {
        let value = values.sensitivity_v_per_ms2 * 1000.0;
        Some((value, value * values.expanded_uncertainty_percent / 100.0))
    });
    let (low_hz, high_hz) = frequency_range(certificate.points.iter().map(|p| p.frequency_hz));
    let in_mv = |(hz, limits): band::Place| (hz, 1000.0 * limits.lower, 1000.0 * limits.upper);
    let areas = band::areas(certificate, low_hz, high_hz);
    let tolerance = Tolerance {
        areas: areas
            .into_iter()
            .map(|area| area.into_iter().map(in_mv).collect())
            .collect(),
        at_reference: band::at_reference(certificate).map(in_mv),
    };
    let reference = certificate
        .reference_result()
        .map(|(_, v)| v.sensitivity_v_per_ms2 * 1000.0);
    let label = "plot.sensitivity";
    draw(certificate, &marks, &tolerance, language, label, reference)
}

/// Phase in degrees.
pub(super) fn phase(certificate: &Certificate, language: Language) -> String {
    let marks = marks(certificate, language, |values| {
        Some((values.phase_deg, values.printed_phase_deg?.uncertainty))
    });
    let tolerance = Tolerance::default();
    draw(
        certificate,
        &marks,
        &tolerance,
        language,
        "plot.phase",
        None,
    )
}

fn marks(
    certificate: &Certificate,
    language: Language,
    of: impl Fn(&super::model::PointValues) -> Option<(f64, f64)>,
) -> Vec<Mark> {
    let mark = |(index, point): (usize, &Point)| {
        let (value, half_bar) = of(point.outcome.as_ref().ok()?)?;
        let title = format!(
            "{} Hz: {} \u{b1} {}",
            language.shortest(point.nominal_frequency_hz),
            language.number(value, 4),
            language.number(half_bar, 4)
        );
        let reference = certificate.reference == Some(index);
        Some(Mark {
            frequency_hz: point.frequency_hz,
            value,
            half_bar,
            reference,
            title,
        })
    };
    certificate
        .points
        .iter()
        .enumerate()
        .filter_map(mark)
        .collect()
}

fn draw(
    certificate: &Certificate,
    marks: &[Mark],
    tolerance: &Tolerance,
    language: Language,
    label: &str,
    reference: Option<f64>,
) -> String {
    let frequencies = certificate.points.iter().map(|p| p.frequency_hz);
    let (low_hz, high_hz) = frequency_range(frequencies);
    let axis = value_axis(marks, tolerance);
    let x = |hz: f64| LEFT + (hz / low_hz).ln() / (high_hz / low_hz).ln() * (RIGHT - LEFT);
    let y = |value: f64| BOTTOM - (value - axis.low) / (axis.high - axis.low) * (BOTTOM - TOP);
    let area = label.replace('.', "-");
    let mut svg = open(language.word(label), &area);
    frequency_ticks(&mut svg, (low_hz, high_hz), x, language);
    value_ticks(&mut svg, &axis, y, language);
    if let Some(reference) = reference {
        deviation_ticks(&mut svg, &axis, reference, y, language);
    }
    let _ = write!(svg, "<g clip-path='url(#{area})'>");
    draw_tolerance(&mut svg, tolerance, &x, &y);
    line(&mut svg, marks, &x, &y);
    for mark in marks {
        draw_mark(
            &mut svg,
            mark,
            x(mark.frequency_hz),
            y(mark.value),
            y(mark.value - mark.half_bar),
        );
    }
    refused(&mut svg, certificate, &x, language);
    let _ = write!(
        svg,
        "</g><rect class='frame' x='{LEFT}' y='{TOP}' width='{}' height='{}'/>\
         <text class='mid' x='{}' y='{}'>{}</text></svg>",
        RIGHT - LEFT,
        BOTTOM - TOP,
        (LEFT + RIGHT) / 2.0,
        HEIGHT - 8.0,
        language.word("plot.frequency"),
    );
    svg
}

fn open(label: &str, area: &str) -> String {
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' class='plot' viewBox='0 0 {WIDTH} {HEIGHT}' \
         role='img' aria-label='{label}' data-area='{LEFT} {TOP} {RIGHT} {BOTTOM}'><style>{STYLE}</style>\
         <defs><clipPath id='{area}'><rect x='{LEFT}' y='{TOP}' width='{}' height='{}'/></clipPath></defs>\
         <text x='{LEFT}' y='14'>{label}</text>",
        RIGHT - LEFT,
        BOTTOM - TOP,
    )
}

/// The frequencies with some air, and never less than a factor of five: that
/// has two labels at least.
fn frequency_range(frequencies: impl Iterator<Item = f64>) -> (f64, f64) {
    let usable = frequencies.filter(|hz| hz.is_finite() && *hz > 0.0);
    let (low, high) = usable.fold((f64::INFINITY, 0.0_f64), |(low, high), hz| {
        (low.min(hz), high.max(hz))
    });
    if high <= 0.0 {
        return (10.0, 1000.0);
    }
    let span = high / low;
    let air = span.powf(0.03).max(1.3).max((5.0 / span).sqrt());
    (low / air, high * air)
}

/// The values with their bars and some air.
fn value_axis(marks: &[Mark], tolerance: &Tolerance) -> Axis {
    let bars = marks
        .iter()
        .flat_map(|m| [m.value - m.half_bar, m.value + m.half_bar]);
    let limits = tolerance.areas.iter().flatten();
    let limits = limits.chain(&tolerance.at_reference);
    let ends = bars.chain(limits.flat_map(|(_, low, high)| [*low, *high]));
    let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
        (l.min(v), h.max(v))
    });
    if low > high {
        return Axis {
            low: 0.0,
            high: 1.0,
        };
    }
    // A single value without width still needs an axis.
    let span = (high - low).max(high.abs() * 1.0e-3).max(1.0e-9);
    Axis {
        low: low - 0.08 * span,
        high: high + 0.08 * span,
    }
}

fn frequency_ticks(
    svg: &mut String,
    range: (f64, f64),
    x: impl Fn(f64) -> f64,
    language: Language,
) {
    for decade in range.0.log10().floor() as i32..=range.1.log10().floor() as i32 {
        for tenth in 10..100_u32 {
            let hz = f64::from(tenth) * 10.0_f64.powi(decade) / 10.0;
            if hz < range.0 || hz > range.1 {
                continue;
            }
            let level = match tenth {
                10 | 20 | 50 => 0,
                _ if tenth % 10 == 0 => 1,
                _ => 2,
            };
            frequency_tick(svg, hz, x(hz), level, language);
        }
    }
}

fn frequency_tick(svg: &mut String, hz: f64, at: f64, level: u8, language: Language) {
    // Two digits of a decade: hide what f64 adds to them.
    let label = if hz >= 1000.0 {
        format!("{}k", language.shortest((hz / 10.0).round() / 100.0))
    } else {
        language.shortest((hz * 1000.0).round() / 1000.0)
    };
    let (line, text) = match level {
        0 => ("grid", "mid"),
        1 => ("minor", "mid fine"),
        _ => ("minor fine", "mid fine"),
    };
    let _ = write!(
        svg,
        "<g class='tick' data-x='{at:.2}' data-level='{level}' transform='translate({at:.2},0)'>\
         <line class='{line}' y1='{TOP}' y2='{BOTTOM}'/><text class='{text}' y='{}'>{label}</text></g>",
        BOTTOM + 16.0,
    );
}

/// A step of 1, 2 or 5 times a power of ten that gives about six ticks.
fn step(span: f64) -> f64 {
    let raw = span / 6.0;
    let power = 10.0_f64.powf(raw.log10().floor());
    let factor = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|f| f * power >= 0.7 * raw)
        .unwrap_or(10.0);
    factor * power
}

/// Ticks at three finenesses: position, level and decimals of the label.
fn ticks(low: f64, high: f64) -> Vec<(f64, u8, usize)> {
    let coarse = step(high - low);
    let finest = coarse / 50.0;
    let decimals = |step: f64| (-(step.log10() - 1.0e-9).floor()).max(0.0) as usize;
    let first = (low / finest).ceil() as i64;
    let last = (high / finest).floor() as i64;
    let tick = |index: i64| match index {
        i if i % 50 == 0 => (i as f64 * finest, 0, decimals(coarse)),
        i if i % 10 == 0 => (i as f64 * finest, 1, decimals(coarse / 5.0)),
        i => (i as f64 * finest, 2, decimals(finest)),
    };
    (first..=last).map(tick).collect()
}

fn value_ticks(svg: &mut String, axis: &Axis, y: impl Fn(f64) -> f64, language: Language) {
    for (value, level, decimals) in ticks(axis.low, axis.high) {
        let at = y(value);
        let fine = if level == 0 { "" } else { " fine" };
        let _ = write!(
            svg,
            "<g class='tick' data-y='{at:.2}' data-level='{level}' transform='translate(0,{at:.2})'>\
             <line class='grid{fine}' x1='{LEFT}' x2='{RIGHT}'/>\
             <text class='end{fine}' x='{}' y='4'>{}</text></g>",
            LEFT - 6.0,
            language.number(value, decimals),
        );
    }
}

fn deviation_ticks(
    svg: &mut String,
    axis: &Axis,
    reference: f64,
    y: impl Fn(f64) -> f64,
    language: Language,
) {
    let percent = |value: f64| (value / reference - 1.0) * 100.0;
    for (deviation, level, decimals) in ticks(percent(axis.low), percent(axis.high)) {
        let at = y(reference * (1.0 + deviation / 100.0));
        let fine = if level == 0 { "" } else { " class='fine'" };
        let _ = write!(
            svg,
            "<g class='tick' data-y='{at:.2}' data-level='{level}' transform='translate(0,{at:.2})'>\
             <text{fine} x='{}' y='4'>{}</text></g>",
            RIGHT + 6.0,
            language.number(deviation, decimals),
        );
    }
    let _ = write!(
        svg,
        "<text class='end' x='{}' y='14'>{}</text>",
        WIDTH - 4.0,
        language.word("plot.deviation")
    );
}

/// The tolerance as areas with dashed edges, and as two short lines where the
/// reference point has limits of its own.
fn draw_tolerance(
    svg: &mut String,
    tolerance: &Tolerance,
    x: &impl Fn(f64) -> f64,
    y: &impl Fn(f64) -> f64,
) {
    for area in &tolerance.areas {
        let edge = |of: fn(&(f64, f64, f64)) -> f64| {
            let places = area
                .iter()
                .map(|p| format!("{:.2},{:.2}", x(p.0), y(of(p))));
            places.collect::<Vec<_>>()
        };
        let (lower, upper) = (edge(|p| p.1), edge(|p| p.2));
        let back = lower.iter().rev().cloned();
        let outline: Vec<String> = upper.iter().cloned().chain(back).collect();
        polyline(svg, "polygon", "band", &outline);
        polyline(svg, "polyline", "limit", &lower);
        polyline(svg, "polyline", "limit", &upper);
    }
    if let Some((hz, lower, upper)) = tolerance.at_reference {
        for limit in [lower, upper] {
            let at = |half: f64| format!("{:.2},{:.2}", x(hz) + half, y(limit));
            polyline(svg, "polyline", "limit own", &[at(-9.0), at(9.0)]);
        }
    }
}

fn polyline(svg: &mut String, element: &str, class: &str, places: &[String]) {
    let places = places.join(" ");
    let _ = write!(
        svg,
        "<{element} class='{class}' data-points='{places}' points='{places}'/>"
    );
}

fn line(svg: &mut String, marks: &[Mark], x: &impl Fn(f64) -> f64, y: &impl Fn(f64) -> f64) {
    let place = |mark: &Mark| format!("{:.2},{:.2}", x(mark.frequency_hz), y(mark.value));
    let places: Vec<String> = marks.iter().map(place).collect();
    polyline(svg, "polyline", "line", &places);
}

fn draw_mark(svg: &mut String, mark: &Mark, x: f64, y: f64, bar_end: f64) {
    let half = bar_end - y;
    let class = if mark.reference { "reference" } else { "dot" };
    let _ = write!(
        svg,
        "<g class='mark' data-x='{x:.2}' data-y='{y:.2}' transform='translate({x:.2},{y:.2})'>\
         <title>{}</title><path class='bar' data-half='{half:.3}' d='M-4,{:.3}h8M0,{:.3}V{half:.3}M-4,{half:.3}h8'/>\
         <circle class='{class}' r='3'/></g>",
        mark.title, -half, -half,
    );
}

fn refused(
    svg: &mut String,
    certificate: &Certificate,
    x: &impl Fn(f64) -> f64,
    language: Language,
) {
    for point in &certificate.points {
        let Err(refusal) = &point.outcome else {
            continue;
        };
        let at = x(point.frequency_hz);
        let _ = write!(
            svg,
            "<g class='mark' data-x='{at:.2}' transform='translate({at:.2},{})'><title>{} Hz: {}</title>\
             <path class='refused' d='M-4,-4l8,8M-4,4l8,-8'/></g>",
            BOTTOM - 9.0,
            language.shortest(point.nominal_frequency_hz),
            language.word(&format!("reason.{}", refusal.0)),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_lie_inside_the_axis_and_on_round_numbers() {
        let ticks = ticks(9.7, 11.3);
        let coarse: Vec<_> = ticks
            .iter()
            .filter(|t| t.1 == 0)
            .map(|t| format!("{:.1$}", t.0, t.2))
            .collect();
        // 1.6 in about six steps: the nearest step of the 1-2-5 series is 0.2.
        assert_eq!(
            coarse,
            [
                "9.8", "10.0", "10.2", "10.4", "10.6", "10.8", "11.0", "11.2"
            ]
        );
        assert!(ticks.iter().all(|t| (9.7..=11.3).contains(&t.0)));
    }

    #[test]
    fn a_single_point_has_an_axis_around_it() {
        let (low, high) = frequency_range([160.0].into_iter());
        assert!(low < 160.0 && 160.0 < high);
        let mark = Mark {
            frequency_hz: 160.0,
            value: 10.0,
            half_bar: 0.0,
            reference: true,
            title: String::new(),
        };
        let axis = value_axis(&[mark], &Tolerance::default());
        assert!(axis.low < 10.0 && 10.0 < axis.high);
    }
}
