//! A measurement in words that whoever takes it understands.

use serde::Serialize;

/// A point that is worth measuring.
#[derive(Debug, Clone, Serialize)]
pub struct Measurement {
    /// Excitation frequency.
    pub frequency_hz: f64,
    /// Level, r.m.s.; null where levels were never stated.
    pub acceleration_ms2: Option<f64>,
    /// Rotation of the device under test.
    pub rotation_deg: f64,
    /// Angle between the axis of motion and the vertical.
    pub tilt_deg: f64,
    /// Mass on the armature.
    pub payload_kg: f64,
    /// Transducer temperature.
    pub temperature_c: f64,
    /// Since the first point.
    pub time_s: f64,
    /// Columns beyond those of the dataset.
    pub extra_columns: Vec<&'static str>,
    /// Observable in which the pair it helps most differs most.
    pub look_at: &'static str,
    /// The pair it helps most.
    pub separates: [Vec<&'static str>; 2],
    /// Separation of that pair after it.
    pub sigma: f64,
}
