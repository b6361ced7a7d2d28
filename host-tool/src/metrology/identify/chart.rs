//! The empirical test of 8.4.1: model and points in one chart.

use super::fit::{Identification, distance};
use super::points::Points;
use crate::metrology::chart::{Axes, Axis, BLUE, RED, Scale, Svg};

/// Title, values at the points, and a line.
type Panel = (&'static str, Vec<f64>, Vec<(f64, f64)>);

/// Magnitude, phase and the deviations of both over frequency.
pub fn response_chart(points: &Points, result: &Identification) -> String {
    let mut svg = Svg::new(900.0, 640.0);
    let oscillator = &result.oscillator;
    let f: Vec<f64> = points.points.iter().map(|p| p.frequency_hz).collect();
    let x = Axis::fitting("frequency / Hz", Scale::Logarithmic, f.iter().copied());
    let curve: Vec<f64> = (0..=200)
        .map(|n| x.low * (x.high / x.low).powf(f64::from(n) / 200.0))
        .collect();
    let deviations: Vec<(f64, f64)> = points
        .points
        .iter()
        .map(|point| distance(point, oscillator))
        .collect();
    let magnitude = points.points.iter().map(|p| p.magnitude).collect();
    let phase = points
        .points
        .iter()
        .map(|p| p.phase_rad.to_degrees())
        .collect();
    let model = |pick: fn(nalgebra::Complex<f64>) -> f64| -> Vec<(f64, f64)> {
        curve
            .iter()
            .map(|&f| (f, pick(oscillator.response(f))))
            .collect()
    };
    let zero = vec![(x.low, 0.0), (x.high, 0.0)];
    let panels: [Panel; 4] = [
        ("magnitude", magnitude, model(|h| h.norm())),
        ("phase / deg", phase, model(|h| h.arg().to_degrees())),
        (
            "magnitude, points - model / %",
            deviations.iter().map(|d| 100.0 * d.0).collect(),
            zero.clone(),
        ),
        (
            "phase, points - model / deg",
            deviations.iter().map(|d| d.1.to_degrees()).collect(),
            zero,
        ),
    ];
    for (index, (title, values, line)) in panels.iter().enumerate() {
        let (column, row) = ((index % 2) as f64, (index / 2) as f64);
        let shown = values
            .iter()
            .copied()
            .chain(line.iter().map(|point| point.1));
        let axes = Axes {
            x: x.clone(),
            y: Axis::fitting(title, Scale::Linear, shown),
            area: (70.0 + 450.0 * column, 30.0 + 310.0 * row, 360.0, 230.0),
        };
        axes.draw(&mut svg);
        let placed: Vec<_> = line.iter().map(|&(x, y)| axes.place(x, y)).collect();
        svg.polyline(&placed, RED, 1.5);
        for (f, value) in f.iter().zip(values) {
            let (x, y) = axes.place(*f, *value);
            svg.dot(x, y, BLUE);
        }
    }
    svg.finish()
}
