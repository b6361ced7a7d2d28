//! Correlation done plainly: every sample times a table of sines, in f32.

use crate::PAIRS;
use calib_core::phase::PhaseWalk;
use calib_core::tone::Tone;

/// Cosine and sine of every sample of a buffer.
pub(crate) struct Table([[f32; 2]; PAIRS]);

impl Table {
    /// A table to be filled.
    pub(crate) const EMPTY: Self = Self([[0.0; 2]; PAIRS]);

    /// Fills in the sines of `tone`.
    pub(crate) fn fill(&mut self, tone: Tone) {
        let mut walk = PhaseWalk::new(tone, 0);
        for entry in &mut self.0 {
            let (cosine, sine) = walk.next_cos_sin();
            *entry = [cosine, sine];
        }
    }
}

/// Cosine and sine sums of both channels over a buffer.
#[unsafe(no_mangle)]
#[inline(never)]
pub(crate) fn kernel_table(table: &Table, pairs: &[u32; PAIRS]) -> [f32; 4] {
    let mut sums = [0.0_f32; 4];
    for (&pair, [cosine, sine]) in pairs.iter().zip(&table.0) {
        let signed = pair ^ 0x8000_8000;
        let reference = f32::from(signed as i16);
        let dut = f32::from((signed >> 16) as i16);
        sums[0] += reference * cosine;
        sums[1] += reference * sine;
        sums[2] += dut * cosine;
        sums[3] += dut * sine;
    }
    sums
}
