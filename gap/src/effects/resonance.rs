//! Resonances of the transducers and of the contact between device and table.

use crate::model::chain::Transfer;
use crate::model::effect::{Effect, Explanations, Start, ratios};
use crate::model::facts::Facts;
use crate::model::row::Row;
use calib_effects::{Entry, dut, mount, reference};
use num_complex::Complex64;
use std::f64::consts::TAU;

pub(super) static EXPLANATIONS: Explanations =
    &[&Resonance::Dut, &Resonance::Reference, &Resonance::Mount];

/// Payload taken where the data state none, in kg.
const USUAL_PAYLOAD_KG: f64 = 0.04;

/// One degree of freedom above the frequencies of use.
enum Resonance {
    Dut,
    Reference,
    Mount,
}

/// 1 / (1 - (f/f0)^2 + j f/(Q f0)).
pub(super) fn second_order(frequency_hz: f64, natural_hz: f64, quality: f64) -> Complex64 {
    let q = frequency_hz / natural_hz;
    Complex64::new(1.0 - q * q, q / quality).inv()
}

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
    fn entry(&self) -> &'static Entry {
        match self {
            Self::Dut => &dut::RESONANCE,
            Self::Reference => &reference::RESONANCE,
            Self::Mount => &mount::COMPLIANCE,
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
