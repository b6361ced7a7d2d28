//! The power amplifier.

use crate::model::chain::Chain;
use crate::model::effect::{Effect, Explanations, Start, ratios};
use crate::model::facts::Facts;
use crate::model::row::Row;
use calib_effects::{Entry, amplifier};

pub(super) static EXPLANATIONS: Explanations = &[
    &Amplifier::Clipping,
    &Amplifier::SoftClipping,
    &Amplifier::EvenOrder,
];

/// Distortion of the coil voltage.
enum Amplifier {
    Clipping,
    SoftClipping,
    EvenOrder,
}

impl Effect for Amplifier {
    fn entry(&self) -> &'static Entry {
        match self {
            Self::Clipping => &amplifier::CLIPPING,
            Self::SoftClipping => &amplifier::SOFT_CLIPPING,
            Self::EvenOrder => &amplifier::EVEN_ORDER,
        }
    }
    fn makes_nonlinear(&self) -> bool {
        true
    }
    fn saturates(&self) -> bool {
        matches!(self, Self::Clipping)
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.exciter_known && facts.level_known && (facts.ref_harmonics || facts.dut_harmonics)
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        match self {
            Self::Clipping => ratios(0.79, 0.999, 14)
                .into_iter()
                .map(|s| Start::shape(vec![s * facts.largest_coil_peak_v]))
                .collect(),
            Self::SoftClipping => {
                vec![Start::positive(vec![5.0 * facts.largest_coil_peak_v], 0)]
            }
            Self::EvenOrder => vec![Start::signed(vec![0.001 / facts.largest_coil_peak_v], 0)],
        }
    }
    /// The effect of a knee goes with the square of its reciprocal.
    fn combine(&self, start: &Start, amplitudes: &[f64]) -> Vec<f64> {
        let size = amplitudes[0];
        match self {
            Self::SoftClipping => vec![start.members[0][0] / size.max(1e-8).sqrt()],
            _ => start.scaled(size),
        }
    }
    fn chain(&self, p: &[f64], _row: &Row, chain: &mut Chain) {
        match self {
            Self::Clipping => chain.bend.clip_v = Some(p[0]),
            Self::SoftClipping => chain.bend.knee_v = Some(p[0]),
            Self::EvenOrder => chain.bend.even_per_v += p[0],
        }
    }
}
