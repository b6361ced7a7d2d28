//! Systematic limits of a comparison of phases.

use schemars::JsonSchema;
use serde::Serialize;

/// Systematic limits of Annex A, degrees.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Limits {
    /// Reference pick-up with amplifier, phi_r.
    pub reference_deg: f64,
    /// Phasemeter, phi_p.
    pub phasemeter_deg: f64,
    /// Amplifier of the pick-up, phi_a.
    pub amplifier_deg: f64,
}
