//! The correlation that ships.

use crate::PAIRS;
use calib_core::correlation::{Correlator, PairEstimate};
use calib_core::tone::Tone;

/// 160 Hz: a fold of 625 pairs, so that buffers and folds do not coincide.
pub(crate) const TONE: Tone = Tone {
    cycles: 2,
    period_samples: 625,
};

/// Adds a buffer to the block in work.
#[unsafe(no_mangle)]
#[inline(never)]
pub(crate) fn kernel_fold(correlator: &mut Correlator<'_>, pairs: &[u32; PAIRS]) {
    correlator.push(pairs);
}

/// Evaluates a full block.
#[unsafe(no_mangle)]
#[inline(never)]
pub(crate) fn kernel_estimate(correlator: &Correlator<'_>) -> Option<PairEstimate> {
    correlator.estimate()
}
