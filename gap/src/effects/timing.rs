//! Delays, clocks and coupling between the channels.

use crate::model::chain::Transfer;
use crate::model::effect::{Effect, Explanations, Start};
use crate::model::facts::Facts;
use crate::model::row::Row;
use calib_effects::{Entry, Parameter, conditioning, digitiser};
use num_complex::Complex64;
use std::f64::consts::TAU;

pub(super) static EXPLANATIONS: Explanations = &[
    &Crosstalk::Capacitive,
    &Crosstalk::Resistive,
    &ChannelSkew,
    &ClockOffset,
];

/// Coupling into the channel of the device under test.
enum Crosstalk {
    Capacitive,
    Resistive,
}
/// Fixed delay between the channels.
struct ChannelSkew;
/// Clocks of different rate: the delay grows.
struct ClockOffset;

impl Effect for Crosstalk {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &conditioning::CROSSTALK
    }
    fn parameters(&self) -> &'static [Parameter] {
        let parameters = self.entry().parameters;
        match self {
            Self::Capacitive => &parameters[..1],
            Self::Resistive => &parameters[2..],
        }
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.ratio_phase || (facts.ratio && matches!(self, Self::Capacitive))
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        match self {
            Self::Capacitive => [0.005, 0.05, 0.3]
                .into_iter()
                .flat_map(|s| [s, -s])
                .map(|s| Start::positive(vec![s / facts.highest_hz], 0))
                .collect(),
            Self::Resistive => vec![Start::signed(vec![0.002], 0)],
        }
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let quadrature = if matches!(self, Self::Capacitive) {
            p[0] * frequency_hz
        } else {
            p[0]
        };
        transfer.dut *= Complex64::new(1.0, quadrature);
    }
}

impl Effect for ChannelSkew {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &digitiser::CHANNEL_SKEW
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.ratio_phase
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        vec![Start::signed(vec![0.002 / facts.highest_hz], 0)]
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        transfer.dut *= Complex64::from_polar(1.0, -TAU * frequency_hz * p[0]);
    }
}

impl Effect for ClockOffset {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &digitiser::CLOCK_OFFSET
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.ratio_phase && facts.longest_s > 0.0
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        vec![Start::signed(
            vec![0.002 / (facts.highest_hz * facts.longest_s)],
            0,
        )]
    }
    fn transfer(&self, p: &[f64], row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        transfer.dut *= Complex64::from_polar(1.0, -TAU * frequency_hz * p[0] * row.time_s);
    }
}
