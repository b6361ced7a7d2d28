//! The coil as an electric impedance.

use super::effect::{Effect, Explanations};
use super::facts::Facts;
use super::start::{Start, ratios};
use crate::model::chain::Chain;
use crate::model::row::Row;
use calib_effects::{Entry, exciter};

pub(super) static EXPLANATIONS: Explanations =
    &[&LossyInductance, &CoilHeating, &ShortedInductance];

/// Temperature coefficient of the resistance of copper, in 1/K.
const COPPER_PER_K: f64 = 0.0039;

/// Eddy currents and skin effect: the inductance falls and becomes lossy.
struct LossyInductance;
/// A coil that warms up under load.
struct CoilHeating;
/// A share of the inductance with a resistance across it.
struct ShortedInductance;

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

impl Effect for ShortedInductance {
    fn entry(&self) -> &'static Entry {
        &exciter::SHORTED_INDUCTANCE
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.drive || facts.current
    }
    /// Below these corners the inductance is another one, above them it is the stated one.
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        ratios(0.02 * facts.highest_hz, 2.0 * facts.highest_hz, 4)
            .into_iter()
            .map(|corner_hz| Start::positive(vec![0.3, corner_hz], 0))
            .collect()
    }
    fn chain(&self, p: &[f64], _row: &Row, chain: &mut Chain) {
        chain.shorted = [p[0], p[1]];
    }
}
