//! Linear parts of the exciter: mechanics, coil, armature, nominal values that are off.

use crate::model::chain::{Chain, Transfer};
use crate::model::effect::{Effect, Explanations, Start, ratios};
use crate::model::exciter::Body;
use crate::model::facts::Facts;
use crate::model::row::Row;
use calib_effects::{Entry, exciter};
use num_complex::Complex64;

pub(super) static EXPLANATIONS: Explanations = &[
    &Mechanics::Damping,
    &Mechanics::BackEmf,
    &Mechanics::PayloadMass,
    &NominalValue::Stiffness,
    &NominalValue::ForceFactor,
    &NominalValue::Resistance,
    &NominalValue::Inductance,
    &BodyMode,
    &Creep,
    &LossyInductance,
    &CoilHeating,
    &ShortedInductance,
    &ArmatureMode,
];

/// A linear term that the nominal rig states wrongly.
enum Mechanics {
    Damping,
    BackEmf,
    PayloadMass,
}

impl Effect for Mechanics {
    fn entry(&self) -> &'static Entry {
        match self {
            Self::Damping => &exciter::MECHANICAL_DAMPING,
            Self::BackEmf => &exciter::BACK_EMF,
            Self::PayloadMass => &exciter::PAYLOAD_MASS,
        }
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.drive || facts.current
    }
    /// Bl^2/R and the damping of the suspension only ever act as a sum on the drive.
    fn alike(&self, facts: &Facts) -> Option<&'static Entry> {
        let summed = facts.drive && !facts.current;
        (summed && matches!(self, Self::Damping)).then_some(&exciter::BACK_EMF)
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

/// A nominal value of the exciter that is wrong by more than its uncertainty allows.
enum NominalValue {
    Stiffness,
    ForceFactor,
    Resistance,
    Inductance,
}

impl Effect for NominalValue {
    fn entry(&self) -> &'static Entry {
        match self {
            Self::Stiffness => &exciter::NOMINAL_STIFFNESS,
            Self::ForceFactor => &exciter::NOMINAL_FORCE_FACTOR,
            Self::Resistance => &exciter::NOMINAL_RESISTANCE,
            Self::Inductance => &exciter::NOMINAL_INDUCTANCE,
        }
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.exciter_known && (facts.drive || facts.current)
    }
    fn starts(&self, _facts: &Facts) -> Vec<Start> {
        [-0.3, -0.01, 0.01, 0.3, 1.0]
            .map(|offset| Start::positive(vec![offset], 0))
            .into()
    }
    fn chain(&self, p: &[f64], _row: &Row, chain: &mut Chain) {
        let value = match self {
            Self::Stiffness => &mut chain.stiffness,
            Self::ForceFactor => &mut chain.force_factor,
            Self::Resistance => &mut chain.resistance,
            Self::Inductance => &mut chain.inductance,
        };
        *value *= 1.0 + p[0];
    }
}

/// A suspension that gives way slowly.
struct Creep;

impl Effect for Creep {
    fn entry(&self) -> &'static Entry {
        &exciter::SUSPENSION_CREEP
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.exciter_known && (facts.drive || facts.current)
    }
    fn starts(&self, _facts: &Facts) -> Vec<Start> {
        [0.01, 0.1]
            .map(|share| Start::positive(vec![share], 0))
            .into()
    }
    fn chain(&self, p: &[f64], _row: &Row, chain: &mut Chain) {
        chain.creep_per_decade += p[0];
    }
}

/// Mass of the body and quality of its feet where a search starts.
const USUAL_BODY_KG: f64 = 10.0;
const USUAL_QUALITY: f64 = 4.0;
/// Resonances of feet that are tried, in Hz.
const FEET_HZ: [f64; 2] = [1.5, 300.0];

/// A body that gives way as it drives the table.
struct BodyMode;

impl Effect for BodyMode {
    fn entry(&self) -> &'static Entry {
        &exciter::BODY_MODE
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.exciter_known && (facts.drive || facts.current)
    }
    /// Closer to one another than the resonance is wide at its half.
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let [lowest_hz, highest_hz] = FEET_HZ;
        ratios(lowest_hz.max(0.3 * facts.lowest_hz), highest_hz, 13)
            .into_iter()
            .map(|hz| Start::positive(vec![USUAL_BODY_KG, hz, USUAL_QUALITY], 0))
            .collect()
    }
    /// It gives way as its mass is less.
    fn combine(&self, start: &Start, amplitudes: &[f64]) -> Vec<f64> {
        let mut parameters = start.members[0].clone();
        parameters[0] /= amplitudes[0].max(1e-3);
        parameters
    }
    fn chain(&self, p: &[f64], _row: &Row, chain: &mut Chain) {
        chain.body = Some(Body {
            mass_kg: p[0],
            isolator_hz: p[1],
            quality: p[2],
        });
    }
}

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

/// Axial mode of the moving element.
struct ArmatureMode;

impl Effect for ArmatureMode {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &exciter::ARMATURE_MODE
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.drive
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let mut starts = Vec::new();
        for mode_hz in ratios(1500.0, 25_000.0, 30) {
            for zeta in [0.008, 0.03, 0.1] {
                starts.push(Start::signed(vec![0.01, mode_hz, zeta], 0));
            }
        }
        starts.retain(|s| s.members[0][1] < 4.0 * facts.highest_hz);
        starts
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let q = frequency_hz / p[1];
        transfer.table *= 1.0 + p[0] * q * q / Complex64::new(1.0 - q * q, 2.0 * p[2] * q);
    }
}
