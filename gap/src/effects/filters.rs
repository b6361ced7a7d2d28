//! Filters of the conditioning.

use super::effect::{Effect, Explanations};
use super::facts::Facts;
use super::resonance::second_order;
use super::start::{Start, ratios};
use crate::model::chain::Transfer;
use crate::model::row::Row;
use calib_effects::{Entry, conditioning};
use num_complex::Complex64;
use std::f64::consts::PI;

pub(super) static EXPLANATIONS: Explanations = &[
    &Filter::DutHighpass,
    &Filter::ReferenceHighpass,
    &Filter::DutLowpass1,
    &Filter::ReferenceLowpass1,
    &Filter::AveragingWindow,
    &Lowpass2,
];

/// Filters with one parameter.
enum Filter {
    DutHighpass,
    ReferenceHighpass,
    DutLowpass1,
    ReferenceLowpass1,
    AveragingWindow,
}

/// Second-order low-pass without a resonance peak to speak of.
struct Lowpass2;

impl Filter {
    fn is_of_reference(&self) -> bool {
        matches!(self, Self::ReferenceHighpass | Self::ReferenceLowpass1)
    }

    fn response(&self, p: f64, frequency_hz: f64) -> Complex64 {
        match self {
            Self::DutHighpass | Self::ReferenceHighpass => {
                let q = Complex64::new(0.0, frequency_hz / p);
                q / (1.0 + q)
            }
            Self::DutLowpass1 | Self::ReferenceLowpass1 => {
                Complex64::new(1.0, frequency_hz / p).inv()
            }
            Self::AveragingWindow => {
                let angle = PI * frequency_hz * p;
                Complex64::from_polar(1.0, -angle) * (angle.sin() / angle)
            }
        }
    }
}

impl Effect for Filter {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        match self {
            Self::DutHighpass => &conditioning::DUT_HIGHPASS,
            Self::ReferenceHighpass => &conditioning::REFERENCE_HIGHPASS,
            Self::DutLowpass1 => &conditioning::DUT_LOWPASS_1,
            Self::ReferenceLowpass1 => &conditioning::REFERENCE_LOWPASS_1,
            Self::AveragingWindow => &conditioning::AVERAGING_WINDOW,
        }
    }
    /// Without the drive its inverse in the ratio is a crosstalk in quadrature.
    fn alike(&self, facts: &Facts) -> Option<&'static Entry> {
        (matches!(self, Self::ReferenceLowpass1) && !facts.drive)
            .then_some(&conditioning::CROSSTALK)
    }
    fn applies(&self, facts: &Facts) -> bool {
        let ratio = facts.ratio || facts.ratio_phase;
        match self {
            // Its twin stands for it where no drive tells them apart, or the two would make a pair.
            Self::ReferenceLowpass1 => facts.drive,
            Self::ReferenceHighpass => ratio || facts.drive,
            _ => ratio,
        }
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let values = match self {
            Self::DutHighpass | Self::ReferenceHighpass => {
                ratios(0.0005 * facts.lowest_hz, 4.0 * facts.lowest_hz, 20)
            }
            Self::DutLowpass1 | Self::ReferenceLowpass1 => {
                ratios(0.2 * facts.highest_hz, 5000.0 * facts.highest_hz, 22)
            }
            Self::AveragingWindow => ratios(0.0002 / facts.highest_hz, 1.5 / facts.highest_hz, 22),
        };
        values.into_iter().map(|v| Start::shape(vec![v])).collect()
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let response = self.response(p[0], frequency_hz);
        if self.is_of_reference() {
            transfer.reference *= response;
        } else {
            transfer.dut *= response;
        }
    }
}

impl Effect for Lowpass2 {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &conditioning::DUT_LOWPASS_2
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.ratio || facts.ratio_phase
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let corners = ratios(0.2 * facts.highest_hz, 2000.0 * facts.highest_hz, 22);
        corners
            .into_iter()
            .flat_map(|c| [0.55, 0.75, 0.95].map(|q| Start::shape(vec![c, q])))
            .collect()
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        transfer.dut *= second_order(frequency_hz, p[0], p[1]);
    }
}
