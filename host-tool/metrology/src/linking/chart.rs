//! Degrees of equivalence with their uncertainties, one panel per frequency.

use super::doe::Degree;
use calib_plot::{Axis, Ink, Mark, Plot, Point, Scale, sheet};

/// The graph of a comparison report; inconsistent laboratories are red.
pub fn equivalence_chart(bars: &[Degree]) -> String {
    let mut frequencies: Vec<Option<f64>> = bars.iter().map(|bar| bar.frequency_hz).collect();
    frequencies.sort_by(|a, b| a.unwrap_or(0.0).total_cmp(&b.unwrap_or(0.0)));
    frequencies.dedup();
    let panel = |frequency_hz: &Option<f64>| {
        let shown = bars.iter().filter(|bar| bar.frequency_hz == *frequency_hz);
        panel(*frequency_hz, &shown.collect::<Vec<_>>())
    };
    let panels: Vec<Plot> = frequencies.iter().map(panel).collect();
    sheet(&panels, 2)
}

fn panel(frequency_hz: Option<f64>, bars: &[&Degree]) -> Plot {
    let title = frequency_hz.map_or("d".into(), |f| format!("d at {f} Hz"));
    let laboratories = bars.iter().map(|bar| bar.laboratory.clone());
    let point = |(index, bar): (usize, &&Degree)| {
        Point::new(index as f64 + 0.5, bar.d).with_bar(bar.u_expanded)
    };
    let points: Vec<Point> = bars.iter().enumerate().map(point).collect();
    let ends = points.iter().flat_map(Point::ends);
    let y = Axis::around(Scale::Linear, ends.chain([0.0]));
    let zero = vec![(0.0, 0.0), (bars.len() as f64, 0.0)];
    let (inconsistent, consistent) = points
        .into_iter()
        .partition(|point| Some(point.y.abs()) > point.half_bar);
    let mut plot = Plot::new(title, Axis::named(laboratories.collect()), y)
        .with(Mark::Line {
            points: zero,
            ink: Ink::Grey,
        })
        .with(Mark::Points {
            points: consistent,
            ink: Ink::Blue,
        })
        .with(Mark::Points {
            points: inconsistent,
            ink: Ink::Red,
        });
    plot.height = 240.0;
    plot
}
