//! How many samples a block holds and how they are folded.

use crate::tone::{MAX_PERIOD_SAMPLES, Tone};

/// Shortest fold, in samples: short periods are repeated up to this length, so
/// that the inner loop runs long and the sums stay small.
pub const MIN_FOLD_SAMPLES: u32 = 500;

/// Most passes over a fold: each adds at most 65 535 to a sum, and sums stay
/// below 2^31 so that their differences fit 32 bits.
pub const MAX_PASSES: u32 = 32_767;

/// Most fractional cycles, per cycle, of a block of the level loop.
const MAX_CYCLE_ERROR_REL: f32 = 1.0e-3;
/// And of one that only shows whether something is there.
const ROUGH_CYCLE_ERROR_REL: f32 = 1.0e-2;

/// Shape of a block: a fold of `fold_samples`, passed `passes` times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    tone: Tone,
    fold_samples: u16,
    passes: u32,
}

impl Block {
    /// Whole periods of `tone`, at least `min_samples` samples long.
    ///
    /// # Overflow
    /// A sum takes one code of at most 65 535 per pass and `passes` is at most
    /// 32 767: `65 535 * 32 767 < 2^31`. With folds of 500 samples or
    /// more the limit is 16.4 million samples, 327 s at 50 kS/s; longer
    /// requests give that longest block.
    pub fn measuring(tone: Tone, min_samples: u32) -> Self {
        let period = u32::from(tone.period_samples).max(1);
        // At least one sample, which the compiler does not see: a division by it must not panic.
        let fold = (period * MIN_FOLD_SAMPLES.div_ceil(period)).max(1);
        Self {
            tone,
            // A period is at most MAX_PERIOD_SAMPLES, a repeated one at most 999.
            fold_samples: fold.min(u32::from(MAX_PERIOD_SAMPLES)) as u16,
            passes: min_samples.div_ceil(fold).clamp(1, MAX_PASSES),
        }
    }

    /// At least `samples` samples to be passed over, and at most one in a thousand more.
    pub fn discard(tone: Tone, samples: u32) -> Self {
        let passes = samples
            .div_ceil(u32::from(MAX_PERIOD_SAMPLES))
            .clamp(1, MAX_PASSES);
        let fold = samples.div_ceil(passes).max(1);
        Self {
            tone,
            fold_samples: fold.min(u32::from(MAX_PERIOD_SAMPLES)) as u16,
            passes,
        }
    }

    /// As many whole cycles, within 1 % of one each, as `most_samples` hold; none where that is less than one. Good
    /// enough to see whether something is there.
    pub fn within(tone: Tone, most_samples: u32) -> Option<Self> {
        Self::most_cycles(tone, most_samples, ROUGH_CYCLE_ERROR_REL)
    }

    /// The longest block of at most `most_samples` good enough for the amplitude loop; none where a cycle is longer.
    pub fn control_within(tone: Tone, most_samples: u32) -> Option<Self> {
        Self::most_cycles(tone, most_samples, MAX_CYCLE_ERROR_REL)
    }

    fn most_cycles(tone: Tone, most_samples: u32, error_rel: f32) -> Option<Self> {
        let period = u32::from(tone.period_samples).max(1);
        let cycles = u32::from(tone.cycles).max(1);
        let most = most_samples.min(u32::from(MAX_PERIOD_SAMPLES)) * cycles / period;
        (1..=most)
            .rev()
            .find_map(|whole| Self::of_cycles(tone, whole, error_rel))
    }

    /// The shortest block good enough for the amplitude loop.
    ///
    /// Tones of several cycles in a long period (31.5 Hz: 3 cycles in 4762
    /// samples) would make the loop wait; here one pass over the samples
    /// nearest to fewer whole cycles is taken when it is at most 0.1 % of a
    /// cycle off. The leakage of the fundamental into itself is then solved
    /// for (`docs/metrology/measurement.md`). Of measuring blocks only short ones may be such.
    pub fn control(tone: Tone) -> Self {
        Self::control_of(tone, MIN_FOLD_SAMPLES)
    }

    /// The shortest such block of at least `min_samples` samples: what noise
    /// asks for, in steps of a cycle where the period has several.
    pub fn control_of(tone: Tone, min_samples: u32) -> Self {
        let min_samples = min_samples.max(MIN_FOLD_SAMPLES);
        (1..u32::from(tone.cycles))
            .filter_map(|whole| Self::of_cycles(tone, whole, MAX_CYCLE_ERROR_REL))
            .find(|block| block.samples() >= min_samples)
            .unwrap_or_else(|| Self::measuring(tone, min_samples))
    }

    /// One pass over the samples nearest to so many cycles, if they are as near as `error_rel` per cycle.
    fn of_cycles(tone: Tone, whole: u32, error_rel: f32) -> Option<Self> {
        let (period, cycles) = (u32::from(tone.period_samples), u32::from(tone.cycles));
        let samples = (whole * period + cycles / 2) / cycles.max(1);
        let error = (samples * cycles).abs_diff(whole * period);
        let allowed = error_rel * (whole * period) as f32;
        (error as f32 <= allowed).then_some(Self {
            tone,
            fold_samples: samples as u16,
            passes: 1,
        })
    }

    /// True when every pass is whole periods of the tone.
    pub fn is_exact(self) -> bool {
        self.fold_samples.is_multiple_of(self.tone.period_samples)
    }

    /// Tone the block is correlated with.
    pub fn tone(self) -> Tone {
        self.tone
    }

    /// Samples of one pass.
    pub fn fold_samples(self) -> u16 {
        self.fold_samples
    }

    /// Passes over the fold.
    pub fn passes(self) -> u32 {
        self.passes
    }

    /// Samples of the block.
    pub fn samples(self) -> u32 {
        u32::from(self.fold_samples) * self.passes
    }
}
