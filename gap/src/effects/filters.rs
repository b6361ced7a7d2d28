//! Filters of the conditioning.

use super::resonance::second_order;
use crate::model::chain::Transfer;
use crate::model::effect::{Effect, Explanations, Start, ratios};
use crate::model::facts::Facts;
use crate::model::row::Row;
use crate::thresholds;
use calib_effects::{Entry, Parameter, conditioning};
use num_complex::Complex64;
use std::f64::consts::PI;

pub(super) static EXPLANATIONS: Explanations = &[
    &Filter::DutHighpass,
    &Filter::ReferenceHighpass,
    &Filter::DutLowpass1,
    &Filter::ReferenceLowpass1,
    &Filter::AveragingWindow,
    &Lowpass2,
    &Highpass2::Dut,
    &Highpass2::Reference,
    &Filter::Butterworth4,
    &Filter::Bessel4,
    &Filter::Sinc2,
];

/// Filters with one parameter.
enum Filter {
    DutHighpass,
    ReferenceHighpass,
    DutLowpass1,
    ReferenceLowpass1,
    AveragingWindow,
    Butterworth4,
    Bessel4,
    Sinc2,
}

/// Second-order high-pass: a mass on a spring, or two coupled stages.
enum Highpass2 {
    Dut,
    Reference,
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
            Self::Butterworth4 => {
                let q = frequency_hz / p;
                pair(q, BUTTERWORTH_4[0]) * pair(q, BUTTERWORTH_4[1])
            }
            Self::Bessel4 => {
                // The reverse Bessel polynomial of fourth order.
                let s = Complex64::new(0.0, BESSEL_4 * frequency_hz / p);
                105.0 / (105.0 + s * (105.0 + s * (45.0 + s * (10.0 + s))))
            }
            Self::Sinc2 => {
                let angle = PI * frequency_hz * p;
                Complex64::from_polar((angle.sin() / angle).powi(2), -2.0 * angle)
            }
        }
    }
}

/// Middle coefficients of the two factors of Butterworth's polynomial of fourth order: 2 cos 22.5 degrees,
/// 2 cos 67.5 degrees.
const BUTTERWORTH_4: [f64; 2] = [1.847_759_065, 0.765_366_865];
/// Frequency, over its reciprocal delay, at which Bessel's filter of fourth order has lost 3 dB.
const BESSEL_4: f64 = 2.113_917_675;

/// 1/(1 + b s + s^2) at s = j q.
fn pair(q: f64, b: f64) -> Complex64 {
    Complex64::new(1.0 - q * q, b * q).inv()
}

/// Corners above `lowest`, in equal ratios: a few within the band, where the corner shows itself, and
/// many above it, where only its beginning does.
fn corners_above(facts: &Facts, highest: f64, count: usize) -> Vec<f64> {
    let mut corners = ratios(2.0 * facts.lowest_hz, 0.1 * facts.highest_hz, WITHIN);
    corners.retain(|c| *c <= 0.1 * facts.highest_hz);
    corners.extend(ratios(0.2 * facts.highest_hz, highest, count));
    corners
}

/// Corners below the band, and a few within it.
fn corners_below(facts: &Facts, lowest: f64, count: usize) -> Vec<f64> {
    let mut corners = ratios(lowest, 4.0 * facts.lowest_hz, count);
    corners.extend(ratios(
        8.0 * facts.lowest_hz,
        0.5 * facts.highest_hz,
        WITHIN,
    ));
    corners.retain(|c| *c < facts.highest_hz);
    corners
}

/// Starts within the band.
const WITHIN: usize = 5;

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
            Self::Butterworth4 | Self::Bessel4 => &conditioning::DUT_LOWPASS_4,
            Self::Sinc2 => &conditioning::SINC2_FILTER,
        }
    }
    /// Of which kind a filter is, is a variant, not fitted.
    fn parameters(&self) -> &'static [Parameter] {
        &self.entry().parameters[..1]
    }
    /// Elsewhere these are a delay.
    fn within(&self, facts: &Facts) -> Option<[f64; 2]> {
        match self {
            Self::Butterworth4 => Some([0.0, thresholds::FARTHEST_BUTTERWORTH * facts.highest_hz]),
            Self::Bessel4 => Some([0.0, thresholds::FARTHEST_BESSEL * facts.highest_hz]),
            Self::Sinc2 => Some([
                thresholds::SHORTEST_AVERAGING / facts.highest_hz,
                f64::INFINITY,
            ]),
            _ => None,
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
            // Known by their delay beside the loss: by the loss alone they are filters of second order.
            Self::Butterworth4 | Self::Bessel4 | Self::Sinc2 => facts.ratio_phase,
            _ => ratio,
        }
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let values = match self {
            Self::DutHighpass | Self::ReferenceHighpass => {
                corners_below(facts, 0.0005 * facts.lowest_hz, 20)
            }
            Self::DutLowpass1 | Self::ReferenceLowpass1 => {
                corners_above(facts, 5000.0 * facts.highest_hz, 22)
            }
            Self::Butterworth4 => corners_above(
                facts,
                thresholds::FARTHEST_BUTTERWORTH * facts.highest_hz,
                10,
            ),
            Self::Bessel4 => {
                corners_above(facts, thresholds::FARTHEST_BESSEL * facts.highest_hz, 12)
            }
            Self::Sinc2 => ratios(
                thresholds::SHORTEST_AVERAGING / facts.highest_hz,
                1.5 / facts.highest_hz,
                14,
            ),
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
        corners_above(facts, 2000.0 * facts.highest_hz, 22)
            .into_iter()
            .flat_map(|c| [0.55, 0.75, 0.95].map(|q| Start::shape(vec![c, q])))
            .collect()
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        transfer.dut *= second_order(frequency_hz, p[0], p[1]);
    }
}

impl Effect for Highpass2 {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        match self {
            Self::Dut => &conditioning::DUT_HIGHPASS_2,
            Self::Reference => &conditioning::REFERENCE_HIGHPASS_2,
        }
    }
    fn applies(&self, facts: &Facts) -> bool {
        let ratio = facts.ratio || facts.ratio_phase;
        ratio || (facts.drive && matches!(self, Self::Reference))
    }
    /// Without phase both rise as 1/f^2 above their corner.
    fn alike(&self, facts: &Facts) -> Option<&'static Entry> {
        let first = match self {
            Self::Dut => &conditioning::DUT_HIGHPASS,
            Self::Reference => &conditioning::REFERENCE_HIGHPASS,
        };
        (!facts.ratio_phase && !facts.drive).then_some(first)
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        corners_below(facts, 0.005 * facts.lowest_hz, 14)
            .into_iter()
            .flat_map(|c| [0.6, 1.0, 3.0].map(|q| Start::shape(vec![c, q])))
            .collect()
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let q = frequency_hz / p[0];
        let response = -q * q * second_order(frequency_hz, p[0], p[1]);
        match self {
            Self::Dut => transfer.dut *= response,
            Self::Reference => transfer.reference *= response,
        }
    }
}
