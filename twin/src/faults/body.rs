//! Faults of what moves.

use crate::model::Model;

/// Remainder of the force factor of an open coil: no current, so neither force nor braking, and
/// yet a network of the same shape.
const OPEN_COIL: f64 = 1e-9;

/// A fault of the moving element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BodyFault {
    /// The payload leaves the table.
    FallsOff {
        /// When, s.
        at_s: f64,
    },
    /// The coil carries no current any more.
    CoilOpens {
        /// When, s.
        at_s: f64,
    },
    /// The armature strikes a stop.
    Stop {
        /// Travel at which it does, m.
        travel_m: f64,
        /// Part of the velocity with which it comes back.
        restitution: f64,
    },
}

impl BodyFault {
    /// When the body becomes another one, s.
    pub(crate) fn at_s(&self) -> Option<f64> {
        match *self {
            Self::FallsOff { at_s } | Self::CoilOpens { at_s } => Some(at_s),
            Self::Stop { .. } => None,
        }
    }

    /// Makes `model` that other body.
    pub(crate) fn change(&self, model: &mut Model, payload_kg: f64) {
        match self {
            Self::FallsOff { .. } => model.coil.mass_kg -= payload_kg,
            Self::CoilOpens { .. } => model.coil.force_factor_n_per_a *= OPEN_COIL,
            Self::Stop { .. } => {}
        }
    }
}
