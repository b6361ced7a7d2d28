//! Noise and leakage that effects add to one row.

use crate::observable::{Channel, Group, Observable};
use std::f64::consts::PI;

/// Noise that effects add to a row and to the uncertainty of its components.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Scatter {
    /// Mean square noise added in the channels: reference, device under test, in V^2.
    pub(crate) noise_v2: [f64; 2],
    /// Mean square of it that components of the block may have taken: what is computed as a
    /// harmonic or as d.c. is not left as noise.
    pub(crate) taken_v2: [f64; 2],
    /// Standard deviation of the logarithm of the noise that the effect leaves open.
    pub(crate) noise_open: [f64; 2],
    /// Variances that leak into the components.
    pub(crate) leaks: Leaks,
}

/// Variances of components by leakage.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Leaks {
    /// Per part, of the relative error of ratio and drive.
    pub(crate) response: [f64; 2],
    /// Scatter of the relative harmonics 2..5 of reference and device under test.
    pub(crate) harmonics: [[f64; 4]; 2],
    /// Of the d.c. values of both channels, in V^2.
    pub(crate) dc_v2: [f64; 2],
}

impl Scatter {
    /// Mean square noise of a channel in V^2, and the variance of its logarithm that stays open.
    ///
    /// How a line shares its power with the components depends on where it lies in its bin
    /// and on the window: the size of the reduction is open by itself.
    pub(crate) fn noise(&self, channel: Channel, healthy_v2: f64) -> (f64, f64) {
        let channel = channel as usize;
        let all = healthy_v2 + self.noise_v2[channel];
        let own = self.noise_open[channel].powi(2);
        if self.taken_v2[channel] == 0.0 {
            return (all, own);
        }
        let left = (all - self.taken_v2[channel]).max(healthy_v2).min(all);
        let reduction = if left > 0.0 {
            0.5 * (all / left).ln()
        } else {
            0.0
        };
        (left, own + reduction * reduction)
    }
}

impl Leaks {
    /// Variance of an observable.
    pub(crate) fn of(&self, observable: Observable) -> f64 {
        let order = || observable.order().map_or(0, |order| order - 2);
        match observable.group() {
            Group::Ratio => self.response[0],
            Group::Drive => self.response[1],
            Group::RefHarmonics => self.harmonics[0][order()],
            Group::DutHarmonics => self.harmonics[1][order()],
            Group::Dc => self.dc_v2[usize::from(observable == Observable::DutDc)],
            Group::Current | Group::Noise | Group::Output => 0.0,
        }
    }

    /// Whether anything leaks.
    pub(crate) fn any(&self) -> bool {
        *self != Self::default()
    }
}

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
