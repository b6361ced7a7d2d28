//! The hot path: every sample pair into an integer sum.

use super::block::Block;
use super::estimate::{PairEstimate, estimate};
use crate::tone::MAX_PERIOD_SAMPLES;

/// Turns a pair in offset binary (`ADC2 << 16 | ADC1`) into two signed halves.
const OFFSET: u32 = 0x8000_8000;

/// Places of the fold between two decisions whether squares are summed.
const STRIPE: usize = 128;

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
    ///
    /// Four squares of at most 2^30 fit 32 bits unless all four samples are
    /// the lowest code, so they are summed one by one into 33 bits: the first
    /// two and the last two, each at most 2^31.
    #[inline(never)]
    fn add(&mut self, pairs: &[u32]) {
        let (groups, rest) = pairs.as_chunks::<2>();
        let [mut reference, mut dut] = self.squares;
        for group in groups {
            let [first, second] = group.map(squares);
            reference = reference.wrapping_add(u64::from(first[0].wrapping_add(second[0])));
            dut = dut.wrapping_add(u64::from(first[1].wrapping_add(second[1])));
        }
        for &pair in rest {
            let squares = squares(pair);
            reference = reference.wrapping_add(u64::from(squares[0]));
            dut = dut.wrapping_add(u64::from(squares[1]));
        }
        self.squares = [reference, dut];
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
/// On the Cortex-M7 a pair becomes LDR, LDRD, UXTAH, ADD with LSR and STRD.
#[inline(never)]
fn fold_run(pairs: &[u32], fold: &mut [FoldSum]) {
    for (&pair, sum) in pairs.iter().zip(fold) {
        sum[0] = sum[0].wrapping_add(pair & 0xFFFF);
        sum[1] = sum[1].wrapping_add(pair >> 16);
    }
}
