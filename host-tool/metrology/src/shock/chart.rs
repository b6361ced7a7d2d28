//! The forward simulation of 8.4.2 beside the measured output.

use super::fit::ShockIdentification;
use crate::record::{TimeRecord, without_offset};
use calib_plot::{Axis, Ink, Mark, Plot, Scale, sheet};

/// Measured and simulated output over time; their difference below.
pub fn simulation_chart(record: &TimeRecord, result: &ShockIdentification) -> String {
    let (Some(input), Some(output)) = (&record.input, &record.output) else {
        return sheet(&[], 1);
    };
    let measured = without_offset(output);
    let simulated = match result.oscillator.delta > 0.0 {
        true => result.discrete.respond(&without_offset(input)),
        false => vec![0.0; measured.len()],
    };
    let pairs = measured.iter().zip(&simulated);
    let difference: Vec<f64> = pairs.map(|(m, s)| m - s).collect();
    let rate_hz = result.sample_rate_hz;
    let output = panel(
        "output",
        rate_hz,
        &[(&measured, Ink::Blue), (&simulated, Ink::Red)],
    );
    let mut left = panel("measured - simulated", rate_hz, &[(&difference, Ink::Grey)]);
    left.height = 170.0;
    sheet(&[output, left], 1)
}

/// Lines over time.
fn panel(title: &str, sample_rate_hz: f64, lines: &[(&[f64], Ink)]) -> Plot {
    let milliseconds = |index: usize| 1000.0 * index as f64 / sample_rate_hz;
    let samples = lines.iter().map(|line| line.0.len()).max().unwrap_or(1);
    let x = Axis::new(Scale::Linear, 0.0, milliseconds(samples)).titled("time / ms");
    let shown = lines.iter().flat_map(|line| line.0.iter().copied());
    let mut plot = Plot::new(title, x, Axis::around(Scale::Linear, shown));
    // About two points for each pixel are enough.
    let step = (samples / 1600).max(1);
    for (values, ink) in lines {
        let places = values.iter().enumerate().step_by(step);
        let points = places.map(|(index, value)| (milliseconds(index), *value));
        plot.marks.push(Mark::Line {
            points: points.collect(),
            ink: *ink,
        });
    }
    plot
}
