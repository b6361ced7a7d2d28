//! The hot path: every sample pair into an integer sum.

use super::block::Block;
use super::estimate::{PairEstimate, estimate};
use crate::tone::MAX_PERIOD_SAMPLES;

/// Turns a pair in offset binary (`ADC2 << 16 | ADC1`) into two signed halves.
const OFFSET: u32 = 0x8000_8000;

/// Places of the fold between two decisions whether squares are summed.
const STRIPE: usize = 128;

/// Pairs whose loop is unrolled.
const STRIDE: usize = 64;

/// Of so many stripes, the first has its squares summed.
const STRIPES: usize = 4;

/// Sums of a place of the period, reference and device under test, in offset
/// binary as the converter gives it.
pub type FoldSum = [u32; 2];

/// True for the places whose squares are summed.
pub(super) fn is_squared(place: usize) -> bool {
    (place / STRIPE).is_multiple_of(STRIPES)
}

/// Room for the longest fold; 96 KB, all zero at the start.
pub struct FoldMemory([FoldSum; MAX_PERIOD_SAMPLES as usize]);

impl FoldMemory {
    /// Empty memory, for a static.
    pub const fn new() -> Self {
        Self([[0; 2]; MAX_PERIOD_SAMPLES as usize])
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

/// Streams sample pairs into one block after another.
///
/// The low half of a pair is the reference, the high half the device under
/// test, both 16 bit offset binary.
///
/// Squares, from which the noise follows, are summed at a quarter of the
/// places: as good a sample of the noise, at a quarter of the cost.
pub struct Correlator<'m> {
    fold: &'m mut [FoldSum],
    block: Block,
    start_index: u32,
    taken: u32,
    place: usize,
    energy: Energy,
}

impl<'m> Correlator<'m> {
    /// A correlator ready for `block`, whose first sample is number
    /// `start_index` of the tone.
    pub fn new(memory: &'m mut FoldMemory, block: Block, start_index: u32) -> Self {
        let mut correlator = Self {
            fold: &mut memory.0,
            block,
            start_index,
            taken: 0,
            place: 0,
            energy: Energy::default(),
        };
        correlator.start(block, start_index);
        correlator
    }

    /// Begins another block; what was collected is forgotten.
    ///
    /// Blocks of the same tone that follow each other without a gap have the
    /// same phase reference when `start_index` counts every sample on.
    pub fn start(&mut self, block: Block, start_index: u32) {
        let length = usize::from(block.fold_samples());
        self.fold
            .iter_mut()
            .take(length)
            .for_each(|sum| *sum = [0; 2]);
        self.block = block;
        self.start_index = start_index;
        self.taken = 0;
        self.place = 0;
        self.energy = Energy::default();
    }

    /// Shape of the block in work.
    pub fn block(&self) -> Block {
        self.block
    }

    /// Samples the block still needs.
    pub fn remaining(&self) -> u32 {
        self.block.samples().saturating_sub(self.taken)
    }

    /// True when the block is full.
    pub fn is_complete(&self) -> bool {
        self.remaining() == 0
    }

    /// Adds pairs, at most as many as the block still needs; returns how many.
    ///
    /// # Timing
    /// `./run bench` counts the instructions per pair on the Cortex-M7.
    pub fn push(&mut self, pairs: &[u32]) -> usize {
        let wanted = pairs.len().min(self.remaining() as usize);
        let mut rest = pairs.get(..wanted).unwrap_or(pairs);
        while !rest.is_empty() {
            let length = self.run_length().min(rest.len());
            let (run, later) = rest.split_at(length);
            let Some(sums) = self.fold.get_mut(self.place..self.place + length) else {
                break;
            };
            fold_run(run, sums);
            if is_squared(self.place) {
                self.energy.add(run);
            }
            self.place += length;
            if self.place == usize::from(self.block.fold_samples()) {
                self.place = 0;
            }
            rest = later;
        }
        self.taken += wanted as u32;
        wanted
    }

    /// Places to the end of the stripe or of the fold.
    fn run_length(&self) -> usize {
        let to_stripe = STRIPE - self.place % STRIPE;
        let to_end = usize::from(self.block.fold_samples()) - self.place;
        to_stripe.min(to_end)
    }

    /// Energy of the squared places so far.
    pub fn energy(&self) -> Energy {
        self.energy
    }

    /// Complex amplitudes, mean, harmonics and residual of a full block.
    ///
    /// Returns `None` while the block is not complete.
    ///
    /// # Timing
    /// About 200 instructions per sample of the fold, once per block.
    pub fn estimate(&self) -> Option<PairEstimate> {
        let length = usize::from(self.block.fold_samples());
        let fold = self.fold.get(..length)?;
        self.is_complete()
            .then(|| estimate(self.block, self.start_index, fold, self.energy))
    }
}

impl Energy {
    /// Adds the squares of a run.
    fn add(&mut self, pairs: &[u32]) {
        let (strides, rest) = pairs.as_chunks::<STRIDE>();
        for stride in strides {
            add_squares(stride, &mut self.squares);
        }
        for &pair in rest {
            for (sum, square) in self.squares.iter_mut().zip(squares(pair)) {
                *sum = sum.wrapping_add(u64::from(square));
            }
        }
        self.samples = self.samples.wrapping_add(pairs.len() as u32);
    }

    /// What was added since `earlier`.
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

/// Adds the squares of both halves about mid-scale.
///
/// Four squares of at most 2^30 are summed in 32 bits. Only four samples at the
/// lowest code wrap there (to 0): a channel at its rail, which the fold shows as
/// clipped.
#[inline(never)]
fn add_squares(pairs: &[u32; STRIDE], sums: &mut [u64; 2]) {
    for group in pairs.as_chunks::<4>().0 {
        let squares = group.map(squares);
        let sum = |channel: usize| {
            let each = squares.iter().map(|square| square[channel]);
            each.fold(0, u32::wrapping_add)
        };
        sums[0] = sums[0].wrapping_add(u64::from(sum(0)));
        sums[1] = sums[1].wrapping_add(u64::from(sum(1)));
    }
}

/// Squares of both halves about mid-scale, each at most 2^30.
#[inline(always)]
fn squares(pair: u32) -> [u32; 2] {
    let signed = pair ^ OFFSET;
    let (low, high) = (i32::from(signed as i16), (signed as i32) >> 16);
    [low.wrapping_mul(low) as u32, high.wrapping_mul(high) as u32]
}

/// Adds both halves of each pair to the sums of its place.
fn fold_run(pairs: &[u32], fold: &mut [FoldSum]) {
    let (strides, rest) = pairs.as_chunks::<STRIDE>();
    let (sums, sums_rest) = fold.as_chunks_mut::<STRIDE>();
    for (stride, sums) in strides.iter().zip(sums) {
        fold_stride(stride, sums);
    }
    for (pair, sum) in rest.iter().zip(sums_rest) {
        add_pair(*pair, sum);
    }
}

/// [`fold_run`] for a length the compiler knows: it unrolls to LDR, LDRD,
/// UXTAH, ADD with LSR and STRD a pair.
#[inline(never)]
fn fold_stride(pairs: &[u32; STRIDE], fold: &mut [FoldSum; STRIDE]) {
    for (pair, sum) in pairs.iter().zip(fold) {
        add_pair(*pair, sum);
    }
}

#[inline(always)]
fn add_pair(pair: u32, sum: &mut FoldSum) {
    sum[0] = sum[0].wrapping_add(pair & 0xFFFF);
    sum[1] = sum[1].wrapping_add(pair >> 16);
}
