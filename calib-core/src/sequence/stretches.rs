//! Amplitudes of both channels over the blocks of a point, and their ratio without the mains.

use super::scatter::Scatter;
use crate::hum::{Hum, Left, Span, separate};
use num_complex::Complex32;

/// Most stretches kept: more blocks than that share them, an equal number each.
const MOST: usize = 32;

/// Amplitudes of blocks that follow each other without a gap, reference and device.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretches {
    amplitudes: [[Complex32; MOST]; 2],
    count: usize,
    /// Blocks of a stretch, and those the last one has.
    blocks_each: u16,
    begun: u16,
}

impl Default for Stretches {
    fn default() -> Self {
        Self {
            amplitudes: [[Complex32::new(0.0, 0.0); MOST]; 2],
            count: 0,
            blocks_each: 1,
            begun: 0,
        }
    }
}

/// Ratio of the channels over the stretches.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Ratio {
    /// Mean and scatter.
    pub(super) scatter: Scatter,
    /// Amplitude of what the mains may still do to it, relative, at an unknown phase.
    pub(super) hum_rel: f32,
    /// Standard deviation of the mean by the noise within blocks, relative.
    pub(super) noise_rel: f32,
    /// Complex amplitudes of lines that were fitted beside it.
    pub(super) fitted: usize,
    /// Largest change of the reference's amplitude from one part of the point to another, relative.
    pub(super) moved_rel: f32,
}

impl Stretches {
    /// Adds the amplitudes of a block, one of `wanted` in all.
    pub(super) fn add(&mut self, amplitudes: [Complex32; 2], wanted: u16) {
        if self.count == 0 {
            self.blocks_each = wanted.div_ceil(MOST as u16).max(1);
        }
        if self.begun == 0 || self.begun == self.blocks_each {
            self.count = (self.count + 1).min(MOST);
            self.begun = 0;
        }
        self.begun += 1;
        let share = 1.0 / f32::from(self.begun);
        for (channel, amplitude) in self.amplitudes.iter_mut().zip(amplitudes) {
            if let Some(mean) = channel.get_mut(self.count - 1) {
                // Blocks of equal length one after another: the amplitude of all is the mean.
                *mean += (amplitude - *mean) * share;
            }
        }
    }

    /// Blocks of a stretch.
    pub(super) fn blocks_each(&self) -> u16 {
        self.blocks_each
    }

    /// The ratio, with the lines of `hum` taken out of both channels. `span` is that of the stretches,
    /// `noise_rel` the noise of their amplitudes.
    pub(super) fn ratio(&self, hum: Option<&Hum>, span: &Span, noise_rel: [f32; 2]) -> Ratio {
        let mut amplitudes = self.amplitudes;
        let (mut hum_square, mut fitted) = (0.0, 0);
        if let Some(hum) = hum {
            for ((channel, values), noise) in amplitudes.iter_mut().enumerate().zip(noise_rel) {
                let values = values.get_mut(..self.count).unwrap_or_default();
                let left = separate(values, channel, span, hum, noise);
                let Left { relative, .. } = left;
                hum_square += relative * relative;
                fitted = fitted.max(left.fitted);
            }
        }
        let [reference, dut] = &amplitudes;
        let mut scatter = Scatter::default();
        for (reference, dut) in reference.iter().zip(dut).take(self.count) {
            scatter.add(dut / reference);
        }
        scatter.fit_took(fitted);
        let noise_square = noise_rel.iter().map(|noise| noise * noise).sum::<f32>();
        Ratio {
            hum_rel: libm::sqrtf(hum_square),
            noise_rel: libm::sqrtf(noise_square / f32::from(scatter.count().max(1))),
            fitted,
            moved_rel: moved_rel(reference.get(..self.count).unwrap_or_default()),
            scatter,
        }
    }
}

/// Largest change of an amplitude from one third of a point to another, relative.
///
/// Relative change over a measurement: of two means of a third each. Motion beside the tone beats from block to block
/// and shows less in them, a drift as much.
fn moved_rel(amplitudes: &[Complex32]) -> f32 {
    let count = amplitudes.len();
    let (mut lowest, mut highest) = (f32::INFINITY, 0.0_f32);
    for third in 0..3 {
        let part = amplitudes.get(third * count / 3..(third + 1) * count / 3);
        let part = part.unwrap_or_default();
        if !part.is_empty() {
            let level = part.iter().sum::<Complex32>().norm() / part.len() as f32;
            lowest = lowest.min(level);
            highest = highest.max(level);
        }
    }
    2.0 * (highest - lowest) / (highest + lowest)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPAN: Span = Span {
        tone_per_sample: 0.0032,
        sample_rate_hz: 50_000.0,
        samples: 5000,
        start: Complex32::new(1.0, 0.0),
    };

    #[test]
    fn many_blocks_share_the_stretches() {
        for (blocks, each, count) in [(10, 1, 10), (32, 1, 32), (33, 2, 17), (1000, 32, 32)] {
            let mut stretches = Stretches::default();
            for block in 0..blocks {
                let dut = Complex32::new(1.0 + f32::from(block) / f32::from(blocks), 0.0);
                stretches.add([Complex32::new(1.0, 0.0), dut], blocks);
            }
            assert_eq!((stretches.blocks_each, stretches.count), (each, count));
            let mean = stretches.ratio(None, &SPAN, [0.0; 2]).scatter.mean();
            // The mean of so many steps is 1.5 less half a step; the last stretch may be shorter and counts
            // as one of all the same, which moves the mean by half of its share of 1/17.
            let moved = 0.5 / f32::from(blocks) + 0.5 / 17.0;
            assert!((mean.re - 1.5).abs() < moved, "{mean}");
        }
    }

    /// By hand: of ten amplitudes that rise by 1 % in all the first third has the mean of three and the last that of four,
    /// 1/9 % apart each: 0.722 %. A beat of 1 % that turns by 2.2 rad from block to block leaves 2 % from block to block,
    /// and of a third at most sin(1.5 x 2.2) / (3 sin 1.1) = 6 % of itself either way.
    #[test]
    fn a_drift_moves_the_amplitude_and_a_beat_hardly_does() {
        let amplitudes = |of: fn(f32) -> f32| {
            [0_u16; 10]
                .iter()
                .enumerate()
                .map(move |(k, _)| Complex32::from_polar(1.0 + 0.01 * of(k as f32), 0.7))
        };
        let moved = |of| {
            let amplitudes: heapless::Vec<Complex32, 10> = amplitudes(of).collect();
            moved_rel(&amplitudes)
        };
        let drift = moved(|k| k / 9.0);
        assert!((drift - 0.00722).abs() < 5.0e-5, "{drift}");
        let beat = moved(|k| libm::cosf(2.2 * k));
        assert!(beat < 0.12 * 0.02, "{beat}");
        // Three blocks and two are their own thirds.
        let few: [Complex32; 3] = [1.0, 1.002, 1.001].map(Complex32::from);
        assert!((moved_rel(&few) - 0.002).abs() < 1.0e-5);
        assert!((moved_rel(&few[..2]) - 0.002).abs() < 1.0e-5);
    }
}
