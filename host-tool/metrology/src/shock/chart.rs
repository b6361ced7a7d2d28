//! The forward simulation of 8.4.2 beside the measured output.

use super::fit::ShockIdentification;
use crate::chart::{Axes, Axis, BLUE, GREY, RED, Scale, Svg};
use crate::record::{TimeRecord, without_offset};

/// Lines over time with their colours.
struct Panel<'a> {
    title: &'a str,
    top: f64,
    height: f64,
    lines: Vec<(&'a [f64], &'a str)>,
}

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
    let pairs = measured.iter().zip(&simulated);
    let difference: Vec<f64> = pairs.map(|(m, s)| m - s).collect();
    let output = Panel {
        title: "output",
        top: 30.0,
        height: 300.0,
        lines: vec![(&measured, BLUE), (&simulated, RED)],
    };
    let left = Panel {
        title: "measured - simulated",
        top: 390.0,
        height: 120.0,
        lines: vec![(&difference, GREY)],
    };
    for panel in [output, left] {
        panel.draw(&mut svg, measured.len(), result.sample_rate_hz);
    }
    svg.finish()
}

impl Panel<'_> {
    fn draw(&self, svg: &mut Svg, samples: usize, sample_rate_hz: f64) {
        let milliseconds = |index: usize| 1000.0 * index as f64 / sample_rate_hz;
        let shown = self.lines.iter().flat_map(|line| line.0.iter().copied());
        let axes = Axes {
            x: Axis {
                title: "time / ms".into(),
                low: 0.0,
                high: milliseconds(samples),
                scale: Scale::Linear,
            },
            y: Axis::fitting(self.title, Scale::Linear, shown),
            area: (80.0, self.top, 790.0, self.height),
        };
        axes.draw(svg);
        // About two points for each pixel are enough.
        let step = (samples / 1600).max(1);
        for (values, color) in &self.lines {
            let points: Vec<_> = values
                .iter()
                .enumerate()
                .step_by(step)
                .map(|(index, value)| axes.place(milliseconds(index), *value))
                .collect();
            svg.polyline(&points, color, 1.0);
        }
    }
}
