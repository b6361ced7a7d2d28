//! Nonlinear moving parts of the exciter.

use super::about::{About, Parameter, Stage};
use super::mount::FREE_FALL_MS2;
use super::start::{Start, ratios};
use super::{Effect, Facts};
use crate::model::chain::Chain;
use crate::model::row::Row;

/// What bends between coil force and motion.
pub(super) enum Suspension {
    Cubic,
    Asymmetry,
    Droop,
    Friction,
}

const COLUMNS: &[&str] = &[
    "acceleration_ms2",
    "ref_v",
    "coil_v",
    "ref_h3",
    "dut_h3",
    "coil_a",
];
static CUBIC: About = About {
    id: "suspension_cubic",
    stage: Stage::Exciter,
    formula: "restoring force k1 x + k3 x^3: d near f0, H3 as X^2 in both channels",
    parameters: &[Parameter::linear("k3_n_per_m3", "N/m3", -1e14, 1e14)],
    columns: COLUMNS,
    confused_with: &["force_factor_droop", "coulomb_friction"],
    separate_by: "large travel at low frequency, with coil current and harmonics",
};
static ASYMMETRY: About = About {
    id: "suspension_asymmetry",
    stage: Stage::Exciter,
    formula: "restoring force k1 x + k2 x^2 about the unloaded position, sag -M g cos(tilt)/k1: H2, f0 moves with tilt and payload",
    parameters: &[Parameter::linear("k2_n_per_m2", "N/m2", -1e10, 1e10)],
    columns: &[
        "acceleration_ms2",
        "tilt_deg",
        "payload_kg",
        "ref_v",
        "coil_v",
        "ref_h2",
        "dut_h2",
    ],
    confused_with: &["amplifier_even_order"],
    separate_by: "another tilt and payload near the suspension resonance, with harmonics",
};
static DROOP: About = About {
    id: "force_factor_droop",
    stage: Stage::Exciter,
    formula: "Bl(x) = Bl0 (1 - b2 x^2): force and back-EMF fall with travel",
    parameters: &[Parameter::linear("b2_per_m2", "1/m2", 0.0, 1e9)],
    columns: COLUMNS,
    confused_with: &["suspension_cubic"],
    separate_by: "large travel at low frequency, with coil current",
};
static FRICTION: About = About {
    id: "coulomb_friction",
    stage: Stage::Exciter,
    formula: "force Fc against the motion, 4 Fc/(pi F): odd harmonics in both channels, as 1/A",
    parameters: &[Parameter::linear("friction_n", "N", 0.0, 100.0)],
    columns: COLUMNS,
    confused_with: &["mechanical_damping", "suspension_cubic"],
    separate_by: "the smallest levels at low frequency, with harmonics",
};

impl Effect for Suspension {
    fn about(&self) -> &'static About {
        match self {
            Self::Cubic => &CUBIC,
            Self::Asymmetry => &ASYMMETRY,
            Self::Droop => &DROOP,
            Self::Friction => &FRICTION,
        }
    }
    fn bends(&self) -> bool {
        true
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.exciter_known
            && facts.level_known
            && (facts.drive || facts.ref_harmonics || facts.dut_harmonics)
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let (travel, stiffness) = (facts.largest_travel_m, facts.stiffness_n_per_m);
        let force = stiffness * travel;
        let sizes = ratios(1e-3, 0.3, 4);
        match self {
            Self::Cubic => both_signs(&sizes, stiffness / (travel * travel)),
            Self::Asymmetry => both_signs(&sizes, stiffness / travel),
            Self::Droop => sizes
                .iter()
                .map(|s| Start::positive(vec![s / (travel * travel)], 0))
                .collect(),
            Self::Friction => ratios(1e-5, 0.1, 5)
                .iter()
                .map(|s| Start::positive(vec![s * force], 0))
                .collect(),
        }
    }
    fn chain(&self, p: &[f64], row: &Row, chain: &mut Chain) {
        match self {
            Self::Cubic => chain.bend.cubic_n_per_m3 += p[0],
            Self::Asymmetry => {
                chain.bend.quadratic_n_per_m2 += p[0];
                chain.bend.gravity_ms2 = FREE_FALL_MS2 * row.vertical;
            }
            Self::Droop => chain.bend.droop_per_m2 += p[0],
            Self::Friction => chain.bend.friction_n += p[0],
        }
    }
}

fn both_signs(sizes: &[f64], unit: f64) -> Vec<Start> {
    sizes
        .iter()
        .flat_map(|s| [*s, -*s])
        .map(|s| Start::positive(vec![s * unit], 0))
        .collect()
}
