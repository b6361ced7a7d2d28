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

/// A line beside the components of a block: d.c. and orders of the frequency that is measured.
pub(crate) struct Line {
    line_hz: f64,
    frequency_hz: f64,
    bin_hz: f64,
}

impl Line {
    pub(crate) fn new(line_hz: f64, frequency_hz: f64, bin_hz: f64) -> Self {
        Self {
            line_hz,
            frequency_hz,
            bin_hz,
        }
    }

    /// Distance from a component, in bins.
    pub(crate) fn bins(&self, order: usize) -> f64 {
        (order as f64 * self.frequency_hz - self.line_hz) / self.bin_hz
    }

    /// Power that leaks into a component over that of the line.
    pub(crate) fn leaking(&self, order: usize) -> f64 {
        leaking(self.bins(order))
    }
}

/// Share of a line's power that the components of a block take, from what leaks into d.c. and orders 1..5.
pub(crate) fn taken(leaking: &[f64; 6]) -> f64 {
    // The mean takes real values only: all of a slow line's swing about zero.
    (leaking[1..].iter().sum::<f64>() + 2.0 * leaking[0]).min(1.0)
}

/// Share taken of the line at a multiple of the mains that loses most.
pub(crate) fn taken_mains(frequency_hz: f64, mains_hz: f64, bin_hz: f64) -> f64 {
    let lines = (1..=LINES).map(|n| taken_of(n as f64 * mains_hz, frequency_hz, bin_hz));
    lines.fold(0.0, f64::max)
}

fn taken_of(line_hz: f64, frequency_hz: f64, bin_hz: f64) -> f64 {
    let line = Line::new(line_hz, frequency_hz, bin_hz);
    taken(&std::array::from_fn(|order| line.leaking(order)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line on the second harmonic is all in it; one 10 bins from everything has left less than
    /// 1/(2 pi^2 100) in each of the nearest.
    #[test]
    fn a_line_on_a_component_is_not_left_as_noise() {
        assert!((taken_of(50.0, 25.0, 3.0) - 1.0).abs() < 1e-12);
        assert!(taken_of(50.0, 400.0, 3.0) < 0.01);
        assert!((taken_mains(150.0, 50.0, 3.0) - 1.0).abs() < 1e-12);
    }
}
