//! The hot path: every sample pair into an integer sum.

use super::block::Block;
use super::estimate::{PairEstimate, estimate};
use crate::tone::MAX_PERIOD_SAMPLES;

/// Turns a pair in offset binary (`ADC2 << 16 | ADC1`) into two signed halves.
const OFFSET: u32 = 0x8000_8000;

/// Pairs between two looks at the energy, see [`Correlator::push`].
const RUN: usize = 64;

/// No run with less energy than one full-scale sample can hold a clipped one.
const CLIP_ENERGY: i64 = 32_767 * 32_767;

/// Sums of a fold: reference and device under test at each place of a period.
pub type FoldSum = [i32; 2];

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

/// Streams sample pairs into one block after another.
///
/// The low half of a pair is the reference, the high half the device under
/// test, both 16 bit offset binary.
pub struct Correlator<'m> {
    fold: &'m mut [FoldSum],
    block: Block,
    start_index: u32,
    taken: u32,
    place: usize,
    squares: [i64; 2],
    clipped: [bool; 2],
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
            squares: [0; 2],
            clipped: [false; 2],
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
        self.squares = [0; 2];
        self.clipped = [false; 2];
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
    /// Clipping costs nothing while the signals are moderate: a run of 64
    /// pairs is searched for clipped samples only when its energy is at least
    /// that of one sample at full scale (an r.m.s. of 12.5 % of full scale).
    ///
    /// # Timing
    /// `./run bench` counts the instructions per pair on the Cortex-M7.
    pub fn push(&mut self, pairs: &[u32]) -> usize {
        let wanted = pairs.len().min(self.remaining() as usize);
        let mut rest = pairs.get(..wanted).unwrap_or(pairs);
        while !rest.is_empty() {
            let fold = self
                .fold
                .get_mut(self.place..self.block.fold_samples().into());
            let Some(fold) = fold else { break };
            let length = fold.len().min(rest.len());
            let (now, later) = rest.split_at(length);
            fold_pass(now, fold, &mut self.squares, &mut self.clipped);
            self.place += length;
            if self.place == usize::from(self.block.fold_samples()) {
                self.place = 0;
            }
            rest = later;
        }
        self.taken += wanted as u32;
        wanted
    }

    /// Sum of squares of both channels so far, in codes squared, exact.
    pub fn squares(&self) -> [i64; 2] {
        self.squares
    }

    /// True for each channel that reached an end of the converter's range.
    pub fn clipped(&self) -> [bool; 2] {
        self.clipped
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
        self.is_complete().then(|| {
            estimate(
                self.block,
                self.start_index,
                fold,
                self.squares,
                self.clipped,
            )
        })
    }
}

/// Adds `pairs` to the sums at the same places, run by run.
fn fold_pass(pairs: &[u32], fold: &mut [FoldSum], squares: &mut [i64; 2], clipped: &mut [bool; 2]) {
    for (run, sums) in pairs.chunks(RUN).zip(fold.chunks_mut(RUN)) {
        let energy = fold_run(run, sums);
        if energy.iter().any(|&e| e >= CLIP_ENERGY) {
            search_clipped(run, clipped);
        }
        squares[0] = squares[0].wrapping_add(energy[0]);
        squares[1] = squares[1].wrapping_add(energy[1]);
    }
}

/// Adds one run and returns its sums of squares.
///
/// Eight pairs at a time: on the Cortex-M7 a pair becomes half an LDRD, EOR,
/// LDRD, SXTAH, ADD with ASR, STRD, SMLALBB and SMLALTT.
#[inline(never)]
fn fold_run(pairs: &[u32], fold: &mut [FoldSum]) -> [i64; 2] {
    let mut energy = [0_i64; 2];
    let (pair_groups, pair_rest) = pairs.as_chunks::<8>();
    let (sum_groups, sum_rest) = fold.as_chunks_mut::<8>();
    for (group, sums) in pair_groups.iter().zip(sum_groups.iter_mut()) {
        for (&pair, sum) in group.iter().zip(sums) {
            add_pair(pair, sum, &mut energy);
        }
    }
    // What is left is shorter than a group in `pairs`; in `fold` it follows
    // the groups that were used.
    let used = pair_groups.len();
    let tail = sum_groups
        .get_mut(used)
        .map_or(sum_rest, |group| group.as_mut_slice());
    for (&pair, sum) in pair_rest.iter().zip(tail) {
        add_pair(pair, sum, &mut energy);
    }
    energy
}

/// One pair: both halves signed, added to their sums and squared.
#[inline(always)]
fn add_pair(pair: u32, sum: &mut FoldSum, energy: &mut [i64; 2]) {
    let signed = pair ^ OFFSET;
    let reference = i32::from(signed as i16);
    let dut = (signed as i32) >> 16;
    sum[0] = sum[0].wrapping_add(reference);
    sum[1] = sum[1].wrapping_add(dut);
    energy[0] = energy[0].wrapping_add(i64::from(reference.wrapping_mul(reference)));
    energy[1] = energy[1].wrapping_add(i64::from(dut.wrapping_mul(dut)));
}

/// Marks the channels that show the first or the last code.
#[cold]
#[inline(never)]
fn search_clipped(pairs: &[u32], clipped: &mut [bool; 2]) {
    for &pair in pairs {
        let (reference, dut) = (pair & 0xFFFF, pair >> 16);
        clipped[0] |= reference == 0 || reference == 0xFFFF;
        clipped[1] |= dut == 0 || dut == 0xFFFF;
    }
}
