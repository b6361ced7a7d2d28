//! The power amplifier.

use super::about::{About, Parameter, Stage};
use super::start::{Start, ratios};
use super::{Effect, Facts};
use crate::model::chain::Chain;
use crate::model::row::Row;

/// Distortion of the coil voltage.
pub(super) enum Amplifier {
    Clipping,
    EvenOrder,
}

static CLIPPING: About = About {
    id: "amplifier_clipping",
    stage: Stage::Amplifier,
    formula: "coil voltage saturates at a threshold: odd harmonics in both channels",
    parameters: &[Parameter::log("threshold_v", "V", 1e-3, 1e4)],
    columns: &["coil_v", "ref_h3", "dut_h3", "ref_h5", "dut_h5"],
    confused_with: &["suspension_cubic"],
    separate_by: "harmonics at the highest coil voltage, at several frequencies",
};
static EVEN: About = About {
    id: "amplifier_even_order",
    stage: Stage::Amplifier,
    formula: "coil voltage e + b e^2: H2 as V in both channels",
    parameters: &[Parameter::linear("even_per_v", "1/V", -1.0, 1.0)],
    columns: &["coil_v", "ref_h2", "dut_h2"],
    confused_with: &["suspension_asymmetry"],
    separate_by: "harmonics at the highest coil voltage, at several frequencies",
};

impl Effect for Amplifier {
    fn about(&self) -> &'static About {
        match self {
            Self::Clipping => &CLIPPING,
            Self::EvenOrder => &EVEN,
        }
    }
    fn bends(&self) -> bool {
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
            Self::EvenOrder => vec![Start::signed(vec![0.001 / facts.largest_coil_peak_v], 0)],
        }
    }
    fn chain(&self, p: &[f64], _row: &Row, chain: &mut Chain) {
        match self {
            Self::Clipping => chain.bend.clip_v = Some(p[0]),
            Self::EvenOrder => chain.bend.even_per_v += p[0],
        }
    }
}
