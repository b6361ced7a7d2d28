//! Sums over the measuring blocks of a point.

use crate::correlation::PairEstimate;
use crate::sequence::stretches::Stretches;

/// Everything gathered over the measuring blocks.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Gathered {
    pub(super) stretches: Stretches,
    blocks: u16,
    pub(super) level_sum: f32,
    pub(super) distortion_square: [f32; 2],
    pub(super) signal_square: [f32; 2],
    pub(super) residual_square: [f32; 2],
    /// Residual over signal of the device's worst block, squared.
    pub(super) dut_worst_square: f32,
    pub(super) clipped: bool,
}

impl Gathered {
    /// Adds a block, one of `wanted`.
    pub(super) fn add(&mut self, level_peak_ms2: f32, estimate: &PairEstimate, wanted: u16) {
        let (reference, dut) = (&estimate.reference, &estimate.dut);
        self.blocks = self.blocks.saturating_add(1);
        let amplitudes = [reference.amplitude, dut.amplitude];
        self.stretches.add(amplitudes, wanted);
        self.level_sum += level_peak_ms2;
        for (channel, seen) in [reference, dut].into_iter().enumerate() {
            let distortion = seen.distortion_rel();
            self.distortion_square[channel] += distortion * distortion;
            self.signal_square[channel] += 0.5 * seen.amplitude.norm_sqr();
            self.residual_square[channel] += seen.residual_rms * seen.residual_rms;
            self.clipped |= seen.clipped;
        }
        // A signal of zero makes this infinite, or no number: it does not pass.
        let signal_square = 0.5 * dut.amplitude.norm_sqr();
        let square = dut.residual_rms * dut.residual_rms / signal_square;
        self.dut_worst_square = self.dut_worst_square.max(square);
    }

    /// Of the worst block: one with half of its signal missing must not hide
    /// behind the others.
    pub(super) fn dut_worst_signal_to_noise_db(&self) -> f32 {
        -10.0 * libm::log10f(self.dut_worst_square.max(1.0e-20))
    }

    /// Blocks gathered.
    pub(super) fn count(&self) -> u16 {
        self.blocks
    }

    fn blocks(&self) -> f32 {
        f32::from(self.blocks.max(1))
    }

    /// Noise of a block's amplitude in a channel over the amplitude itself, as far as noise is white.
    pub(super) fn amplitude_noise_rel(&self, channel: usize, samples: u32) -> f32 {
        let (signal, residual) = (self.signal_square[channel], self.residual_square[channel]);
        // Residual sqrt(2/N) over the peak, the square of which is twice the mean square.
        libm::sqrtf(residual / signal.max(f32::MIN_POSITIVE) / samples.max(1) as f32)
    }

    /// Part of the tone that may be missing, relative ([`PointResult::dropout_rel`](crate::point::PointResult)), by the
    /// mean squares of both channels at rest, codes squared.
    pub(super) fn dropout_rel(&self, rest_square: [f32; 2]) -> f32 {
        let channels = self.residual_square.iter().zip(self.signal_square);
        let shares = channels.zip(rest_square).map(|((residual, signal), rest)| {
            let beyond = (residual - rest * self.blocks()).max(0.0);
            beyond / signal.max(f32::MIN_POSITIVE)
        });
        libm::sqrtf(shares.map(|share| share * share).sum())
    }

    pub(super) fn mean_level_peak(&self) -> f32 {
        self.level_sum / self.blocks()
    }

    pub(super) fn distortion_rel(&self, channel: usize) -> f32 {
        libm::sqrtf(self.distortion_square[channel] / self.blocks())
    }

    /// dB, limited to 200 for signals without any residual.
    pub(super) fn signal_to_noise_db(&self, channel: usize) -> f32 {
        let (signal, residual) = (self.signal_square[channel], self.residual_square[channel]);
        let least = signal * 1.0e-20;
        if signal > 0.0 {
            10.0 * libm::log10f(signal / residual.max(least))
        } else {
            0.0
        }
    }
}
