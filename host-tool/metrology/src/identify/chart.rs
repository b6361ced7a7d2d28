//! The empirical test of 8.4.1: model and points in one chart.

use super::fit::distance;
use super::identification::Identification;
use super::points::{Point, Points};
use crate::chart::{Axes, Axis, BLUE, RED, Scale, Svg};
use nalgebra::Complex;

/// Values at the points, and a line over frequency.
struct Panel {
    title: &'static str,
    values: Vec<f64>,
    line: Vec<(f64, f64)>,
}

/// Magnitude, phase and the deviations of both over frequency.
pub fn response_chart(points: &Points, result: &Identification) -> String {
    let mut svg = Svg::new(900.0, 640.0);
    let f: Vec<f64> = points.points.iter().map(|p| p.frequency_hz).collect();
    let x = Axis::fitting("frequency / Hz", Scale::Logarithmic, f.iter().copied());
    for (index, panel) in panels(points, result, &x).iter().enumerate() {
        panel.draw(&mut svg, index, &x, &f);
    }
    svg.finish()
}

fn panels(points: &Points, result: &Identification, x: &Axis) -> [Panel; 4] {
    let oscillator = &result.oscillator;
    let of = |value: &dyn Fn(&Point) -> f64| points.points.iter().map(value).collect();
    let model = |value: fn(Complex<f64>) -> f64| {
        let frequencies = (0..=200).map(|n| x.low * (x.high / x.low).powf(f64::from(n) / 200.0));
        frequencies
            .map(|f| (f, value(oscillator.response(f))))
            .collect()
    };
    let zero = || vec![(x.low, 0.0), (x.high, 0.0)];
    [
        Panel {
            title: "magnitude",
            values: of(&|p| p.magnitude),
            line: model(|h| h.norm()),
        },
        Panel {
            title: "phase / deg",
            values: of(&|p| p.phase_rad.to_degrees()),
            line: model(|h| h.arg().to_degrees()),
        },
        Panel {
            title: "magnitude, points - model / %",
            values: of(&|p| 100.0 * distance(p, oscillator).0),
            line: zero(),
        },
        Panel {
            title: "phase, points - model / deg",
            values: of(&|p| distance(p, oscillator).1.to_degrees()),
            line: zero(),
        },
    ]
}

impl Panel {
    /// Draws it as the one with this index of two columns.
    fn draw(&self, svg: &mut Svg, index: usize, x: &Axis, frequencies_hz: &[f64]) {
        let (column, row) = ((index % 2) as f64, (index / 2) as f64);
        let line = self.line.iter().map(|point| point.1);
        let shown = self.values.iter().copied().chain(line);
        let axes = Axes {
            x: x.clone(),
            y: Axis::fitting(self.title, Scale::Linear, shown),
            area: (70.0 + 450.0 * column, 30.0 + 310.0 * row, 360.0, 230.0),
        };
        axes.draw(svg);
        let placed: Vec<_> = self.line.iter().map(|&(x, y)| axes.place(x, y)).collect();
        svg.polyline(&placed, RED, 1.5);
        for (f, value) in frequencies_hz.iter().zip(&self.values) {
            let (x, y) = axes.place(*f, *value);
            svg.dot(x, y, BLUE);
        }
    }
}
