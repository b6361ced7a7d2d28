//! The moving element beyond a rigid body.

use super::effect::{Effect, Explanations};
use super::facts::Facts;
use super::start::{Start, ratios};
use crate::model::chain::Transfer;
use crate::model::row::Row;
use calib_effects::{Entry, exciter};
use num_complex::Complex64;

pub(super) static EXPLANATIONS: Explanations = &[&ArmatureMode];

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
