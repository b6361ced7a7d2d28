//! Sensitivity from readings, by each formula of clause 6.
//!
//! | method | readings of a point | formula |
//! |---|---|---|
//! | comparison | both outputs at once | `S2 = S1 X2 / X1` |
//! | consecutive | reference, device, reference (4.5 a) | the same, drift removed |
//! | calibrator | output at a stated amplitude | `S = X / A` |
//!
//! An inverted device is reported as inverted (Annex B); every point also as
//! its deviation from the reference point, in percent, dB and degrees (5.3).
//!
//! # Source
//! ISO 16063-21:2003, 4.5, 5.3, clause 6, Annex B.

mod columns;
mod conversion;
mod file;
mod reading;
mod report;

pub use conversion::{Converted, Quantity, conversion_report, convert};
pub use file::{Readings, load, parse};
pub use reading::{Reading, Values};
pub use report::report;

use calib_core::point_state::Reason;
use calib_core::points::deviation;
use calib_core::polarity::Polarity;
use calib_core::preferred::REFERENCE_HZ;
use calib_core::settings::Example;
use calib_output::{StateView, code};
use schemars::JsonSchema;
use serde::Serialize;

/// One evaluated point.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PointSensitivity {
    /// Frequency, Hz.
    pub frequency_hz: f32,
    /// `comparison`, `consecutive` or `calibrator`.
    pub method: &'static str,
    /// Magnitude, V per unit of the quantity; none for a refused point.
    pub sensitivity: Option<f32>,
    /// Phase, degrees; none where none was measured.
    pub phase_deg: Option<f32>,
    /// The device is inverted; its phase is that of the inverted axis.
    pub inverted: bool,
    /// Relative change of the reference between its readings.
    pub drift_rel: Option<f32>,
    /// Relative half-width of what the drift may have left: a rectangular
    /// component of the budget (row 3 of Table A.1).
    pub drift_half_width_rel: Option<f32>,
    /// Relative deviation of the magnitude from the reference point.
    pub deviation_rel: Option<f32>,
    /// Deviation in dB.
    pub deviation_db: Option<f32>,
    /// Deviation of the phase from the reference point, degrees.
    pub deviation_deg: Option<f32>,
    /// Whether there is a result.
    pub state: StateView,
    /// Code of the reason for a refusal, in snake case.
    pub reason: Option<String>,
    /// Reason in words.
    #[serde(skip)]
    pub refused: Option<String>,
}

/// Evaluates the points in the order of the file. The reference point, which
/// decides the polarity and from which deviations count, is the point at
/// 160 Hz, else 80 Hz, else the first.
pub fn evaluate(readings: &Readings, example: Example) -> Vec<PointSensitivity> {
    let mut points: Vec<PointSensitivity> = readings
        .points
        .iter()
        .map(|reading| sensitivity(reading, readings.with_phase, example))
        .collect();
    let at = |hz: f32| points.iter().position(|point| point.frequency_hz == hz);
    let reference = REFERENCE_HZ.into_iter().find_map(at).unwrap_or(0);
    if readings.with_phase {
        split_polarity(&mut points, reference);
    }
    state_deviations(&mut points, reference);
    points
}

fn sensitivity(reading: &Reading, with_phase: bool, example: Example) -> PointSensitivity {
    let (method, value, drift) = match reading.values {
        Values::Comparison {
            reference,
            reference_output,
            dut,
        } => ("comparison", Ok(reference * dut / reference_output), None),
        Values::Calibrator { amplitude_rms, dut } => ("calibrator", Ok(dut / amplitude_rms), None),
        Values::Consecutive {
            reference,
            readings,
        } => {
            let value = readings.ratio(example).map(|ratio| ratio * reference);
            ("consecutive", value, Some(readings))
        }
    };
    PointSensitivity {
        frequency_hz: reading.frequency_hz,
        method,
        sensitivity: value.ok().map(|value| value.norm()),
        phase_deg: value
            .ok()
            .filter(|_| with_phase)
            .map(|value| value.arg().to_degrees()),
        inverted: false,
        drift_rel: drift.map(|readings| readings.drift_rel()),
        drift_half_width_rel: drift.map(|readings| readings.drift_half_width_rel()),
        deviation_rel: None,
        deviation_db: None,
        deviation_deg: None,
        state: match value {
            Ok(_) => StateView::Valid,
            Err(_) => StateView::Refused,
        },
        reason: value.err().map(|reason| code(&reason)),
        refused: value.err().map(|reason| match reason {
            // The sequence knows the amplitude by its reference alone.
            Reason::AmplitudeUnstable => {
                "the reference moved by more than Table 3 allows".to_owned()
            }
            reason => reason.to_string(),
        }),
    }
}

/// The reference point decides; at the others a lag stays a lag.
fn split_polarity(points: &mut [PointSensitivity], reference: usize) {
    let mut polarity = Polarity::default();
    let order = std::iter::once(reference).chain(0..points.len());
    for index in order.collect::<Vec<_>>() {
        let Some(point) = points.get_mut(index) else {
            continue;
        };
        if let (Some(phase_deg), false) = (point.phase_deg, point.inverted) {
            let (phase_rad, inverted) = polarity.split(phase_deg.to_radians());
            point.phase_deg = Some(phase_rad.to_degrees());
            point.inverted = inverted;
        }
    }
}

fn state_deviations(points: &mut [PointSensitivity], reference: usize) {
    let found = points.get(reference).map(|p| (p.sensitivity, p.phase_deg));
    let Some((Some(magnitude), phase_deg)) = found else {
        return;
    };
    let reference = (magnitude, phase_deg.unwrap_or(0.0).to_radians());
    for point in points {
        let phase_rad = point.phase_deg.unwrap_or(0.0).to_radians();
        let own = (point.sensitivity.unwrap_or(0.0), phase_rad);
        if let Some(found) = deviation(own, reference) {
            point.deviation_rel = Some(found.rel);
            point.deviation_db = Some(found.db);
            point.deviation_deg = point.phase_deg.map(|_| found.phase_rad.to_degrees());
        }
    }
}
