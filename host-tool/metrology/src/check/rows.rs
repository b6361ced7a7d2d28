//! Rows of Tables 1 and 2 that a measured point answers.

use calib_core::control::full_output_peak_ms2;
use calib_core::point::PointResult;
use calib_core::requirements::{Attainable, VibrationGeneration};
use calib_core::settings::Example;
use calib_protocol::record::Record;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::SQRT_2;

/// Whether values must stay below or above their limit.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    AtMost,
    AtLeast,
}

impl Side {
    /// With room for the rounding of f32 and of stored points (`protocol`,
    /// `stored_point`: 0.2 % of a diagnostic value).
    pub(super) fn fulfilled(self, value: f64, limit: f64) -> bool {
        match self {
            Self::AtMost => value <= limit * 1.002,
            Self::AtLeast => value >= limit * 0.998,
        }
    }

    /// The excess over the limit in its own direction; NaN counts as worst.
    pub(super) fn excess(self, value: f64, limit: f64) -> f64 {
        match self {
            Self::AtMost => value / limit,
            Self::AtLeast => limit - value,
        }
    }
}

/// A requirement every point is held against.
pub(super) struct Row {
    pub(super) table: &'static str,
    pub(super) parameter: &'static str,
    pub(super) unit: &'static str,
    pub(super) side: Side,
    /// Value and limit at a point; none where the table says nothing.
    pub(super) judge: fn(&Record, Example, &PointResult) -> Option<(f64, f64)>,
}

/// Value and limit of one row at one point.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Held {
    /// Table of ISO 16063-21.
    pub table: &'static str,
    /// Required parameter.
    pub parameter: &'static str,
    /// Unit of value and limit.
    pub unit: &'static str,
    /// Value.
    pub value: f64,
    /// Limit.
    pub limit: f64,
    /// Fulfilled.
    pub passed: bool,
}

pub(super) fn percent(value: f32) -> f64 {
    100.0 * f64::from(value)
}

/// A point of a single sine; broadband runs do not measure distortion, noise and
/// stability apart from the signal (4.4, Note 1).
fn sine(point: &PointResult) -> Option<()> {
    point.coherence.is_none().then_some(())
}

/// Rows of Tables 1 and 2 that a measured point answers.
pub(super) const PER_POINT: [Row; 6] = [
    Row {
        table: "1",
        parameter: "U of the magnitude",
        unit: "%",
        side: Side::AtMost,
        judge: |_, example, p| {
            let limit = Attainable::of(example).accelerometer_at(p.spec.frequency_hz)?;
            Some((percent(p.expanded_uncertainty_rel), percent(limit)))
        },
    },
    Row {
        table: "1",
        parameter: "U of the phase",
        unit: "deg",
        side: Side::AtMost,
        judge: |record, example, p| {
            let u = f64::from(p.expanded_uncertainty_phase_rad).to_degrees();
            Some((u, phase_limit(record, example, p.spec.frequency_hz)))
        },
    },
    Row {
        table: "2",
        parameter: "frequency uncertainty",
        unit: "%",
        side: Side::AtMost,
        judge: |record, example, p| {
            let played = p.tone.frequency_hz(record.head.sample_rate_hz);
            let off = f64::from(played) / f64::from(p.spec.frequency_hz) - 1.0;
            let limit = VibrationGeneration::of(example).frequency_rel;
            Some((100.0 * off.abs(), percent(limit)))
        },
    },
    Row {
        table: "2",
        parameter: "amplitude stability",
        unit: "%",
        side: Side::AtMost,
        judge: |_, example, p| {
            let limit = VibrationGeneration::of(example).amplitude_stability_rel;
            sine(p)?;
            Some((percent(p.amplitude_stability_rel), percent(limit)))
        },
    },
    Row {
        table: "2",
        parameter: "total harmonic distortion",
        unit: "%",
        side: Side::AtMost,
        judge: |_, example, p| {
            let limit = VibrationGeneration::of(example).distortion_at(p.spec.frequency_hz);
            sine(p)?;
            Some((percent(p.distortion_reference_rel), percent(limit)))
        },
    },
    Row {
        table: "2",
        parameter: "hum and noise below full",
        unit: "dB",
        side: Side::AtLeast,
        judge: |record, example, p| {
            let limit = VibrationGeneration::of(example).noise_at(p.spec.frequency_hz);
            sine(p)?;
            Some((below_full_output_db(record, p), f64::from(limit)))
        },
    },
];

/// Hum and noise of the reference below the exciter's full output, dB: below
/// the signal, and the signal below what the limits allow at this frequency.
fn below_full_output_db(record: &Record, point: &PointResult) -> f64 {
    let frequency_hz = point.tone.frequency_hz(record.head.sample_rate_hz);
    let full_peak_ms2 = full_output_peak_ms2(&record.settings.limits, frequency_hz);
    let reached_peak_ms2 = SQRT_2 * f64::from(point.acceleration_rms_ms2);
    let headroom_db = 20.0 * (f64::from(full_peak_ms2) / reached_peak_ms2).log10();
    f64::from(point.signal_to_noise_reference_db) + headroom_db
}

/// Table 1, phase, degrees: tighter where the reference was calibrated.
fn phase_limit(record: &Record, example: Example, frequency_hz: f32) -> f64 {
    let table = &record.settings.reference.points;
    let at_reference = table
        .iter()
        .any(|point| (point.frequency_hz / frequency_hz - 1.0).abs() < 1.0e-3);
    let attainable = Attainable::of(example);
    f64::from(match at_reference {
        true => attainable.phase_reference_deg,
        false => attainable.phase_deg,
    })
}

/// One point against every row that says something about it.
pub(super) fn held(record: &Record, example: Example, point: &PointResult) -> Vec<Held> {
    let rows = PER_POINT.iter().filter_map(|row| {
        let (value, limit) = (row.judge)(record, example, point)?;
        Some(Held {
            table: row.table,
            parameter: row.parameter,
            unit: row.unit,
            value,
            limit,
            passed: row.side.fulfilled(value, limit),
        })
    });
    rows.collect()
}
