//! Degrees of equivalence with their uncertainties, one panel per frequency.

use crate::chart::{Axes, Axis, BLUE, GREY, RED, Scale, Svg};

/// One bar of the chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// Laboratory.
    pub laboratory: String,
    /// Panel, by frequency.
    pub frequency_hz: Option<f64>,
    /// Degree of equivalence.
    pub d: f64,
    /// Expanded uncertainty.
    pub u_expanded: f64,
}

const PANEL: (f64, f64) = (430.0, 200.0);

/// The graph of a comparison report; inconsistent laboratories are red.
pub fn equivalence_chart(bars: &[Bar]) -> String {
    let mut frequencies: Vec<Option<f64>> = bars.iter().map(|bar| bar.frequency_hz).collect();
    frequencies.sort_by(|a, b| a.unwrap_or(0.0).total_cmp(&b.unwrap_or(0.0)));
    frequencies.dedup();
    let rows = frequencies.len().div_ceil(2) as f64;
    let mut svg = Svg::new(2.0 * PANEL.0 + 20.0, rows * (PANEL.1 + 20.0) + 20.0);
    for (index, frequency_hz) in frequencies.iter().enumerate() {
        let shown: Vec<&Bar> = bars
            .iter()
            .filter(|bar| bar.frequency_hz == *frequency_hz)
            .collect();
        let corner = (
            (index % 2) as f64 * PANEL.0,
            (index / 2) as f64 * (PANEL.1 + 20.0),
        );
        panel(&mut svg, corner, *frequency_hz, &shown);
    }
    svg.finish()
}

fn panel(svg: &mut Svg, corner: (f64, f64), frequency_hz: Option<f64>, bars: &[&Bar]) {
    let ends = bars
        .iter()
        .flat_map(|bar| [bar.d - bar.u_expanded, bar.d + bar.u_expanded]);
    let title = frequency_hz.map_or("d".into(), |f| format!("d at {f} Hz"));
    let area = (
        corner.0 + 60.0,
        corner.1 + 30.0,
        PANEL.0 - 80.0,
        PANEL.1 - 60.0,
    );
    let axes = Axes {
        x: Axis {
            title: String::new(),
            low: 0.0,
            high: bars.len() as f64,
            scale: Scale::Linear,
        },
        y: Axis::fitting(&title, Scale::Linear, ends.chain([0.0])),
        area,
    };
    for tick in axes.y.ticks() {
        let (left, y) = axes.place(0.0, tick);
        svg.polyline(&[(left, y), (left + area.2, y)], "#dddddd", 0.7);
        svg.text(left - 5.0, y + 3.5, "end", 9.0, &format!("{tick:.3}"));
    }
    svg.text(area.0, area.1 - 6.0, "start", 11.0, &title);
    let (left, zero) = axes.place(0.0, 0.0);
    svg.polyline(&[(left, zero), (left + area.2, zero)], GREY, 1.2);
    for (index, bar) in bars.iter().enumerate() {
        let place = |value: f64| axes.place(index as f64 + 0.5, value);
        let color = match bar.d.abs() > bar.u_expanded {
            true => RED,
            false => BLUE,
        };
        let (low, high) = (place(bar.d - bar.u_expanded), place(bar.d + bar.u_expanded));
        svg.polyline(&[low, high], color, 1.5);
        let (x, y) = place(bar.d);
        svg.dot(x, y, color);
        svg.text(x, area.1 + area.3 + 14.0, "middle", 9.0, &bar.laboratory);
    }
}
