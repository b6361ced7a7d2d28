//! Noise and leakage that effects add to one row.

use crate::observable::{Group, Observable};

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
    pub(crate) fn noise(&self, channel: usize, healthy_v2: f64) -> (f64, f64) {
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
            Group::Current | Group::Noise => 0.0,
        }
    }

    /// Whether anything leaks.
    pub(crate) fn any(&self) -> bool {
        *self != Self::default()
    }
}
