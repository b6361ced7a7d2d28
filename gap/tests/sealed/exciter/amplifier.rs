//! Output of a power amplifier for a sine.

use super::series::{HARMONICS, Series};
use num_complex::Complex64 as C;
use std::f64::consts::{FRAC_2_PI, TAU};
use std::sync::LazyLock;

/// Highest order that an amplifier adds.
const HIGHEST: usize = 11;
/// Cosines of all orders on a grid of a period.
type Grid = [Vec<f64>; HIGHEST + 1];
/// The grid on which a clipped sine is analysed.
static GRID: LazyLock<Grid> = LazyLock::new(|| grid(2000));
/// Of one that is bent smoothly: its orders fall exponentially.
static SMOOTH_GRID: LazyLock<Grid> = LazyLock::new(|| grid(96));

fn grid(points: usize) -> Grid {
    let angle_rad = |k: usize| TAU * (k as f64 + 0.5) / points as f64;
    let of_order = |n: usize| move |k: usize| (n as f64 * angle_rad(k)).cos();
    std::array::from_fn(|n| (0..points).map(of_order(n)).collect())
}

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
            add_orders(&SMOOTH_GRID, &mut series, bent);
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
    add_orders(&GRID, series, |v| v.clamp(-limit_v, limit_v));
}

/// Adds the odd orders of a sine behind a characteristic that has the fundamental of the series there.
fn add_orders(grid: &Grid, series: &mut [C], bent: impl Fn(f64) -> f64) {
    let peak_v = series[1].norm();
    let before_v = before_bending(grid, peak_v, &bent);
    if before_v > peak_v * 1.000_000_1 {
        let direction = series[1] / peak_v;
        for n in (3..=HIGHEST).step_by(2) {
            series[n] += direction.powu(n as u32) * bent_order(grid, before_v, &bent, n);
        }
    }
}

/// Peak of the sine that has a given fundamental once it is bent, by bisection.
fn before_bending(grid: &Grid, peak_v: f64, bent: &impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (peak_v, 40.0 * peak_v);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        match bent_order(grid, middle, bent, 1) < peak_v {
            true => low = middle,
            false => high = middle,
        }
    }
    low
}

/// Amplitude of an order of a cosine behind a characteristic.
fn bent_order(grid: &Grid, peak_v: f64, bent: &impl Fn(f64) -> f64, n: usize) -> f64 {
    let points = grid[1].iter().zip(&grid[n]);
    let terms = points.map(|(first, order)| bent(peak_v * first) * order);
    terms.sum::<f64>() * 2.0 / grid[n].len() as f64
}
