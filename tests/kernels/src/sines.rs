//! Cosine and sine of every sample of a buffer, in three ways.

use crate::PAIRS;
use calib_core::phase::PhaseWalk;
use micromath::F32Ext;

/// Sums of both over a walk of exact fractions of a turn, as the correlation takes them.
#[unsafe(no_mangle)]
#[inline(never)]
pub(crate) fn kernel_sines(mut walk: PhaseWalk) -> [f32; 2] {
    sums([(); PAIRS].iter().map(|()| walk.next_cos_sin()))
}

/// Sums of cosines and sines of angles in radians, by `libm`.
#[unsafe(no_mangle)]
#[inline(never)]
pub(crate) fn kernel_sines_libm(angles: &[f32; PAIRS]) -> [f32; 2] {
    sums(angles.iter().map(|&x| (libm::cosf(x), libm::sinf(x))))
}

/// Sums of cosines and sines of angles in radians, by `micromath`.
#[unsafe(no_mangle)]
#[inline(never)]
pub(crate) fn kernel_sines_micromath(angles: &[f32; PAIRS]) -> [f32; 2] {
    sums(angles.iter().map(|&x| (F32Ext::cos(x), F32Ext::sin(x))))
}

#[inline(always)]
fn sums(pairs: impl Iterator<Item = (f32, f32)>) -> [f32; 2] {
    pairs.fold([0.0; 2], |[cosines, sines], (cosine, sine)| {
        [cosines + cosine, sines + sine]
    })
}
