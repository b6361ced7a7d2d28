//! The coil as an electric impedance.

use super::effect::{Effect, Explanations};
use super::facts::Facts;
use super::start::{Start, ratios};
use crate::model::chain::Chain;
use crate::model::row::Row;
use calib_effects::{Entry, exciter};

pub(super) static EXPLANATIONS: Explanations = &[&LossyInductance, &CoilHeating];

/// Temperature coefficient of the resistance of copper, in 1/K.
const COPPER_PER_K: f64 = 0.0039;

/// Eddy currents and skin effect: the inductance falls and becomes lossy.
struct LossyInductance;
/// A coil that warms up under load.
struct CoilHeating;

impl Effect for LossyInductance {
    fn entry(&self) -> &'static Entry {
        &exciter::LOSSY_INDUCTANCE
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
    fn entry(&self) -> &'static Entry {
        &exciter::COIL_HEATING
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
