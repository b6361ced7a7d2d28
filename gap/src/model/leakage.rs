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

/// Share of a line's power that the components of a block take: orders 1..5 of the frequency, and d.c.
pub(crate) fn taken(line_hz: f64, frequency_hz: f64, bin_hz: f64) -> f64 {
    let orders = (1..=5).map(|n| leaking((f64::from(n) * frequency_hz - line_hz) / bin_hz));
    // The mean takes real values only: all of a slow line's swing about zero.
    (orders.sum::<f64>() + 2.0 * leaking(line_hz / bin_hz)).min(1.0)
}

/// The same for the line at a multiple of the mains that loses most.
pub(crate) fn taken_mains(frequency_hz: f64, mains_hz: f64, bin_hz: f64) -> f64 {
    let lines = (1..=LINES).map(|n| taken(n as f64 * mains_hz, frequency_hz, bin_hz));
    lines.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line on the second harmonic is all in it; one 10 bins from everything has left less than
    /// 1/(2 pi^2 100) in each of the nearest.
    #[test]
    fn a_line_on_a_component_is_not_left_as_noise() {
        assert!((taken(50.0, 25.0, 3.0) - 1.0).abs() < 1e-12);
        assert!(taken(50.0, 400.0, 3.0) < 0.01);
        assert!((taken_mains(150.0, 50.0, 3.0) - 1.0).abs() < 1e-12);
    }
}
