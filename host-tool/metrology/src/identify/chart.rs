//! The empirical test of 8.4.1: model and points in one chart.

use super::fit::distance;
use super::identification::Identification;
use super::points::{Point, Points};
use calib_plot::{Axis, Ink, Mark, Plot, Scale, sheet};
use nalgebra::Complex;

/// Magnitude, phase and the deviations of both over frequency.
pub fn response_chart(points: &Points, result: &Identification) -> String {
    let oscillator = &result.oscillator;
    let frequencies = points.points.iter().map(|point| point.frequency_hz);
    let measured = Axis::spanning(Scale::Logarithmic, frequencies.clone());
    let x = Axis::around(Scale::Logarithmic, frequencies).titled("frequency / Hz");
    let model = |value: fn(Complex<f64>) -> f64| {
        let place = |f: f64| (f, value(oscillator.response(f)));
        measured.places(200).map(place).collect()
    };
    let zero = || vec![(x.low, 0.0), (x.high, 0.0)];
    let panel = |title: &str, of: &dyn Fn(&Point) -> f64, line: Vec<(f64, f64)>| {
        let measured = points.points.iter().map(|p| (p.frequency_hz, of(p)));
        panel(title, &x, measured.collect(), line)
    };
    let panels = [
        panel("magnitude", &|p| p.magnitude, model(|h| h.norm())),
        panel(
            "phase / deg",
            &|p| p.phase_rad.to_degrees(),
            model(|h| h.arg().to_degrees()),
        ),
        panel(
            "magnitude, points - model / %",
            &|p| 100.0 * distance(p, oscillator).0,
            zero(),
        ),
        panel(
            "phase, points - model / deg",
            &|p| distance(p, oscillator).1.to_degrees(),
            zero(),
        ),
    ];
    sheet(&panels, 2)
}

/// Measured values, and a line over frequency.
fn panel(title: &str, x: &Axis, measured: Vec<(f64, f64)>, line: Vec<(f64, f64)>) -> Plot {
    let shown = measured.iter().chain(&line).map(|place| place.1);
    let y = Axis::around(Scale::Linear, shown);
    let point = |&(x, y): &(f64, f64)| calib_plot::Point::new(x, y);
    let points = measured.iter().map(point).collect();
    Plot::new(title, x.clone(), y)
        .with(Mark::Line {
            points: line,
            ink: Ink::Red,
        })
        .with(Mark::Points {
            points,
            ink: Ink::Blue,
        })
}
