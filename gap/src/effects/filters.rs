//! Filters of the conditioning.

use super::about::{About, Parameter, Stage};
use super::resonance::second_order;
use super::start::{Start, ratios};
use super::{Effect, Facts};
use crate::model::chain::Transfer;
use crate::model::row::Row;
use num_complex::Complex64;
use std::f64::consts::PI;

/// Filters with one parameter.
pub(super) enum Filter {
    DutHighpass,
    ReferenceHighpass,
    DutLowpass1,
    AveragingWindow,
}

/// Second-order low-pass without a resonance peak to speak of.
pub(super) struct Lowpass2;

static DUT_HIGHPASS: About = About {
    id: "dut_highpass",
    stage: Stage::Conditioning,
    formula: "r = j f/fc / (1 + j f/fc)",
    parameters: &[Parameter::log("corner_hz", "Hz", 1e-5, 1000.0)],
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["gravity_tilt", "base_strain", "dut_frequency_slope"],
    separate_by: "phase at the lowest frequencies",
};
static REFERENCE_HIGHPASS: About = About {
    id: "reference_highpass",
    stage: Stage::Conditioning,
    formula: "1/r = j f/fc / (1 + j f/fc), the same in d",
    parameters: DUT_HIGHPASS.parameters,
    columns: &["frequency_hz", "ratio", "dut_deg", "ref_v", "coil_v"],
    confused_with: &["gravity_tilt", "dut_frequency_slope", "base_strain"],
    separate_by: "phase at the lowest frequencies; coil voltage beside the ratio",
};
static LOWPASS_1: About = About {
    id: "dut_lowpass_1",
    stage: Stage::Conditioning,
    formula: "r = 1/(1 + j f/fc)",
    parameters: &[Parameter::log("corner_hz", "Hz", 100.0, 1e9)],
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &[
        "averaging_window",
        "dut_lowpass_2",
        "channel_skew",
        "crosstalk",
    ],
    separate_by: "higher frequencies, magnitude and phase",
};
static WINDOW: About = About {
    id: "averaging_window",
    stage: Stage::Conditioning,
    formula: "r = sinc(f T) exp(-j pi f T)",
    parameters: &[Parameter::log("duration_s", "s", 1e-9, 0.1)],
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["dut_lowpass_1", "dut_lowpass_2", "channel_skew"],
    separate_by: "higher frequencies, up to the zero at 1/T",
};
static LOWPASS_2: About = About {
    id: "dut_lowpass_2",
    stage: Stage::Conditioning,
    formula: "r = 1/(1 - (f/f0)^2 + j f/(Q f0)), Q 0.5..1",
    parameters: &[
        Parameter::log("corner_hz", "Hz", 100.0, 1e7),
        Parameter::log("quality", "1", 0.5, 1.1),
    ],
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &[
        "dut_lowpass_1",
        "averaging_window",
        "dut_resonance",
        "channel_skew",
    ],
    separate_by: "higher frequencies, magnitude and phase",
};

impl Filter {
    fn response(&self, p: f64, frequency_hz: f64) -> Complex64 {
        match self {
            Self::DutHighpass | Self::ReferenceHighpass => {
                let q = Complex64::new(0.0, frequency_hz / p);
                q / (1.0 + q)
            }
            Self::DutLowpass1 => Complex64::new(1.0, frequency_hz / p).inv(),
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
    fn about(&self) -> &'static About {
        match self {
            Self::DutHighpass => &DUT_HIGHPASS,
            Self::ReferenceHighpass => &REFERENCE_HIGHPASS,
            Self::DutLowpass1 => &LOWPASS_1,
            Self::AveragingWindow => &WINDOW,
        }
    }
    fn applies(&self, facts: &Facts) -> bool {
        let ratio = facts.ratio || facts.ratio_phase;
        ratio || matches!(self, Self::ReferenceHighpass) && facts.drive
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let values = match self {
            Self::DutHighpass | Self::ReferenceHighpass => {
                ratios(0.0005 * facts.lowest_hz, 4.0 * facts.lowest_hz, 20)
            }
            Self::DutLowpass1 => ratios(0.2 * facts.highest_hz, 5000.0 * facts.highest_hz, 22),
            Self::AveragingWindow => ratios(0.0002 / facts.highest_hz, 1.5 / facts.highest_hz, 22),
        };
        values.into_iter().map(|v| Start::shape(vec![v])).collect()
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let response = self.response(p[0], frequency_hz);
        match self {
            Self::ReferenceHighpass => transfer.reference *= response,
            _ => transfer.dut *= response,
        }
    }
}

impl Effect for Lowpass2 {
    fn is_linear(&self) -> bool {
        true
    }
    fn about(&self) -> &'static About {
        &LOWPASS_2
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
