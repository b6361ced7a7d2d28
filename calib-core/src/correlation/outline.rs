//! A full block in few values: what is slow in it.

use super::fold::FoldSum;
use crate::converter::MID_SAMPLE;

/// Values of an outline.
pub const OUTLINE: usize = 500;

/// Means of both channels over each of 500 equal parts of a fold, codes about mid-scale.
pub type Outline = [[f32; 2]; OUTLINE];

/// Outline of a fold passed once; parts of whole places, so that a fold of fewer has none beyond.
#[inline(never)]
pub(super) fn outline(fold: &[FoldSum]) -> Outline {
    let part = (fold.len() / OUTLINE).max(1);
    let mut outline = [[0.0; 2]; OUTLINE];
    for (values, places) in outline.iter_mut().zip(fold.chunks_exact(part)) {
        for (channel, value) in values.iter_mut().enumerate() {
            let sums = places
                .iter()
                .filter_map(|place| place.channels().get(channel).copied());
            let beside = sums.map(|sum| sum.wrapping_sub(u32::from(MID_SAMPLE)) as i32);
            // Parts have some ten places: the sum is exact.
            *value = beside.sum::<i32>() as f32 / part as f32;
        }
    }
    outline
}
