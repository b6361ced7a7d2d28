//! The coil as an electric impedance.

use super::about::{About, Parameter, Stage};
use super::start::{Start, ratios};
use super::{Effect, Facts};
use crate::model::chain::Chain;
use crate::model::row::Row;

/// Temperature coefficient of the resistance of copper, in 1/K.
const COPPER_PER_K: f64 = 0.0039;

/// Eddy currents and skin effect: the inductance falls and becomes lossy.
pub(super) struct LossyInductance;
/// A coil that warms up under load.
pub(super) struct CoilHeating;

static LOSSY: About = About {
    id: "lossy_inductance",
    stage: Stage::Exciter,
    formula: "Z = R + j^n w0 L (w/w0)^n, w0 = 2 pi 1 kHz, n 0.5..0.9 (1 = ideal)",
    parameters: &[Parameter::linear("exponent", "1", 0.3, 1.0)],
    columns: &["frequency_hz", "coil_v", "coil_a", "coil_a_deg", "ref_v"],
    confused_with: &["armature_mode"],
    separate_by: "coil current at the highest frequencies",
};
static HEATING: About = About {
    id: "coil_heating",
    stage: Stage::Exciter,
    formula: "R (1 + 0.0039 dT (1 - exp(-t/tau)))",
    parameters: &[
        Parameter::linear("rise_k", "K", 0.0, 300.0),
        Parameter::log("time_constant_s", "s", 1.0, 1e5),
    ],
    columns: &["time_s", "coil_v", "coil_a", "ref_v"],
    confused_with: &["amplifier_gain_drift", "reference_drift"],
    separate_by: "coil current over time",
};

impl Effect for LossyInductance {
    fn about(&self) -> &'static About {
        &LOSSY
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.drive || facts.current
    }
    fn starts(&self, _facts: &Facts) -> Vec<Start> {
        [0.995, 0.95, 0.85, 0.7, 0.55]
            .map(|n| Start::shape(vec![n]))
            .into()
    }
    fn chain(&self, p: &[f64], _row: &Row, chain: &mut Chain) {
        chain.inductance_exponent = p[0];
    }
}

impl Effect for CoilHeating {
    fn about(&self) -> &'static About {
        &HEATING
    }
    fn applies(&self, facts: &Facts) -> bool {
        (facts.drive || facts.current) && facts.longest_s > 0.0
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        ratios(0.01 * facts.longest_s, 2.0 * facts.longest_s, 8)
            .into_iter()
            .flat_map(|tau| [1.0, 30.0].map(|rise| Start::positive(vec![rise, tau], 0)))
            .collect()
    }
    fn chain(&self, p: &[f64], row: &Row, chain: &mut Chain) {
        chain.resistance *= 1.0 + COPPER_PER_K * p[0] * (1.0 - (-row.time_s / p[1]).exp());
    }
}
