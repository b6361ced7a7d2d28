//! The chart of Figure C.1 with the limits of a rig shaded.

use super::Vibration;
use calib_plot::{Axis, Ink, Mark, Plot, Point, Scale, sheet};
use std::f64::consts::{SQRT_2, TAU};

/// Limits of an exciter.
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
    let (f, v) = (vibration.frequency_hz, vibration.velocity_ms.rms);
    let axis = |low: f64, high: f64| Axis::new(Scale::Logarithmic, low, high);
    let x = axis(0.4_f64.min(f / 2.0), 20_000.0_f64.max(2.0 * f));
    let y = axis(1e-6_f64.min(v / 2.0), 10.0_f64.max(2.0 * v));
    let marks = diagonals(&x, &y);
    let limit = |f| (f, limits.velocity_at(f), y.high);
    let outside = x.places(200).map(limit).collect();
    let x = x.titled(
        "frequency / Hz; grey: acceleration / (m/s2), green: displacement / m, red: beyond the rig, all r.m.s.",
    );
    let mut plot = Plot::new("velocity / (m/s), r.m.s.", x, y);
    plot.height = 540.0;
    plot.marks = marks;
    let point = Mark::Points {
        points: vec![Point::new(f, v)],
        ink: Ink::Blue,
    };
    let text = format!("{f:.4} Hz, {v:.3e} m/s");
    let plot = plot
        .with(Mark::Band {
            places: outside,
            ink: Ink::Red,
        })
        .with(point)
        .with(Mark::Words { at: (f, v), text });
    sheet(&[plot], 1)
}

/// Lines of constant acceleration and displacement, one for each decade.
fn diagonals(x: &Axis, y: &Axis) -> Vec<Mark> {
    let mut marks = Vec::new();
    for decade in -12..=6 {
        let level = 10.0_f64.powi(decade);
        let lines: [(&dyn Fn(f64) -> f64, Ink); 2] = [
            (&|f| level / (TAU * f), Ink::Grey),
            (&|f| level * TAU * f, Ink::Green),
        ];
        for (velocity, ink) in lines {
            let places = x.places(200).map(|f| (f, velocity(f)));
            let inside = |place: &(f64, f64)| (y.low..=y.high).contains(&place.1);
            let points: Vec<(f64, f64)> = places.filter(inside).collect();
            if points.len() > 20 {
                let (at, text) = (points[points.len() / 2], format!("{level:e}"));
                marks.push(Mark::Line { points, ink });
                marks.push(Mark::Words { at, text });
            }
        }
    }
    marks
}
