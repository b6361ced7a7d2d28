//! Parameters of the electrodynamic exciter.

use serde::{Deserialize, Serialize};

use super::range::Range;
use crate::model::CoilModel;

/// A voltage-driven moving coil carrying table, reference and payload on a suspension.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exciter {
    /// Armature without payload, kg.
    pub moving_mass_kg: f64,
    /// Device under test and adapters, kg.
    pub payload_kg: f64,
    /// Suspension stiffness, N/m.
    pub stiffness_n_per_m: f64,
    /// Viscous damping of the suspension, N s/m.
    pub damping_ns_per_m: f64,
    /// Force factor Bl, N/A.
    pub force_factor_n_per_a: f64,
    /// Coil resistance, ohm.
    pub coil_resistance_ohm: f64,
    /// Coil inductance, H.
    pub coil_inductance_h: f64,
}

impl Exciter {
    /// Everything that moves, kg.
    pub fn mass_kg(&self) -> f64 {
        self.moving_mass_kg + self.payload_kg
    }

    /// The linear exciter these values describe.
    pub fn model(&self) -> CoilModel {
        CoilModel {
            mass_kg: self.mass_kg(),
            stiffness_n_per_m: self.stiffness_n_per_m,
            damping_ns_per_m: self.damping_ns_per_m,
            force_factor_n_per_a: self.force_factor_n_per_a,
            resistance_ohm: self.coil_resistance_ohm,
            inductance_h: self.coil_inductance_h,
            ..CoilModel::LINEAR
        }
    }

    pub(super) fn ranges(&self) -> Vec<Range> {
        let range = |name: &str, value, lowest, highest| {
            Range::new(format!("exciter.{name}"), value, lowest, highest)
        };
        vec![
            range("moving_mass_kg", self.moving_mass_kg, 1e-4, 1e3),
            range("payload_kg", self.payload_kg, 0.0, 1e3),
            range("stiffness_n_per_m", self.stiffness_n_per_m, 1.0, 1e9),
            range("damping_ns_per_m", self.damping_ns_per_m, 0.0, 1e6),
            range("force_factor_n_per_a", self.force_factor_n_per_a, 1e-3, 1e4),
            range("coil_resistance_ohm", self.coil_resistance_ohm, 1e-3, 1e4),
            range("coil_inductance_h", self.coil_inductance_h, 1e-7, 10.0),
        ]
    }
}
