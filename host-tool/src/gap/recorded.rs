//! A dataset from what a calibrator reports.
//!
//! | column | where it comes from |
//! |---|---|
//! | `acceleration_ms2`, `ref_v` | the level the calibrator held by the calibration table of its reference; `ref_v` is what a reference of the believed sensitivity shows at it |
//! | `dut_v`, `dut_deg` | reported sensitivity and phase, known responses of the device's conditioner taken out |
//! | `coil_v` | the voltage the generator commands, behind its hold and the known output filter: no sensor at the coil |
//! | `time_s` | sample clock, while the point is measured |
//! | `ref_h2` .., `dut_h2` .., `ref_dc_v`, `dut_dc_v` | a capture while the point is held, fitted here; means without those at rest |
//! | `temperature_c` | as the operator states it; else that of the instrument's processor, less what it warms itself: good to 10 K, its changes to some tenths |
//! | other conditions | as the operator states them |
//!
//! `rig.toml` has no place for filters, so what is known of them comes out of the rows: [`Known`].

use super::known::Known;
use super::waveforms::Waveforms;
use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_core::point_state::{PointState, Reason};
use calib_core::thermometer::SELF_HEATING_K;
use calib_link::Client;
use calib_link::session::{self, Progress};
use calib_link::{Error, Result};
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
/// Least uncertainty of its phase, degrees: 1e-4 rad.
const LEAST_U_PHASE_DEG: f64 = 0.0057;
/// Least uncertainty of reference over commanded voltage, relative.
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
    /// Transducer temperature, degrees Celsius; what the instrument shows where nobody states it.
    pub temperature_c: Option<f64>,
}

/// Result of one run.
#[derive(Clone, Debug, Default)]
pub struct Recorded {
    /// Rows of the dataset, in the order of the points; `None` where the calibrator refused.
    pub rows: Vec<Option<Point>>,
    /// Points the calibrator refused.
    pub refused: Vec<PointResult>,
    /// Samples per second and channel, Hz.
    pub sample_rate_hz: f32,
    /// Duration of the run by the sample clock, s.
    pub duration_s: f64,
    /// The operator stopped the run.
    pub stopped: bool,
    /// Why the calibrator ended the run before its last point, if it did.
    pub ended_by: Option<Reason>,
}

/// Passes over points at most, to get the waveforms of all of them.
const PASSES: usize = 3;

/// Measures points and gives them as rows; `start_s` is the time of the run's begin
/// since the first point of the dataset. With `waveforms` harmonics and means are added from
/// captures; points that were over before their capture was read are measured once more.
/// `observe` gets the points of the run it looks at.
///
/// # Errors
/// Those of the link and the device.
pub fn record(
    client: &mut Client,
    known: &Known,
    points: &[PointSpec],
    setting: &Setting,
    start_s: f64,
    waveforms: bool,
    mut observe: impl FnMut(&Progress<'_>, &[PointSpec]) -> ControlFlow<()>,
) -> Result<Recorded> {
    let mut pass = Pass {
        known,
        setting,
        rate_hz: f64::from(client.info()?.sample_rate_hz),
        begun: client.status()?.samples,
        start_s,
        waveforms: match waveforms {
            true => Some(Waveforms::at_rest(client)?),
            false => None,
        },
    };
    let mut recorded = Recorded {
        rows: vec![None; points.len()],
        sample_rate_hz: pass.rate_hz as f32,
        ..Recorded::default()
    };
    let mut left: Vec<usize> = (0..points.len()).collect();
    for _ in 0..PASSES {
        let specs: Vec<PointSpec> = left.iter().map(|at| points[*at]).collect();
        let (state, results) = pass.run(client, &specs, &mut observe)?;
        let mut again = Vec::new();
        for (result, at) in results.iter().zip(&left) {
            match result {
                Taken::Row(row) => recorded.rows[*at] = Some(row.clone()),
                Taken::Incomplete(row) => {
                    recorded.rows[*at] = row.clone().or(recorded.rows[*at].take());
                    again.push(*at);
                }
                Taken::Refused(point) => recorded.refused.push(*point),
            }
        }
        recorded.stopped = state == RunState::Stopped;
        if results.len() < specs.len() {
            recorded.ended_by = recorded.refused.last().and_then(refusal);
        }
        left = again;
        if left.is_empty() || recorded.stopped || recorded.ended_by.is_some() {
            break;
        }
    }
    let times = recorded.rows.iter().flatten().filter_map(|row| row.time_s);
    recorded.duration_s = times.fold(start_s, f64::max) - start_s;
    Ok(recorded)
}

/// Fate of a point.
enum Taken {
    Row(Point),
    /// Over before everything about it was read.
    Incomplete(Option<Point>),
    Refused(PointResult),
}

/// One run over some of the points.
struct Pass<'a> {
    known: &'a Known,
    setting: &'a Setting,
    rate_hz: f64,
    /// Samples the calibrator had taken before the first point.
    begun: u64,
    start_s: f64,
    waveforms: Option<Waveforms>,
}

impl Pass<'_> {
    fn run(
        &mut self,
        client: &mut Client,
        points: &[PointSpec],
        observe: &mut impl FnMut(&Progress<'_>, &[PointSpec]) -> ControlFlow<()>,
    ) -> Result<(RunState, Vec<Taken>)> {
        if let Some(waveforms) = &mut self.waveforms {
            waveforms.begin();
        }
        // All blocks of every point: a row says how much it scatters, and is looked at while its level is held.
        let held = ExcitationKind::HeldSine;
        let id = session::begin(client, points, held, RunLabels::default())?;
        let mut looks = vec![Look::default(); points.len()];
        let outcome = session::follow_beside(client, id, points, |progress, client| {
            let status = &progress.status;
            if let Some(look) = looks.get_mut(usize::from(status.point))
                && status.state == RunState::Measuring
                // 0 while the exciter is silenced after the last block.
                && status.drive_peak_v > 0.0
            {
                let elapsed = status.samples.saturating_sub(self.begun) as f64;
                *look = Look {
                    time_s: self.start_s + elapsed / self.rate_hz,
                    drive_peak_v: f64::from(status.drive_peak_v),
                };
            }
            if let Some(waveforms) = &mut self.waveforms {
                waveforms.look(client, status)?;
            }
            Ok::<_, Error>(observe(progress, points))
        })?;
        if let Some(waveforms) = &mut self.waveforms {
            waveforms.end(client)?;
        }
        let results = outcome.points.iter().zip(&looks).enumerate();
        let taken = results.map(|(at, (point, look))| self.taken(at, point, look));
        Ok((outcome.state, taken.collect()))
    }

    fn taken(&self, at: usize, point: &PointResult, look: &Look) -> Taken {
        if !is_measured(point) {
            return Taken::Refused(*point);
        }
        if look.drive_peak_v == 0.0 {
            return Taken::Incomplete(None);
        }
        let mut row = row(point, look, self.known, self.setting, self.rate_hz);
        let complete = self
            .waveforms
            .as_ref()
            .is_none_or(|waveforms| waveforms.complete(&mut row, at, self.known));
        match complete {
            true => Taken::Row(row),
            false => Taken::Incomplete(Some(row)),
        }
    }
}

fn refusal(point: &PointResult) -> Option<Reason> {
    match point.state {
        PointState::Valid => None,
        PointState::Refused(reason) => Some(reason),
    }
}

/// State of the calibrator while it measured a point. The result has the drive as
/// well, with 8 bits, as it is stored; a look has all of them.
#[derive(Clone, Copy, Debug, Default)]
struct Look {
    time_s: f64,
    drive_peak_v: f64,
}

/// A rig under the conditions of a run that begins `start_s` after the first point.
pub fn under(rig: &Rig, setting: &Setting, nominal: &Nominal, start_s: f64) -> Rig {
    let mut rig = rig.clone();
    rig.exciter.payload_kg = setting.payload_kg;
    rig.surroundings.rotation_deg = setting.rotation_deg;
    rig.surroundings.tilt_deg = setting.tilt_deg;
    if let Some(temperature_c) = setting.temperature_c {
        rig.surroundings.warmer_k = temperature_c - nominal.environment.reference_temperature_c;
    }
    rig.surroundings.time_s += start_s;
    rig.noise_seed = rig.noise_seed.wrapping_add(setting.run as u64) & i64::MAX as u64;
    rig
}

/// Whether a point is a steady state, even if no calibration: too much distortion is what a
/// diagnosis looks for.
fn is_measured(point: &PointResult) -> bool {
    let steady = matches!(
        refusal(point),
        None | Some(Reason::Distortion | Reason::DutDistortion)
    );
    steady && point.blocks >= 2
}

/// Temperature around the instrument as its processor shows it, degrees Celsius.
fn surroundings_c(point: &PointResult) -> Option<f64> {
    let processor_c = point.instrument_temperature_c.map(f64::from);
    processor_c.map(|processor_c| processor_c - f64::from(SELF_HEATING_K))
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
        temperature_c: setting.temperature_c.or_else(|| surroundings_c(point)),
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
