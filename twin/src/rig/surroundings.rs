//! Conditions under which a rig works.

use serde::{Deserialize, Serialize};

use super::range::Range;
use crate::model::Conditions;

/// Conditions that effects depend on.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Surroundings {
    /// Since the first point of the session, s.
    pub time_s: f64,
    /// Temperature of the transducers above their reference temperature, K.
    pub warmer_k: f64,
    /// Rotation of the device under test about the axis of motion, degrees.
    pub rotation_deg: f64,
    /// Angle between the axis of motion and the vertical, degrees.
    pub tilt_deg: f64,
    /// Frequency of the mains, Hz.
    pub mains_hz: f64,
}

impl Default for Surroundings {
    /// Vertical, at reference temperature, at the start, mains of 50 Hz.
    fn default() -> Self {
        Self {
            time_s: 0.0,
            warmer_k: 0.0,
            rotation_deg: 0.0,
            tilt_deg: 0.0,
            mains_hz: 50.0,
        }
    }
}

impl Surroundings {
    pub(super) fn are_usual(&self) -> bool {
        *self == Self::default()
    }

    /// The conditions of a point with `payload_kg` mounted.
    pub(super) fn conditions(&self, payload_kg: f64) -> Conditions {
        Conditions {
            time_s: self.time_s,
            warmer_k: self.warmer_k,
            rotation_rad: self.rotation_deg.to_radians(),
            tilt_rad: self.tilt_deg.to_radians(),
            payload_kg,
            mains_hz: self.mains_hz,
        }
    }

    pub(super) fn ranges(&self) -> Vec<Range> {
        let range = |name: &str, value, lowest, highest| {
            Range::new(format!("surroundings.{name}"), value, lowest, highest)
        };
        vec![
            range("time_s", self.time_s, 0.0, 1e9),
            range("warmer_k", self.warmer_k, -300.0, 300.0),
            range("rotation_deg", self.rotation_deg, -360.0, 360.0),
            range("tilt_deg", self.tilt_deg, -180.0, 180.0),
            range("mains_hz", self.mains_hz, 10.0, 500.0),
        ]
    }
}
