//! Resonances of the transducers and of the contact between device and table.

use super::about::{About, Parameter, Stage};
use super::start::{Start, ratios};
use super::{Effect, Facts};
use crate::model::chain::Transfer;
use crate::model::row::Row;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Payload taken where the data state none, in kg.
const USUAL_PAYLOAD_KG: f64 = 0.04;

/// One degree of freedom above the frequencies of use.
pub(super) enum Resonance {
    Dut,
    Reference,
    Mount,
}

/// 1 / (1 - (f/f0)^2 + j f/(Q f0)).
pub(super) fn second_order(frequency_hz: f64, natural_hz: f64, quality: f64) -> Complex64 {
    let q = frequency_hz / natural_hz;
    Complex64::new(1.0 - q * q, q / quality).inv()
}

static DUT: About = About {
    id: "dut_resonance",
    stage: Stage::Dut,
    formula: "r = 1/(1 - (f/fr)^2 + j f/(Q fr))",
    parameters: &[
        Parameter::log("resonance_hz", "Hz", 2000.0, 120_000.0),
        Parameter::log("quality", "1", 1.5, 1000.0),
    ],
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["mount_compliance", "dut_lowpass_2", "averaging_window"],
    separate_by: "other payloads; higher frequencies with phase",
};
static REFERENCE: About = About {
    id: "reference_resonance",
    stage: Stage::Reference,
    formula: "1/r = 1/(1 - (f/fr)^2 + j f/(Q fr)), the same in d",
    parameters: DUT.parameters,
    columns: &["frequency_hz", "ratio", "dut_deg", "ref_v", "coil_v"],
    confused_with: &["dut_lowpass_2", "relative_motion", "armature_mode"],
    separate_by: "coil voltage beside the ratio; higher frequencies with phase",
};
static MOUNT: About = About {
    id: "mount_compliance",
    stage: Stage::Mount,
    formula: "r = 1/(1 - (f/fm)^2 + j f/(Q fm)), fm = sqrt(km/payload)/2pi",
    parameters: &[
        Parameter::log("stiffness_n_per_m", "N/m", 1e5, 1e12),
        Parameter::log("quality", "1", 1.5, 1000.0),
    ],
    columns: &["frequency_hz", "payload_kg", "ratio", "dut_deg"],
    confused_with: &["dut_resonance", "relative_motion"],
    separate_by: "a second payload at the highest frequencies",
};

impl Resonance {
    fn payload(row: &Row, stated: bool) -> f64 {
        if stated {
            row.payload_kg
        } else {
            USUAL_PAYLOAD_KG
        }
    }
}

impl Effect for Resonance {
    fn is_linear(&self) -> bool {
        true
    }
    fn about(&self) -> &'static About {
        match self {
            Self::Dut => &DUT,
            Self::Reference => &REFERENCE,
            Self::Mount => &MOUNT,
        }
    }

    fn applies(&self, facts: &Facts) -> bool {
        match self {
            Self::Dut => facts.ratio || facts.ratio_phase,
            Self::Reference => facts.ratio || facts.ratio_phase || facts.drive,
            Self::Mount => {
                (facts.ratio || facts.ratio_phase)
                    && (facts.largest_payload_kg > 0.0 || !facts.payload_stated)
            }
        }
    }

    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let frequencies = ratios(
            0.3 * facts.highest_hz,
            (20.0 * facts.highest_hz).min(110_000.0),
            26,
        );
        let payload = if facts.largest_payload_kg > 0.0 {
            facts.largest_payload_kg
        } else {
            USUAL_PAYLOAD_KG
        };
        let mut starts = Vec::new();
        for frequency_hz in frequencies {
            for quality in [3.0, 12.0, 50.0] {
                let first = match self {
                    Self::Mount => (TAU * frequency_hz).powi(2) * payload,
                    _ => frequency_hz,
                };
                starts.push(Start::shape(vec![first, quality]));
            }
        }
        starts
    }

    fn transfer(&self, p: &[f64], row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        match self {
            Self::Dut => transfer.dut *= second_order(frequency_hz, p[0], p[1]),
            Self::Reference => transfer.reference *= second_order(frequency_hz, p[0], p[1]),
            Self::Mount => {
                let payload = Self::payload(row, row.payload_stated);
                if payload > 0.0 {
                    transfer.dut *= second_order(frequency_hz, (p[0] / payload).sqrt() / TAU, p[1]);
                }
            }
        }
    }
}
