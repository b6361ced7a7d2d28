//! The frame of a plot: its size, its axes and their ticks.

use super::short;
use std::fmt::Write;

pub(super) const WIDTH: f64 = 860.0;
pub(super) const HEIGHT: f64 = 300.0;
pub(super) const LEFT: f64 = 78.0;
pub(super) const RIGHT: f64 = 835.0;
pub(super) const TOP: f64 = 14.0;
pub(super) const BOTTOM: f64 = 256.0;

/// A logarithmic axis to the right, a linear one upwards.
pub(super) struct Axes {
    x: (f64, f64),
    y: (f64, f64),
}

impl Axes {
    /// Holds all of `x` and, with a margin, all of `y`; `None` where there is nothing to span.
    pub(super) fn over(x: impl Iterator<Item = f64>, y: impl Iterator<Item = f64>) -> Option<Self> {
        let (x, (bottom, top)) = (range(x), range(y));
        if x.1 <= x.0 || top <= bottom {
            return None;
        }
        // So that no mark touches the frame.
        let margin = 0.04 * (top - bottom);
        Some(Self {
            x,
            y: (bottom - margin, top + margin),
        })
    }

    pub(super) fn to_x(&self, value: f64) -> f64 {
        let (low, high) = self.x;
        LEFT + (RIGHT - LEFT) * (value / low).ln() / (high / low).ln()
    }

    pub(super) fn to_y(&self, value: f64) -> f64 {
        let (bottom, top) = self.y;
        BOTTOM - (BOTTOM - TOP) * (value - bottom) / (top - bottom)
    }

    pub(super) fn draw(&self, page: &mut String) {
        self.draw_x(page);
        self.draw_y(page);
    }

    fn draw_x(&self, page: &mut String) {
        for value in decades(self.x.0, self.x.1) {
            let at = self.to_x(value);
            let _ = write!(
                page,
                "<path class=grid d='M{at:.1} {TOP}V{BOTTOM}'/><text class=mid x={at:.1} y={}>{}</text>",
                BOTTOM + 15.0,
                short(value)
            );
        }
    }

    fn draw_y(&self, page: &mut String) {
        let (bottom, top) = self.y;
        let step = nice((top - bottom) / 5.0);
        let mut value = (bottom / step).ceil() * step;
        while value <= top {
            let at = self.to_y(value);
            let is_zero = value.abs() < 0.5 * step;
            let (class, shown) = if is_zero {
                ("zero", 0.0)
            } else {
                ("grid", value)
            };
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
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
        (a.min(v), b.max(v))
    })
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

/// The next of 1, 2 and 5 times a power of ten.
fn nice(step: f64) -> f64 {
    let decade = 10.0_f64.powf(step.log10().floor());
    let of = [1.0, 2.0, 5.0, 10.0];
    of.iter()
        .map(|m| m * decade)
        .find(|v| *v >= step)
        .unwrap_or(10.0 * decade)
}
