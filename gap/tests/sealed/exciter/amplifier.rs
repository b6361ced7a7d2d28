//! Output of a power amplifier for a sine.

use super::series::{HARMONICS, Series};
use num_complex::Complex64 as C;
use std::f64::consts::{FRAC_2_PI, TAU};

/// Points of the grid on which a clipped sine is analysed.
const GRID: usize = 2000;
/// Of one that is bent smoothly: its orders fall exponentially.
const SMOOTH_GRID: usize = 96;

#[derive(Clone, Copy)]
pub(crate) struct Amplifier {
    pub(crate) clips_at_v: Option<f64>,
    /// Voltage towards which the output bends, and whether as an arc tangent instead of a hyperbolic one.
    pub(crate) bends_to_v: Option<(f64, bool)>,
    /// Even-order distortion: the square of the output, times this.
    pub(crate) even_per_v: f64,
}

impl Amplifier {
    pub(super) fn is_linear(&self) -> bool {
        self.clips_at_v.is_none() && self.bends_to_v.is_none() && self.even_per_v == 0.0
    }

    /// The coil voltage with this fundamental.
    pub(super) fn waveform(&self, fundamental_v: C) -> Series {
        let mut series = vec![C::ZERO; HARMONICS + 1];
        series[1] = fundamental_v;
        series[2] += fundamental_v * fundamental_v * (self.even_per_v / 2.0);
        if let Some(limit_v) = self.clips_at_v {
            clip(&mut series, limit_v);
        }
        if let Some((limit_v, as_arc)) = self.bends_to_v {
            let bent = |v: f64| match as_arc {
                true => limit_v * FRAC_2_PI * (v / limit_v / FRAC_2_PI).atan(),
                false => limit_v * (v / limit_v).tanh(),
            };
            add_orders::<SMOOTH_GRID>(&mut series, bent);
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
    add_orders::<GRID>(series, |v| v.clamp(-limit_v, limit_v));
}

/// Adds the odd orders of a sine behind a characteristic that has the fundamental of the series there.
fn add_orders<const POINTS: usize>(series: &mut [C], bent: impl Fn(f64) -> f64) {
    let peak_v = series[1].norm();
    let before_v = before_bending::<POINTS>(peak_v, &bent);
    if before_v > peak_v * 1.000_000_1 {
        let direction = series[1] / peak_v;
        for n in [3, 5, 7, 9, 11] {
            series[n] += direction.powu(n as u32) * bent_order::<POINTS>(before_v, &bent, n);
        }
    }
}

/// Peak of the sine that has a given fundamental once it is bent, by bisection.
fn before_bending<const POINTS: usize>(peak_v: f64, bent: &impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (peak_v, 40.0 * peak_v);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        match bent_order::<POINTS>(middle, bent, 1) < peak_v {
            true => low = middle,
            false => high = middle,
        }
    }
    low
}

/// Amplitude of an order of a cosine behind a characteristic.
fn bent_order<const POINTS: usize>(peak_v: f64, bent: &impl Fn(f64) -> f64, n: usize) -> f64 {
    let term = |k: usize| {
        let angle_rad = TAU * (k as f64 + 0.5) / POINTS as f64;
        bent(peak_v * angle_rad.cos()) * (n as f64 * angle_rad).cos()
    };
    (0..POINTS).map(term).sum::<f64>() * 2.0 / POINTS as f64
}
