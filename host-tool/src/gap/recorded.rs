//! A dataset from what a calibrator reports.
//!
//! | column | where it comes from |
//! |---|---|
//! | `acceleration_ms2`, `ref_v` | the level the calibrator held by the calibration table of its reference; `ref_v` is what a reference of the believed sensitivity shows at it |
//! | `dut_v`, `dut_deg` | reported sensitivity and phase, known responses of the device's conditioner taken out |
//! | `coil_v` | the voltage the generator commands, behind its hold and the known output filter: no sensor at the coil |
//! | `time_s` | sample clock, while the point is measured |
//! | conditions | as the operator states them |
//!
//! `rig.toml` has no place for filters, so what is known of them comes out of the rows: [`Known`].

use super::known::Known;
use crate::Result;
use crate::link::Client;
use crate::session::{self, Progress};
use calib_core::point::{PointResult, PointSpec};
use calib_core::verdict::{Reason, Verdict};
use calib_protocol::message::RunState;
use calib_protocol::record::RunLabels;
use calib_twin::dataset::{Nominal, Point};
use calib_twin::rig::Rig;
use serde::Serialize;
use std::f64::consts::SQRT_2;
use std::ops::ControlFlow;

/// Least standard uncertainty of the ratio from point to point, relative: repetition within a point
/// does not show what the grid of the converters does to it. The emulated instrument
/// is right within one standard uncertainty: test `a_rig_without_effects_has_no_gap`.
const LEAST_U_RATIO: f64 = 1e-4;
/// The same for its phase, degrees: 1e-4 rad.
const LEAST_U_PHASE_DEG: f64 = 0.0057;
/// The same for reference over commanded voltage, relative.
const LEAST_U_DRIVE: f64 = 2e-4;

/// Conditions of a run as the operator states them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Setting {
    /// Index of the run.
    pub run: usize,
    /// Rotation of the device under test, degrees.
    pub rotation_deg: f64,
    /// Angle between the axis of motion and the vertical, degrees.
    pub tilt_deg: f64,
    /// Mass mounted, kg.
    pub payload_kg: f64,
    /// Transducer temperature, degrees Celsius.
    pub temperature_c: f64,
}

/// What one run gave.
#[derive(Clone, Debug, Default)]
pub struct Recorded {
    /// Rows of the dataset, in the order of the points; `None` where the calibrator refused.
    pub rows: Vec<Option<Point>>,
    /// Points the calibrator refused.
    pub refused: Vec<PointResult>,
    /// Duration of the run by the sample clock, s.
    pub duration_s: f64,
    /// The operator stopped the run.
    pub stopped: bool,
    /// Why the calibrator ended the run before its last point, if it did.
    pub ended_by: Option<Reason>,
}

/// Measures points and gives them as rows; `start_s` is the time of the run's begin
/// since the first point of the dataset.
///
/// # Errors
/// Those of the link and the device.
pub fn record(
    client: &mut Client,
    known: &Known,
    points: &[PointSpec],
    setting: &Setting,
    start_s: f64,
    mut observe: impl FnMut(&Progress<'_>) -> ControlFlow<()>,
) -> Result<Recorded> {
    let rate_hz = f64::from(client.info()?.sample_rate_hz);
    let begun = client.status()?.samples;
    let mut looks = vec![Look::default(); points.len()];
    let outcome = session::run(client, points, RunLabels::default(), |progress| {
        let status = &progress.status;
        let elapsed_s = status.samples.saturating_sub(begun) as f64 / rate_hz;
        if let Some(look) = looks.get_mut(usize::from(status.point))
            && status.state == RunState::Measuring
            // 0 while the exciter is silenced after the last block.
            && status.drive_peak_v > 0.0
        {
            *look = Look {
                time_s: start_s + elapsed_s,
                drive_peak_v: f64::from(status.drive_peak_v),
            };
        }
        observe(progress)
    })?;
    let mut recorded = Recorded {
        stopped: outcome.state == RunState::Stopped,
        ..Recorded::default()
    };
    for (point, look) in outcome.points.iter().zip(&looks) {
        let row = is_measured(point, look).then(|| row(point, look, known, setting, rate_hz));
        if row.is_none() {
            recorded.refused.push(*point);
        }
        recorded.rows.push(row);
        recorded.duration_s = recorded.duration_s.max(look.time_s - start_s);
    }
    if outcome.points.len() < points.len() {
        recorded.ended_by = outcome.points.last().and_then(refusal);
    }
    Ok(recorded)
}

fn refusal(point: &PointResult) -> Option<Reason> {
    match point.verdict {
        Verdict::Pass => None,
        Verdict::Refused(reason) => Some(reason),
    }
}

/// What the calibrator said of itself while it measured a point. The result has the drive as
/// well, with 8 bits, as it is stored; a look has all of them.
#[derive(Clone, Copy, Debug, Default)]
struct Look {
    time_s: f64,
    drive_peak_v: f64,
}

impl Look {
    fn seen(&self) -> bool {
        self.drive_peak_v > 0.0
    }
}

/// A rig under the conditions of a run that begins `start_s` after the first point.
pub fn under(rig: &Rig, setting: &Setting, nominal: &Nominal, start_s: f64) -> Rig {
    let mut rig = rig.clone();
    rig.exciter.payload_kg = setting.payload_kg;
    rig.surroundings.rotation_deg = setting.rotation_deg;
    rig.surroundings.tilt_deg = setting.tilt_deg;
    rig.surroundings.warmer_k = setting.temperature_c - nominal.environment.reference_temperature_c;
    rig.surroundings.time_s += start_s;
    rig.noise_seed = rig.noise_seed.wrapping_add(setting.run as u64) & i64::MAX as u64;
    rig
}

/// Whether a point is a steady state, even if no calibration: too much distortion is what a
/// diagnosis looks for.
fn is_measured(point: &PointResult, look: &Look) -> bool {
    let steady = matches!(
        refusal(point),
        None | Some(Reason::Distortion | Reason::DutDistortion)
    );
    steady && point.blocks >= 2 && look.seen()
}

/// One reported point as a row.
fn row(
    point: &PointResult,
    look: &Look,
    known: &Known,
    setting: &Setting,
    sample_rate_hz: f64,
) -> Point {
    let reference_v_per_ms2 = known.nominal.reference.sensitivity_v_per_ms2.value;
    let frequency_hz =
        sample_rate_hz * f64::from(point.tone.cycles) / f64::from(point.tone.period_samples);
    let acceleration_ms2 = f64::from(point.acceleration_rms_ms2);
    let dut = known.dut(frequency_hz);
    let drive = known.output(frequency_hz, sample_rate_hz);
    let turned_deg = if point.inverted { 180.0 } else { 0.0 };
    let phase_deg = (f64::from(point.phase_rad) - dut.arg()).to_degrees() + turned_deg;
    let u_phase_deg = f64::from(point.repeatability_phase_rad).to_degrees();
    Point {
        run: setting.run,
        frequency_hz,
        time_s: Some(look.time_s),
        temperature_c: Some(setting.temperature_c),
        rotation_deg: Some(setting.rotation_deg),
        tilt_deg: Some(setting.tilt_deg),
        payload_kg: Some(setting.payload_kg),
        acceleration_ms2: Some(acceleration_ms2),
        coil_v: Some(look.drive_peak_v / SQRT_2 * drive.norm()),
        ref_v: Some(acceleration_ms2 * reference_v_per_ms2),
        dut_v: Some(acceleration_ms2 * f64::from(point.sensitivity_v_per_ms2) / dut.norm()),
        dut_deg: Some((phase_deg + 180.0).rem_euclid(360.0) - 180.0),
        u_ratio: Some(f64::from(point.repeatability_rel).hypot(LEAST_U_RATIO)),
        u_phase_deg: Some(u_phase_deg.hypot(LEAST_U_PHASE_DEG)),
        u_drive: Some(f64::from(point.amplitude_stability_rel).hypot(LEAST_U_DRIVE)),
        ..Point::default()
    }
}
