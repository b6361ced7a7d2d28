//! Output of a power amplifier for a sine.

use super::series::{HARMONICS, Series};
use num_complex::Complex64 as C;
use std::f64::consts::TAU;

/// Points of the grid on which a clipped sine is analysed.
const GRID: usize = 2000;

#[derive(Clone, Copy)]
pub(crate) struct Amplifier {
    pub(crate) clips_at_v: Option<f64>,
    /// Even-order distortion: the square of the output, times this.
    pub(crate) even_per_v: f64,
}

impl Amplifier {
    pub(super) fn is_linear(&self) -> bool {
        self.clips_at_v.is_none() && self.even_per_v == 0.0
    }

    /// The coil voltage with this fundamental.
    pub(super) fn waveform(&self, fundamental_v: C) -> Series {
        let mut series = vec![C::ZERO; HARMONICS + 1];
        series[1] = fundamental_v;
        series[2] += fundamental_v * fundamental_v * (self.even_per_v / 2.0);
        if let Some(limit_v) = self.clips_at_v {
            clip(&mut series, limit_v);
        }
        series
    }
}

/// Adds the odd orders of a sine that is cut at a limit and has the fundamental of the series.
fn clip(series: &mut [C], limit_v: f64) {
    let peak_v = series[1].norm();
    if peak_v <= 0.999 * limit_v {
        return;
    }
    let before_v = before_clipping(peak_v, limit_v);
    if before_v > peak_v * 1.000_000_1 {
        let direction = series[1] / peak_v;
        for n in [3, 5, 7, 9, 11] {
            series[n] += direction.powu(n as u32) * clipped_order(before_v, limit_v, n);
        }
    }
}

/// Peak of the sine that has a given fundamental once it is cut, by bisection.
fn before_clipping(peak_v: f64, limit_v: f64) -> f64 {
    let (mut low, mut high) = (peak_v, 40.0 * peak_v);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        match clipped_order(middle, limit_v, 1) < peak_v {
            true => low = middle,
            false => high = middle,
        }
    }
    low
}

/// Amplitude of an order of a cosine that is cut at a limit.
fn clipped_order(peak_v: f64, limit_v: f64, n: usize) -> f64 {
    let term = |k: usize| {
        let angle_rad = TAU * (k as f64 + 0.5) / GRID as f64;
        (peak_v * angle_rad.cos()).clamp(-limit_v, limit_v) * (n as f64 * angle_rad).cos()
    };
    (0..GRID).map(term).sum::<f64>() * 2.0 / GRID as f64
}
