//! A fold seen from its middle.

use super::block::Block;
use super::fold::FoldSum;
use super::sums::Sums;
use crate::phase::PhaseWalk;
use num_complex::Complex32;

/// Highest harmonic that is looked at.
pub(super) const HARMONICS: usize = 5;

/// Complex amplitudes of harmonics 1 to 5.
pub(super) type Spectrum = [Complex32; HARMONICS];

/// A fold about its middle: places as far before it as behind it have the same cosines and opposite
/// sines, so that two places cost the sines of one.
pub(super) struct Mirror<'f> {
    /// Before the middle, outwards from it when read from the end.
    before: &'f [FoldSum],
    /// In the middle, of an odd number of places.
    centre: Option<FoldSum>,
    /// Behind the middle, outwards.
    behind: &'f [FoldSum],
    /// Angles from the middle outwards.
    walk: PhaseWalk,
    /// `exp(j h phase)` of the middle, h = 1 to 5.
    middle: Spectrum,
}

impl<'f> Mirror<'f> {
    /// A fold whose first place is sample `start_index` of the block's tone.
    pub(super) fn new(block: Block, start_index: u32, fold: &'f [FoldSum]) -> Self {
        let tone = block.tone();
        let (before, rest) = fold.split_at(fold.len() / 2);
        let (centre, behind) = match rest.split_first() {
            Some((centre, behind)) if behind.len() == before.len() => (Some(*centre), behind),
            _ => (None, rest),
        };
        let start = start_index % u32::from(tone.period_samples).max(1);
        let halves = (2 * start + fold.len() as u32).saturating_sub(1);
        // The next places are half a sample away, or a whole one from a place in the middle.
        let nearest = 1 + u32::from(centre.is_some());
        Self {
            before,
            centre,
            behind,
            walk: PhaseWalk::from_halves(tone, nearest),
            middle: harmonic_phasors(PhaseWalk::from_halves(tone, halves).next_cos_sin()),
        }
    }

    /// Places of the fold; 1 of an empty one, for divisions.
    pub(super) fn places(&self) -> f32 {
        let centre = usize::from(self.centre.is_some());
        (self.before.len() + self.behind.len() + centre).max(1) as f32
    }

    /// The place in the middle, whose phasors are 1.
    pub(super) fn centre(&self) -> Option<FoldSum> {
        self.centre
    }

    /// Both places of each distance, the one before the middle first, with the phasors of the one behind.
    pub(super) fn pairs(&self) -> impl Iterator<Item = (Spectrum, [FoldSum; 2])> + 'f {
        let mut walk = self.walk;
        let places = self.before.iter().rev().zip(self.behind);
        places.map(move |(before, behind)| {
            (harmonic_phasors(walk.next_cos_sin()), [*before, *behind])
        })
    }

    /// Amplitudes with phases from sample 0 of the tone, of those with phases from the middle.
    pub(super) fn since_start(&self, about_middle: &Spectrum) -> Spectrum {
        let mut turned = *about_middle;
        for (amplitude, middle) in turned.iter_mut().zip(self.middle) {
            *amplitude *= middle.conj();
        }
        turned
    }

    /// Mean of `exp(-2j phase)` over the places, phases from the middle, by which a fundamental leaks into
    /// itself: real, since the places are symmetric.
    pub(super) fn leakage(&self) -> f32 {
        let mut sums = Sums::<1>::new();
        sums.add([if self.centre.is_some() { 1.0 } else { 0.0 }]);
        for ([_, second, ..], _) in self.pairs() {
            sums.add([2.0 * second.re]);
        }
        let [sum] = sums.total();
        sum / self.places()
    }
}

/// exp(j h phase) for h = 1 to 5, by multiplication.
#[inline]
fn harmonic_phasors((cosine, sine): (f32, f32)) -> [Complex32; HARMONICS] {
    let first = Complex32::new(cosine, sine);
    let second = first * first;
    let third = second * first;
    [first, second, third, second * second, third * second]
}
