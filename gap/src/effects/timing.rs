//! Delays, clocks and coupling between the channels.

use super::about::{About, Parameter, Stage};
use super::start::Start;
use super::{Effect, Facts};
use crate::model::chain::Transfer;
use crate::model::row::Row;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Coupling into the channel of the device under test.
pub(super) enum Crosstalk {
    Capacitive,
    Resistive,
}
/// Fixed delay between the channels.
pub(super) struct ChannelSkew;
/// Clocks of different rate: the delay grows.
pub(super) struct ClockOffset;

static CAPACITIVE: About = About {
    id: "crosstalk",
    stage: Stage::Conditioning,
    formula: "r = 1 + j f/fx (capacitive) or a constant complex factor (resistive)",
    parameters: &[Parameter::linear("inverse_fx_s", "s", -1e-3, 1e-3)],
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["channel_skew", "dut_lowpass_1", "averaging_window"],
    separate_by: "magnitude at the highest frequencies; the source of the coupled channel switched off",
};
static RESISTIVE: About = About {
    parameters: &[Parameter::linear("quadrature", "1", -0.5, 0.5)],
    ..CAPACITIVE
};
static SKEW: About = About {
    id: "channel_skew",
    stage: Stage::Digitiser,
    formula: "r = exp(-j 2 pi f tau)",
    parameters: &[Parameter::linear("tau_s", "s", -1e-3, 1e-3)],
    columns: &["frequency_hz", "dut_deg"],
    confused_with: &[
        "crosstalk",
        "dut_lowpass_1",
        "averaging_window",
        "dut_lowpass_2",
    ],
    separate_by: "magnitude at the highest frequencies; both channels on one signal",
};
static CLOCK: About = About {
    id: "clock_offset",
    stage: Stage::Digitiser,
    formula: "r = exp(-j 2 pi f delta t)",
    parameters: &[Parameter::linear("delta", "1", -1e-2, 1e-2)],
    columns: &["frequency_hz", "time_s", "dut_deg"],
    confused_with: &["channel_skew"],
    separate_by: "the highest frequency repeated over time",
};

impl Effect for Crosstalk {
    fn is_linear(&self) -> bool {
        true
    }
    fn about(&self) -> &'static About {
        if matches!(self, Self::Capacitive) {
            &CAPACITIVE
        } else {
            &RESISTIVE
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
    fn about(&self) -> &'static About {
        &SKEW
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
    fn about(&self) -> &'static About {
        &CLOCK
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
