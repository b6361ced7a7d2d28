//! How much of a line that is not locked to the block leaks into a component.

use std::f64::consts::PI;

/// Leaked power over line power at a distance in bins: the square of
/// sin(pi x)/(pi x), beyond the first zero its mean over the unknown fraction of a bin.
pub(crate) fn leaking(bins: f64) -> f64 {
    let angle = PI * bins;
    if bins.abs() >= 1.0 {
        return 0.5 / (angle * angle);
    }
    let sinc = if angle.abs() < 1e-6 {
        1.0
    } else {
        angle.sin() / angle
    };
    sinc.powi(2).max(0.05)
}

/// Mains lines that carry power; their amplitudes fall about as 1/n.
const LINES: usize = 8;
/// Sum of 1/n^2 over the lines.
const LINE_POWER: f64 = 1.527_422;

/// Power leaked into a frequency over the power of all lines at multiples of the mains.
pub(crate) fn leaked_mains(frequency_hz: f64, mains_hz: f64, bin_hz: f64) -> f64 {
    let lines = (1..=LINES).map(|n| {
        let order = n as f64;
        leaking((frequency_hz - order * mains_hz) / bin_hz) / (order * order)
    });
    lines.sum::<f64>() / LINE_POWER
}
