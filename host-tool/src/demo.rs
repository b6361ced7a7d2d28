//! The demo: a calibration from power-on to the certificate, without hardware.
//!
//! Everything happens as it would on a bench. The host sends nothing it would
//! not send to hardware, and the board is reset between measuring and
//! downloading, so the certificate comes from what flash kept.

use crate::emulated::{EmulatedBoard, settings_for};
use crate::in_unit::{Certified, of_certificate};
use crate::{Error, Result};
use calib_certificate::{self as certificate, Certificate, Format, Options, Particulars};
use calib_core::point::{PointResult, PointSpec};
use calib_files::file::Existing;
use calib_link::Client;
use calib_link::session::{self, Progress};
use calib_output::PointView;
use calib_protocol::record::{Record, RunLabels};
use calib_twin::oracle;
use calib_twin::rig::Rig;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Reference point of the result (ISO 16063-21, 5.3), Hz.
const REFERENCE_POINT_HZ: f32 = 160.0;

/// News from the demo while it runs.
#[derive(Debug)]
pub enum Event<'a> {
    /// A step begins.
    Step(&'static str),
    /// The run stands here.
    Progress {
        /// Where.
        progress: &'a Progress<'a>,
        /// Measurand.
        list: &'a [PointSpec],
        /// Samples per second and channel, Hz.
        sample_rate_hz: f32,
    },
}

/// A point of the demo's run, and the truth of the simulated device.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct DemoPoint {
    /// Measured values.
    #[serde(flatten)]
    pub measured: PointView,
    /// U as the certificate states it; none where the point was refused.
    pub certified: Option<Certified>,
    /// Sensitivity of the simulated device at the frequency played, V/(m/s2).
    pub truth_sensitivity_v_per_ms2: f64,
    /// Its phase, degrees.
    pub truth_phase_deg: f64,
}

/// The result: the reference point, all points, and the files.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct DemoReport {
    /// The point at 160 Hz.
    pub reference: DemoPoint,
    /// Every point in the order measured.
    pub points: Vec<DemoPoint>,
    /// Time of the instrument's own clock from the order to measure to its end, s.
    pub instrument_s: f64,
    /// Record and certificate.
    pub files: Vec<PathBuf>,
}

/// Runs the demo. The seed draws another device, another exciter and the errors
/// the reference's certificate has within its stated uncertainty.
///
/// # Errors
/// [`Error::Input`] when there is no firmware image; whatever may happen to a
/// link, a run, a download or a file.
pub fn run(
    seed: u64,
    out: &Path,
    unix_time_s: u64,
    mut observe: impl FnMut(&Event<'_>) -> ControlFlow<()>,
) -> Result<DemoReport> {
    let rig = Rig::draw(seed);
    step(&mut observe, "switching the emulated calibrator on");
    let board = EmulatedBoard::power_on(&rig)?;
    let mut client = Client::new(Box::new(board.link()));
    let sample_rate_hz = client.info()?.sample_rate_hz;
    step(
        &mut observe,
        "writing the reference's calibration into its settings",
    );
    let settings = settings_for(&rig, client.settings()?, Some(seed));
    board.set_up(&mut client, settings)?;
    step(&mut observe, "measuring");
    let points = session::default_points(10.0);
    let labels = labels(seed, unix_time_s);
    let begun_ms = client.info()?.uptime_ms;
    let outcome = session::run(&mut client, &points, labels, |progress| {
        observe(&Event::Progress {
            progress,
            list: &points,
            sample_rate_hz,
        })
    })?;
    let instrument_s = 1e-3 * client.info()?.uptime_ms.saturating_sub(begun_ms) as f64;
    step(&mut observe, "resetting the board");
    board.reset()?;
    step(
        &mut observe,
        "downloading the record and writing the certificate",
    );
    let download = session::download_with(
        &mut client,
        outcome.record_id,
        out,
        Existing::Replace,
        |_| (),
    )?;
    // A demo may be shown twice.
    let options = Options {
        existing: Existing::Replace,
        particulars: laboratory()?,
        ..Options::default()
    };
    let mut files = vec![download.path];
    files.extend(certificate::write_with(
        &download.record,
        &Format::ALL,
        out,
        &options,
    )?);
    report(&rig, &download.record, files, instrument_s)
}

/// A step cannot be refused: only a run is worth stopping.
fn step(observe: &mut impl FnMut(&Event<'_>) -> ControlFlow<()>, what: &'static str) {
    let _ = observe(&Event::Step(what));
}

/// Particulars the demo states beside the record; the rest is printed as missing.
fn laboratory() -> Result<Particulars> {
    toml::from_str(LABORATORY).map_err(|error| {
        let hint = "report this as a defect";
        Error::input("laboratory of the demo", error.message(), hint)
    })
}

const LABORATORY: &str = "\
[laboratory]
name = 'calib demo, simulated'
city = 'Braunschweig'
country = 'DE'
[calibration]
place = 'laboratory'
adjustment = 'reported_only'
[mounting]
orientation = 'vertical'
";

fn labels(seed: u64, unix_time_s: u64) -> RunLabels {
    RunLabels {
        unix_time_s,
        dut_model: "simulated accelerometer".try_into().unwrap_or_default(),
        dut_serial: format!("SIM-{seed}")
            .as_str()
            .try_into()
            .unwrap_or_default(),
        operator: "calib demo".try_into().unwrap_or_default(),
        temperature_centi_c: Some(2300),
        mounting: "rigid, simulated".try_into().unwrap_or_default(),
    }
}

fn report(
    rig: &Rig,
    record: &Record,
    files: Vec<PathBuf>,
    instrument_s: f64,
) -> Result<DemoReport> {
    let certificate = Certificate::from_record(record, &laboratory()?);
    let point = |point: &PointResult| DemoPoint {
        certified: of_certificate(point, &certificate),
        ..demo_point(rig, record.head.sample_rate_hz, point)
    };
    let points: Vec<DemoPoint> = record.points.iter().map(point).collect();
    let at_reference = points
        .iter()
        .find(|point| point.measured.set.frequency_hz == REFERENCE_POINT_HZ)
        .ok_or_else(|| Error::NotPassed("stopped before the point at 160 Hz".to_owned()))?;
    Ok(DemoReport {
        reference: at_reference.clone(),
        points,
        instrument_s,
        files,
    })
}

fn demo_point(rig: &Rig, sample_rate_hz: f32, point: &PointResult) -> DemoPoint {
    let measured = PointView::new(point, sample_rate_hz);
    let nominal_hz = f64::from(measured.set.frequency_hz);
    let truth = oracle::dut_sensitivity(rig, measured.actual_frequency_hz.unwrap_or(nominal_hz));
    DemoPoint {
        measured,
        certified: None,
        truth_sensitivity_v_per_ms2: truth.norm(),
        truth_phase_deg: truth.arg().to_degrees(),
    }
}
