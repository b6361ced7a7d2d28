//! The hot path: every sample pair into an integer sum.

use crate::converter::MID_SAMPLE;
use crate::tone::MAX_PERIOD_SAMPLES;

/// Turns a pair of samples (`ADC2 << 16 | ADC1`) into two signed halves.
const OFFSET: u32 = (MID_SAMPLE as u32) << 16 | MID_SAMPLE as u32;

/// Of so many places of the fold, one has its squares summed. A prime that
/// divides no period of the preferred frequencies, so that the squared places
/// are spread evenly over the cycle however often it repeats in the fold; test
/// `squared_places_are_spread_over_the_cycle`.
pub const SQUARE_STRIDE: usize = 13;

/// Pairs folded without a look at the end: whole buffers and the usual folds are
/// multiples of it.
const GROUP: usize = 20;

/// Sums of a place of the period in offset binary as the converter gives it: the
/// reference in the low word, the device under test in the high word, each below
/// 2^31. One word of 64 bits, since the core moves those at once.
#[derive(Clone, Copy, Default)]
pub struct FoldSum(u64);

impl FoldSum {
    /// Reference and device under test.
    #[inline(always)]
    pub fn channels(self) -> [u32; 2] {
        [self.0 as u32, (self.0 >> 32) as u32]
    }

    /// Adds both halves of a pair.
    #[inline(always)]
    fn add(&mut self, pair: u32) {
        let [reference, dut] = self.channels();
        let reference = reference.wrapping_add(pair & 0xFFFF);
        let dut = dut.wrapping_add(pair >> 16);
        self.0 = u64::from(reference) | (u64::from(dut) << 32);
    }
}

/// Room for the longest fold; 96 KB, all zero at the start.
pub struct FoldMemory([FoldSum; MAX_PERIOD_SAMPLES as usize]);

impl FoldMemory {
    /// Empty memory, for a static.
    pub const fn new() -> Self {
        Self([FoldSum(0); MAX_PERIOD_SAMPLES as usize])
    }

    /// A sum for each place.
    pub(super) fn sums(&mut self) -> &mut [FoldSum] {
        &mut self.0
    }
}

impl Default for FoldMemory {
    fn default() -> Self {
        Self::new()
    }
}

/// Energy of a stretch of samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Energy {
    /// Sums of squares of both channels about mid-scale, codes squared, exact.
    pub squares: [u64; 2],
    /// Samples in those sums.
    pub samples: u32,
}

impl Energy {
    /// Adds the squares of a run that begins at `place`.
    #[inline(never)]
    pub(super) fn add(&mut self, pairs: &[u32], place: usize) {
        let skipped = (SQUARE_STRIDE - place % SQUARE_STRIDE) % SQUARE_STRIDE;
        let mut energy = *self;
        for &pair in pairs.iter().skip(skipped).step_by(SQUARE_STRIDE) {
            let [reference, dut] = squares(pair);
            energy.squares[0] = energy.squares[0].wrapping_add(u64::from(reference));
            energy.squares[1] = energy.squares[1].wrapping_add(u64::from(dut));
            energy.samples = energy.samples.wrapping_add(1);
        }
        *self = energy;
    }

    /// Mean square of a channel about mid-scale, codes squared; 0 of nothing.
    pub fn mean_square(&self, channel: usize) -> f32 {
        let sum = self.squares.get(channel).copied().unwrap_or_default();
        sum as f32 / self.samples.max(1) as f32
    }

    /// Difference to `earlier`: everything added since.
    pub fn since(self, earlier: Self) -> Self {
        Self {
            squares: [
                self.squares[0].wrapping_sub(earlier.squares[0]),
                self.squares[1].wrapping_sub(earlier.squares[1]),
            ],
            samples: self.samples.wrapping_sub(earlier.samples),
        }
    }
}

/// Squares of both halves about mid-scale, each at most 2^30.
#[inline(always)]
fn squares(pair: u32) -> [u32; 2] {
    let signed = pair ^ OFFSET;
    let reference = i32::from(signed as i16);
    let dut = (signed as i32) >> 16;
    [
        reference.wrapping_mul(reference) as u32,
        dut.wrapping_mul(dut) as u32,
    ]
}

/// Adds both halves of each pair to the sums of its place.
///
/// On the Cortex-M7 a pair is a load of the pair, a load of both sums, UXTAH, ADD
/// with LSR, and a store of both sums.
#[inline(never)]
pub(super) fn fold_run(pairs: &[u32], fold: &mut [FoldSum]) {
    let (pair_groups, pair_rest) = pairs.as_chunks::<GROUP>();
    let (whole, rest) = fold.split_at_mut(fold.len().min(pairs.len() - pair_rest.len()));
    for (pairs, sums) in pair_groups.iter().zip(whole.as_chunks_mut::<GROUP>().0) {
        for (&pair, sum) in pairs.iter().zip(sums) {
            sum.add(pair);
        }
    }
    for (&pair, sum) in pair_rest.iter().zip(rest) {
        sum.add(pair);
    }
}
