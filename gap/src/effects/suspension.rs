//! Nonlinear moving parts of the exciter.

use super::mount::FREE_FALL_MS2;
use crate::model::chain::Chain;
use crate::model::effect::{Effect, Explanations, Start, ratios};
use crate::model::facts::Facts;
use crate::model::row::Row;
use calib_effects::{Entry, Parameter, exciter};

pub(super) static EXPLANATIONS: Explanations = &[
    &Suspension::Cubic,
    &Suspension::SaggingCubic,
    &Suspension::Asymmetry,
    &Suspension::Droop,
    &Suspension::Friction,
];

/// Nonlinear forces between coil force and motion.
enum Suspension {
    Cubic,
    SaggingCubic,
    Asymmetry,
    Droop,
    Friction,
}

impl Effect for Suspension {
    fn entry(&self) -> &'static Entry {
        match self {
            Self::Cubic | Self::SaggingCubic => &exciter::SUSPENSION_CUBIC,
            Self::Asymmetry => &exciter::SUSPENSION_ASYMMETRY,
            Self::Droop => &exciter::FORCE_FACTOR_DROOP,
            Self::Friction => &exciter::COULOMB_FRICTION,
        }
    }
    /// A levelled spring does not sag.
    fn parameters(&self) -> &'static [Parameter] {
        match self {
            Self::Cubic => &self.entry().parameters[..1],
            _ => self.entry().parameters,
        }
    }
    fn makes_nonlinear(&self) -> bool {
        true
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.exciter_known
            && facts.level_known
            && match self {
                Self::SaggingCubic => facts.ref_harmonics || facts.dut_harmonics,
                _ => facts.drive || facts.ref_harmonics || facts.dut_harmonics,
            }
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let (travel, stiffness) = (facts.largest_travel_m, facts.stiffness_n_per_m);
        let force = stiffness * travel;
        let sizes = ratios(1e-3, 0.3, 4);
        match self {
            Self::Cubic => both_signs(&sizes, stiffness / (travel * travel)),
            // The sag of a level that is not much larger shows as much as the level does.
            Self::SaggingCubic => both_signs(&sizes, stiffness / (travel * travel))
                .into_iter()
                .map(|start| Start::positive(vec![start.members[0][0], 1.0], 0))
                .collect(),
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
    /// One balance per row and start: the smallest start only, of either sign where both occur.
    fn screened(&self, facts: &Facts) -> Vec<Start> {
        let mut starts = self.starts(facts);
        starts.truncate(1);
        if matches!(self, Self::Cubic | Self::SaggingCubic | Self::Asymmetry) {
            starts.iter_mut().for_each(|start| start.signed = true);
        }
        starts
    }
    fn chain(&self, p: &[f64], row: &Row, chain: &mut Chain) {
        match self {
            Self::Cubic => chain.bend.cubic_n_per_m3 += p[0],
            Self::SaggingCubic => {
                chain.bend.cubic_n_per_m3 += p[0];
                chain.bend.carry(p[1] * FREE_FALL_MS2 * row.vertical);
            }
            Self::Asymmetry => {
                chain.bend.quadratic_n_per_m2 += p[0];
                chain.bend.carry(FREE_FALL_MS2 * row.vertical);
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
