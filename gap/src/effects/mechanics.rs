//! Linear mechanics of the exciter that differ from the nominal ones.

use super::about::{About, Parameter, Stage};
use super::start::Start;
use super::{Effect, Facts};
use crate::model::chain::Chain;
use crate::model::row::Row;

/// A linear term that the nominal rig states wrongly.
pub(super) enum Mechanics {
    Damping,
    BackEmf,
    PayloadMass,
}

static DAMPING: About = About {
    id: "mechanical_damping",
    stage: Stage::Exciter,
    formula: "added force dc x velocity: 2 zeta q near f0",
    parameters: &[Parameter::linear(
        "added_damping_ns_per_m",
        "N s/m",
        -1e3,
        1e4,
    )],
    columns: &["frequency_hz", "ref_v", "coil_v", "coil_a"],
    confused_with: &["back_emf", "coulomb_friction"],
    separate_by: "coil current near the suspension resonance",
};
static BACK_EMF: About = About {
    id: "back_emf",
    stage: Stage::Exciter,
    formula: "induced voltage (1 + beta) Bl x velocity: damping Bl^2/Z differs from nominal",
    parameters: &[Parameter::linear("beta", "1", -0.95, 10.0)],
    columns: &["frequency_hz", "ref_v", "coil_v", "coil_a"],
    confused_with: &["mechanical_damping"],
    separate_by: "coil current near the suspension resonance",
};
static PAYLOAD: About = About {
    id: "payload_mass",
    stage: Stage::Exciter,
    formula: "M -> M + dm in d: f0 and high frequencies",
    parameters: &[Parameter::linear("added_mass_kg", "kg", -10.0, 100.0)],
    columns: &["frequency_hz", "ref_v", "coil_v"],
    confused_with: &["reference_drift"],
    separate_by: "a weighed payload; coil current near the suspension resonance",
};

impl Effect for Mechanics {
    fn about(&self) -> &'static About {
        match self {
            Self::Damping => &DAMPING,
            Self::BackEmf => &BACK_EMF,
            Self::PayloadMass => &PAYLOAD,
        }
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.drive || facts.current
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let unit = match self {
            Self::Damping => facts.damping_ns_per_m,
            Self::BackEmf => 1.0,
            Self::PayloadMass => facts.mass_kg,
        };
        let sizes: &[f64] = if matches!(self, Self::PayloadMass) {
            &[-0.3, -0.01, 0.01, 0.3]
        } else {
            &[-0.5, -0.01, 0.01, 1.0, 4.0]
        };
        sizes
            .iter()
            .map(|s| Start::positive(vec![s * unit], 0))
            .collect()
    }
    fn chain(&self, p: &[f64], _row: &Row, chain: &mut Chain) {
        match self {
            Self::Damping => chain.damping_ns_per_m += p[0],
            Self::BackEmf => chain.emf *= 1.0 + p[0],
            Self::PayloadMass => chain.mass_kg += p[0],
        }
    }
}
