//! Data for the pictures of a report: every difference between measurement and simulation.

use crate::observable::Observable;

/// Differences of a dataset, before and after the best set of effects is added.
#[derive(Debug, Clone)]
pub enum Pictures {
    /// Of sine points.
    Points(Residuals),
    /// Of a record over time.
    Record(Trace),
}

/// Differences at sine points.
#[derive(Debug, Clone)]
pub struct Residuals {
    /// Conditions of each row.
    pub rows: Vec<Conditions>,
    /// One entry per datum.
    pub data: Vec<Datum>,
}

/// Under which conditions a row was measured; NaN where it was not stated.
#[derive(Debug, Clone, Copy)]
pub struct Conditions {
    /// Excitation frequency.
    pub frequency_hz: f64,
    /// Level, r.m.s.
    pub level_ms2: f64,
    /// Index of the run.
    pub run: usize,
    /// Since the first point.
    pub time_s: f64,
    /// Above the reference temperature.
    pub warmer_k: f64,
    /// Rotation of the device under test.
    pub rotation_deg: f64,
    /// Angle between the axis of motion and the vertical.
    pub tilt_deg: f64,
    /// Mass on the armature.
    pub payload_kg: f64,
    /// Took no part in choosing or fitting what the answer scores.
    pub held_out: bool,
}

/// One measured value beside the simulation: relative for responses and noise
/// (logarithms), rad for phases, V for d.c., 1 for harmonics.
#[derive(Debug, Clone, Copy)]
pub struct Datum {
    /// Index of the row.
    pub row: usize,
    /// Measured values.
    pub observable: Observable,
    /// Measured minus nominal simulation.
    pub before: f64,
    /// Measured minus simulation with the best set of effects.
    pub after: f64,
    /// Standard uncertainty of the measured value.
    pub u: f64,
    /// Standard uncertainty with the scatter that the effects leave open.
    pub u_after: f64,
}

/// A held-out stretch of a record.
#[derive(Debug, Clone)]
pub struct Trace {
    /// Sampling interval.
    pub interval_s: f64,
    /// Measured output.
    pub measured: Vec<f64>,
    /// Measured minus linear simulation.
    pub before: Vec<f64>,
    /// Measured minus simulation with the named terms.
    pub after: Vec<f64>,
}
