//! The chart of Figure C.1 with the limits of a rig shaded.

use super::Vibration;
use crate::chart::{Axes, Axis, BLUE, GREEN, GREY, RED, Scale, Svg};
use std::f64::consts::{SQRT_2, TAU};

/// What an exciter can do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigLimits {
    /// Acceleration, m/s2 r.m.s.
    pub acceleration_rms_ms2: f64,
    /// Velocity, m/s r.m.s.
    pub velocity_rms_ms: f64,
    /// Displacement, m peak.
    pub displacement_peak_m: f64,
}

impl Default for RigLimits {
    /// Lower ends of the typical values of ISO 16063-21, note of 3.2.
    fn default() -> Self {
        Self {
            acceleration_rms_ms2: 200.0,
            velocity_rms_ms: 0.5,
            displacement_peak_m: 0.005,
        }
    }
}

impl RigLimits {
    /// Largest velocity at a frequency, m/s r.m.s.
    pub fn velocity_at(&self, frequency_hz: f64) -> f64 {
        let omega = TAU * frequency_hz;
        self.velocity_rms_ms
            .min(self.acceleration_rms_ms2 / omega)
            .min(self.displacement_peak_m / SQRT_2 * omega)
    }
}

/// Velocity over frequency; acceleration and displacement are the diagonals.
pub fn nomogram_chart(vibration: &Vibration, limits: &RigLimits) -> String {
    let mut svg = Svg::new(900.0, 640.0);
    let axis = |title: &str, low: f64, high: f64| Axis {
        title: title.into(),
        low,
        high,
        scale: Scale::Logarithmic,
    };
    let f = vibration.frequency_hz;
    let v = vibration.velocity_ms.rms;
    let axes = Axes {
        x: axis(
            "frequency / Hz",
            0.4_f64.min(f / 2.0),
            20_000.0_f64.max(2.0 * f),
        ),
        y: axis(
            "velocity / (m/s), r.m.s.",
            1e-6_f64.min(v / 2.0),
            10.0_f64.max(2.0 * v),
        ),
        area: (80.0, 40.0, 780.0, 540.0),
    };
    axes.draw(&mut svg);
    diagonals(&mut svg, &axes);
    let mut outside: Vec<(f64, f64)> = (0..=200)
        .map(|n| axes.x.low * (axes.x.high / axes.x.low).powf(f64::from(n) / 200.0))
        .map(|f| axes.place(f, limits.velocity_at(f)))
        .collect();
    svg.polyline(&outside, RED, 1.5);
    outside.push(axes.place(axes.x.high, axes.y.high));
    outside.push(axes.place(axes.x.low, axes.y.high));
    svg.polygon(&outside, RED, 0.12);
    let (x, y) = axes.place(f, v);
    svg.dot(x, y, BLUE);
    svg.text(
        x + 8.0,
        y - 6.0,
        "start",
        12.0,
        &format!("{f:.4} Hz, {v:.3e} m/s"),
    );
    svg.text(
        80.0,
        625.0,
        "start",
        10.0,
        "grey: acceleration / (m/s2); green: displacement / m; red: beyond the rig; all r.m.s.",
    );
    svg.finish()
}

/// Lines of constant acceleration and displacement, one for each decade.
fn diagonals(svg: &mut Svg, axes: &Axes) {
    let inside = |v: f64| (axes.y.low..=axes.y.high).contains(&v);
    for decade in -12..=6 {
        let level = 10.0_f64.powi(decade);
        let lines: [(&dyn Fn(f64) -> f64, &str); 2] = [
            (&|f| level / (TAU * f), GREY),
            (&|f| level * TAU * f, GREEN),
        ];
        for (velocity, color) in lines {
            let points: Vec<(f64, f64)> = (0..=200)
                .map(|n| axes.x.low * (axes.x.high / axes.x.low).powf(f64::from(n) / 200.0))
                .filter(|&f| inside(velocity(f)))
                .map(|f| axes.place(f, velocity(f)))
                .collect();
            if points.len() > 20 {
                svg.polyline(&points, color, 0.5);
                let (x, y) = points[points.len() / 2];
                svg.text(x, y, "middle", 8.0, &format!("{level:e}"));
            }
        }
    }
}
