//! The winner's curve through the data, for what shows the gap most clearly.
//!
//! Drawn is the difference to the simulation as it is: the data with two
//! standard uncertainties to either side, and what the best set of effects
//! says that difference should be.

use super::{escape, short};
use crate::pictures::{Conditions, Datum, Residuals, Trace};
use std::collections::BTreeMap;
use std::fmt::Write;

const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 300.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 835.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 256.0;
/// Plots of a report.
const MOST_PLOTS: usize = 4;

/// Name of a slot, its unit as drawn, and the factor to that unit.
fn slot(at: usize) -> (String, &'static str, f64) {
    let channel = |from: usize| ["reference", "device"][usize::from(at >= from + 8)];
    match at {
        0 => ("ratio".into(), "%", 100.0),
        1 => (
            "ratio, phase".into(),
            "\u{b0}",
            180.0 / std::f64::consts::PI,
        ),
        2 => ("drive".into(), "%", 100.0),
        3 => (
            "drive, phase".into(),
            "\u{b0}",
            180.0 / std::f64::consts::PI,
        ),
        4 => ("current".into(), "%", 100.0),
        5 => (
            "current, phase".into(),
            "\u{b0}",
            180.0 / std::f64::consts::PI,
        ),
        6..22 => {
            let order = 2 + (at - 6) % 8 / 2;
            let part = ["in phase", "in quadrature"][at % 2];
            (
                format!("harmonic {order} of the {}, {part}", channel(6)),
                "%",
                100.0,
            )
        }
        22 => ("d.c. of the reference".into(), "mV", 1e3),
        23 => ("d.c. of the device".into(), "mV", 1e3),
        24 => ("noise of the reference".into(), "%", 100.0),
        _ => ("noise of the device".into(), "%", 100.0),
    }
}

/// Writes the plots of what shows the gap most clearly.
pub(super) fn curves(page: &mut String, residuals: &Residuals, level_axis: bool) {
    page.push_str("<h2>Which: the cause's curve through the data</h2><p class=small>Difference to the simulation as it is. Dots: measured, with two standard uncertainties to either side (hollow: rows that took no part in the score's choice). Line and crosses: what the most probable cause predicts.</p>");
    for (rank, at) in clearest(residuals).into_iter().enumerate() {
        let data: Vec<&Datum> = residuals.data.iter().filter(|d| d.slot == at).collect();
        let level = level_axis && rank == 0;
        if level {
            plot(
                page,
                residuals,
                &data,
                at,
                ("level in m/s\u{b2}", |r| r.level_ms2),
            );
        }
        plot(
            page,
            residuals,
            &data,
            at,
            ("frequency in Hz", |r| r.frequency_hz),
        );
    }
}

/// Slots with the largest excess over what the cause leaves to chance, one of each observable.
fn clearest(residuals: &Residuals) -> Vec<usize> {
    let mut excess: BTreeMap<usize, f64> = BTreeMap::new();
    for datum in &residuals.data {
        *excess.entry(datum.slot).or_default() += (datum.before / datum.u_after).powi(2) - 1.0;
    }
    let mut order: Vec<(usize, f64)> = excess.into_iter().collect();
    order.sort_by(|a, b| b.1.total_cmp(&a.1));
    let family = |slot: usize| match slot {
        6..22 => 100 + (slot - 6) / 8,
        _ => slot,
    };
    let mut chosen: Vec<usize> = Vec::new();
    for (slot, _) in order {
        if chosen.len() < MOST_PLOTS && !chosen.iter().any(|c| family(*c) == family(slot)) {
            chosen.push(slot);
        }
    }
    chosen
}

type Abscissa = (&'static str, fn(&Conditions) -> f64);

fn plot(page: &mut String, residuals: &Residuals, data: &[&Datum], at: usize, x: Abscissa) {
    let (name, unit, factor) = slot(at);
    let at_x = |d: &Datum| x.1(&residuals.rows[d.row]);
    let drawn: Vec<&Datum> = data
        .iter()
        .copied()
        .filter(|d| at_x(d).is_finite() && at_x(d) > 0.0)
        .collect();
    let range = |values: &mut dyn Iterator<Item = f64>| {
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
            (a.min(v), b.max(v))
        })
    };
    let (low, high) = range(&mut drawn.iter().map(|d| at_x(d)));
    let (bottom, top) = range(&mut drawn.iter().flat_map(|d| {
        let model = d.before - d.after;
        [d.before - 2.0 * d.u, d.before + 2.0 * d.u, model].map(|v| v * factor)
    }));
    if drawn.is_empty() || high <= low || top <= bottom {
        return;
    }
    // So that no mark touches the frame.
    let margin = 0.04 * (top - bottom);
    let (bottom, top) = (bottom - margin, top + margin);
    let to_x = |v: f64| LEFT + (RIGHT - LEFT) * (v / low).ln() / (high / low).ln();
    let to_y = |v: f64| BOTTOM - (BOTTOM - TOP) * (v * factor - bottom) / (top - bottom);
    let _ = write!(
        page,
        "<svg class=plot viewBox='0 0 {WIDTH} {HEIGHT}' role=img aria-label='{}'>",
        escape(&name)
    );
    axes(page, (low, high), (bottom, top), to_x);
    for d in &drawn {
        let (px, py) = (to_x(at_x(d)), to_y(d.before));
        let (up, down) = (to_y(d.before + 2.0 * d.u), to_y(d.before - 2.0 * d.u));
        let row = &residuals.rows[d.row];
        let class = if row.held_out { "held" } else { "dot" };
        let _ = write!(
            page,
            "<path class=whisker d='M{px:.1} {up:.1}V{down:.1}'/><circle class={class} cx={px:.1} cy={py:.1} r=3><title>{} Hz: {} {unit}</title></circle>",
            short(row.frequency_hz),
            short(d.before * factor)
        );
    }
    lines(page, residuals, &drawn, |d| {
        (to_x(at_x(d)), to_y(d.before - d.after))
    });
    let _ = write!(
        page,
        "<text x={LEFT} y={}>{} in {unit}, over {}</text></svg>",
        HEIGHT - 4.0,
        escape(&name),
        x.0
    );
}

/// What the cause predicts: a cross per row, joined within rows of the same condition.
fn lines(
    page: &mut String,
    residuals: &Residuals,
    data: &[&Datum],
    place: impl Fn(&Datum) -> (f64, f64),
) {
    let mut groups: BTreeMap<String, Vec<(f64, f64)>> = BTreeMap::new();
    for datum in data {
        let r = &residuals.rows[datum.row];
        let key = format!(
            "{} {} {} {:.4} {:.1e}",
            r.run, r.rotation_deg, r.tilt_deg, r.payload_kg, r.level_ms2
        );
        groups.entry(key).or_default().push(place(datum));
    }
    for points in groups.values_mut() {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (x, y) in points.iter() {
            let _ = write!(
                page,
                "<path class=cross d='M{:.1} {y:.1}h6M{x:.1} {:.1}v6'/>",
                x - 3.0,
                y - 3.0
            );
        }
        // Several levels at one frequency make a line meaningless.
        let one_each = points.windows(2).all(|w| w[1].0 - w[0].0 > 0.5);
        if one_each && points.len() > 2 {
            page.push_str("<polyline class=model points='");
            for (x, y) in points.iter() {
                let _ = write!(page, "{x:.1},{y:.1} ");
            }
            page.push_str("'/>");
        }
    }
}

fn axes(page: &mut String, x: (f64, f64), y: (f64, f64), to_x: impl Fn(f64) -> f64) {
    for value in decades(x.0, x.1) {
        let at = to_x(value);
        let _ = write!(
            page,
            "<path class=grid d='M{at:.1} {TOP}V{BOTTOM}'/><text class=mid x={at:.1} y={}>{}</text>",
            BOTTOM + 15.0,
            short(value)
        );
    }
    let step = nice((y.1 - y.0) / 5.0);
    let mut value = (y.0 / step).ceil() * step;
    while value <= y.1 {
        let at = BOTTOM - (BOTTOM - TOP) * (value - y.0) / (y.1 - y.0);
        let class = if value.abs() < 0.5 * step {
            "zero"
        } else {
            "grid"
        };
        let shown = if value.abs() < 0.5 * step { 0.0 } else { value };
        let _ = write!(
            page,
            "<path class={class} d='M{LEFT} {at:.1}H{RIGHT}'/><text class=end x={} y={:.1}>{}</text>",
            LEFT - 6.0,
            at + 4.0,
            short(shown)
        );
        value += step;
    }
}

/// 1, 2 and 5 of each decade within the range.
fn decades(low: f64, high: f64) -> Vec<f64> {
    let first = low.log10().floor() as i32;
    let last = high.log10().ceil() as i32;
    (first..=last)
        .flat_map(|decade| [1.0, 2.0, 5.0].map(|m| m * 10.0_f64.powi(decade)))
        .filter(|v| (low * 0.999..=high * 1.001).contains(v))
        .collect()
}

fn nice(step: f64) -> f64 {
    let decade = 10.0_f64.powf(step.log10().floor());
    let of = [1.0, 2.0, 5.0, 10.0];
    of.iter()
        .map(|m| m * decade)
        .find(|v| *v >= step)
        .unwrap_or(10.0 * decade)
}

/// Writes the error of a record over time, before and after.
pub(super) fn trace(page: &mut String, trace: &Trace) {
    page.push_str("<h2>Which: what is left of the held-out record</h2><p class=small>Grey: measured output. Red: measured minus the linear simulation. Blue: with the named terms added.</p>");
    let all = trace.measured.iter().chain(&trace.before);
    let largest = all.fold(1e-30_f64, |m, v| m.max(v.abs()));
    let count = trace.measured.len().max(2) as f64;
    let _ = write!(
        page,
        "<svg class=plot viewBox='0 0 {WIDTH} {HEIGHT}' role=img aria-label='error over time'>"
    );
    let seconds = count * trace.interval_s;
    for (class, values) in [
        ("measured", &trace.measured),
        ("was", &trace.before),
        ("model", &trace.after),
    ] {
        let _ = write!(page, "<polyline class={class} points='");
        for (at, value) in values.iter().enumerate() {
            let x = LEFT + (RIGHT - LEFT) * at as f64 / count;
            let y = 0.5 * (TOP + BOTTOM) - 0.5 * (BOTTOM - TOP) * value / largest;
            let _ = write!(page, "{x:.1},{y:.1} ");
        }
        page.push_str("'/>");
    }
    let _ = write!(
        page,
        "<text class=end x={} y={}>{}</text><text class=end x={} y={}>-{}</text><text x={LEFT} y={}>output over {} s</text></svg>",
        LEFT - 6.0,
        TOP + 8.0,
        short(largest),
        LEFT - 6.0,
        BOTTOM,
        short(largest),
        HEIGHT - 4.0,
        short(seconds)
    );
}
