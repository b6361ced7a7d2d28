//! The error of a record over time, before and after.

use super::axes::{BOTTOM, HEIGHT, LEFT, RIGHT, TOP, WIDTH};
use super::short;
use crate::pictures::Trace;
use std::fmt::Write;

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
