//! Blocks of sample pairs, one after another: folded as they come, estimated when full.

use super::block::Block;
use super::estimate::{PairEstimate, estimate};
use super::fold::{Energy, FoldMemory, FoldSum, fold_run};
use super::outline::{Outline, outline};
use crate::converter::Width;

/// Streams sample pairs into one block after another.
///
/// The low half of a pair is the reference, the high half the device under
/// test, both samples in the sense of [`crate::converter`].
///
/// Squares, which tell how much the samples scatter from period to period, are
/// summed at every 13th place: the scatter of so many samples is known well
/// enough from some hundred of them. Nothing else is sampled; mean, amplitudes
/// and what repeats in every period come from the sums of all samples.
pub struct Correlator<'m> {
    fold: &'m mut [FoldSum],
    width: Width,
    block: Block,
    start_index: u32,
    taken: u32,
    place: usize,
    energy: Energy,
}

impl<'m> Correlator<'m> {
    /// A correlator ready for `block`, whose first sample is number
    /// `start_index` of the tone, behind converters of `width`.
    pub fn new(memory: &'m mut FoldMemory, width: Width, block: Block, start_index: u32) -> Self {
        let mut correlator = Self {
            fold: memory.sums(),
            width,
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
            .for_each(|sum| *sum = FoldSum::default());
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

    /// Number, of the tone, of the block's first sample.
    pub fn start_index(&self) -> u32 {
        self.start_index
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
            let to_end = usize::from(self.block.fold_samples()) - self.place;
            let (run, later) = rest.split_at(to_end.min(rest.len()));
            let length = run.len();
            let Some(sums) = self.fold.get_mut(self.place..self.place + length) else {
                break;
            };
            fold_run(run, sums);
            self.energy.add(run, self.place);
            self.place += length;
            if self.place == usize::from(self.block.fold_samples()) {
                self.place = 0;
            }
            rest = later;
        }
        self.taken += wanted as u32;
        wanted
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
    /// About 160 instructions per sample of the fold, once per block: `./run bench target` counts them.
    pub fn estimate(&self) -> Option<PairEstimate> {
        let length = usize::from(self.block.fold_samples());
        let fold = self.fold.get(..length)?;
        self.is_complete()
            .then(|| estimate(self.block, self.start_index, fold, self.energy, self.width))
    }

    /// Outline of a full block of one pass; `None` of any other.
    ///
    /// # Timing
    /// About 10 instructions per place of the fold.
    pub fn outline(&self) -> Option<Outline> {
        let fold = self.fold.get(..usize::from(self.block.fold_samples()))?;
        (self.is_complete() && self.block.passes() == 1).then(|| outline(fold))
    }
}
