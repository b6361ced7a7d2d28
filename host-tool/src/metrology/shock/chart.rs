//! The forward simulation of 8.4.2 beside the measured output.

use super::fit::ShockIdentification;
use crate::metrology::chart::{Axes, Axis, BLUE, GREY, RED, Scale, Svg};
use crate::metrology::record::{TimeRecord, without_offset};

/// Title, top and height, and lines with their colours.
type Panel<'a> = (&'a str, f64, f64, Vec<(&'a [f64], &'a str)>);

/// Measured and simulated output over time; their difference below.
pub fn simulation_chart(record: &TimeRecord, result: &ShockIdentification) -> String {
    let mut svg = Svg::new(900.0, 560.0);
    let (Some(input), Some(output)) = (&record.input, &record.output) else {
        return svg.finish();
    };
    let measured = without_offset(output);
    let simulated = match result.oscillator.delta > 0.0 {
        true => result.discrete.respond(&without_offset(input)),
        false => vec![0.0; measured.len()],
    };
    let difference: Vec<f64> = measured
        .iter()
        .zip(&simulated)
        .map(|(m, s)| m - s)
        .collect();
    let milliseconds = |index: usize| 1000.0 * index as f64 / result.sample_rate_hz;
    let panels: [Panel<'_>; 2] = [
        (
            "output",
            30.0,
            300.0,
            vec![(&measured, BLUE), (&simulated, RED)],
        ),
        (
            "measured - simulated",
            390.0,
            120.0,
            vec![(&difference, GREY)],
        ),
    ];
    for (title, top, height, lines) in panels {
        let axes = Axes {
            x: Axis {
                title: "time / ms".into(),
                low: 0.0,
                high: milliseconds(measured.len()),
                scale: Scale::Linear,
            },
            y: Axis::fitting(
                title,
                Scale::Linear,
                lines.iter().flat_map(|(values, _)| values.iter().copied()),
            ),
            area: (80.0, top, 790.0, height),
        };
        axes.draw(&mut svg);
        // About two points for each pixel are enough.
        let step = (measured.len() / 1600).max(1);
        for (values, color) in lines {
            let points: Vec<_> = values
                .iter()
                .enumerate()
                .step_by(step)
                .map(|(index, value)| axes.place(milliseconds(index), *value))
                .collect();
            svg.polyline(&points, color, 1.0);
        }
    }
    svg.finish()
}
