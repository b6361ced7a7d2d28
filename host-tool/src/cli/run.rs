//! `calib run`: measures a point list.

use super::{Context, logbook, number::positive, progress, progress::RunProgress, text, time};
use calib_core::point::{ExcitationKind, PointSpec};
use calib_core::verdict::Verdict;
use calib_host::{Error, Result};
use calib_link::session::{self, Outcome, label, temperature_centi_c};
use calib_link::{Client, StopSwitch};
use calib_logbook::{Logbook, Sensor, waiting};
use calib_output::{PointView, code};
use calib_protocol::message::RunState;
use calib_protocol::record::RunLabels;
use clap::{Args, ValueEnum};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;
use std::path::PathBuf;

/// `calib run`.
#[derive(Debug, Args)]
pub(crate) struct Run {
    /// Point list, .toml or .csv; default: one-third octaves, 20 Hz to 10 kHz.
    #[arg(long, short, value_name = "FILE")]
    points: Option<PathBuf>,
    /// Set acceleration of points that state none, m/s2 r.m.s.
    #[arg(long, short, default_value_t = 10.0, value_name = "MS2", value_parser = positive::<f32>)]
    level: f32,
    /// How the exciter is driven (ISO 16063-21, 4.4 Note 1). Broadband: all
    /// points at once, moved to the lines of a record of 4096 samples; the level
    /// is the total r.m.s. of the band.
    #[arg(long, value_enum, default_value_t = Excitation::SingleSine)]
    excitation: Excitation,
    /// Device under test, by its serial number in the logbook: model and
    /// mounting are known there.
    #[arg(long, value_name = "SERIAL", conflicts_with_all = ["model", "serial"])]
    sensor: Option<String>,
    /// Device under test: manufacturer and model.
    #[arg(long, value_name = "TEXT", default_value = "")]
    model: String,
    /// Device under test: serial number.
    #[arg(long, value_name = "TEXT", default_value = "")]
    serial: String,
    /// Who calibrates.
    #[arg(long, value_name = "NAME", default_value = "", env = "CALIB_OPERATOR")]
    operator: String,
    /// Temperature of the transducer, degrees Celsius.
    #[arg(long, value_name = "CELSIUS", allow_negative_numbers = true)]
    temperature: Option<f64>,
    /// How the device under test is mounted.
    #[arg(long, value_name = "TEXT", default_value = "")]
    mounting: String,
}

/// Names of [`ExcitationKind`] on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Excitation {
    /// One tone after another.
    SingleSine,
    /// All lines at once, the same record 64 times.
    Multisine,
    /// Periodic noise, 64 different records.
    Random,
}

impl From<Excitation> for ExcitationKind {
    fn from(excitation: Excitation) -> Self {
        match excitation {
            Excitation::SingleSine => Self::SingleSine,
            Excitation::Multisine => Self::Multisine,
            Excitation::Random => Self::Random,
        }
    }
}

/// How a run ended.
#[derive(Serialize, JsonSchema)]
pub(super) struct RunResult {
    /// Running number of the record in the calibrator.
    record_id: u32,
    /// Number of the record in the logbook, if it is kept there.
    logbook_record: Option<i64>,
    /// `finished`, `stopped`, or `failed` when the record could not be stored.
    state: String,
    /// Every point in the order measured.
    points: Vec<PointView>,
}

impl Run {
    /// Measures, follows, and says how it ended.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let mut points = self.points()?;
        let labels = self.labels(context)?;
        let mut client = context.connect()?;
        let info = client.info()?;
        let excitation = ExcitationKind::from(self.excitation);
        if excitation != ExcitationKind::SingleSine {
            points = session::on_lines(&points, info.sample_rate_hz)?;
        }
        let mut progress = RunProgress::new(context, info.sample_rate_hz);
        let outcome = measure(&mut client, &points, excitation, labels, &mut progress)?;
        drop(progress);
        let kept = keep(context, &mut client, &outcome)?;
        let result = RunResult {
            record_id: outcome.record_id,
            logbook_record: kept,
            state: code(&outcome.state),
            points: outcome
                .points
                .iter()
                .map(|point| PointView::new(point, info.sample_rate_hz))
                .collect(),
        };
        progress::print_result(context, &result, || {
            let lines: Vec<_> = outcome.points.iter().map(text::point_line).collect();
            let id = outcome.record_id;
            let next = match kept {
                Some(kept) => format!("kept in the logbook as record {kept}"),
                None => format!("calib download {id}"),
            };
            format!("{}\nrecord {id}: {next}", lines.join("\n"))
        })?;
        judge(&outcome, points.len())
    }

    fn points(&self) -> Result<Vec<PointSpec>> {
        match &self.points {
            Some(path) => Ok(session::read_points(path, self.level)?),
            None => Ok(session::default_points(self.level)),
        }
    }

    fn labels(&self, context: &Context) -> Result<RunLabels> {
        let sensor = self.sensor.as_deref();
        let sensor = sensor.map(|serial| logbook::find_sensor(context, serial));
        let sensor = sensor.transpose()?.unwrap_or_else(|| Sensor {
            serial: self.serial.clone(),
            model: self.model.clone(),
            ..Sensor::default()
        });
        let mounting = match self.mounting.as_str() {
            "" => sensor.mounting.as_deref().unwrap_or_default(),
            stated => stated,
        };
        Ok(RunLabels {
            unix_time_s: time::unix_time_s(),
            dut_model: label("--model", &sensor.name())?,
            dut_serial: label("--serial", &sensor.serial)?,
            operator: label("--operator", &self.operator)?,
            temperature_centi_c: temperature_centi_c("--temperature", self.temperature)?,
            mounting: label("--mounting", mounting)?,
        })
    }
}

/// Keeps the record in the logbook, if this user has one.
fn keep(context: &Context, client: &mut Client, outcome: &Outcome) -> Result<Option<i64>> {
    let path = context.logbook_path();
    if outcome.state == RunState::Failed || !path.exists() {
        return Ok(None);
    }
    let folder =
        tempfile::tempdir().map_err(|error| Error::file("create", &std::env::temp_dir(), error))?;
    let download = session::download(client, outcome.record_id, folder.path(), |_| ())?;
    let bytes = std::fs::read(&download.path)
        .map_err(|error| Error::file("read", &download.path, error))?;
    // It is on disk before the logbook is asked for, which another program may hold.
    let place = waiting::put(&path, &bytes)?;
    match Logbook::enter_waiting(&path) {
        Ok(entered) => Ok(entered
            .iter()
            .find(|(of, _)| *of == place)
            .map(|(_, id)| *id)),
        Err(error) => {
            let folder = waiting::folder(&path);
            let until = format!("the record waits in {} until then", folder.display());
            context.remark(&format!("{error}: {until}; the next run enters it"));
            Ok(None)
        }
    }
}

/// Runs a list with progress. Ctrl-C stops it and silences the exciter.
fn measure(
    client: &mut Client,
    points: &[PointSpec],
    excitation: ExcitationKind,
    labels: RunLabels,
    progress: &mut RunProgress<'_>,
) -> Result<Outcome> {
    let switch = switch_of_interrupts();
    // Ahead of any answer that is waited for; the look at each progress is a second way.
    client.heed(switch.clone());
    let outcome = session::run_excited(client, points, excitation, labels, |state| {
        progress.show(state, points);
        flow(&switch)
    });
    Ok(outcome?)
}

/// From now on, Ctrl-C asks a run to stop instead of ending the tool.
pub(super) fn stop_on_interrupt() -> impl Fn() -> ControlFlow<()> {
    let switch = switch_of_interrupts();
    move || flow(&switch)
}

/// From now on, Ctrl-C is a stop on this switch.
fn switch_of_interrupts() -> StopSwitch {
    let switch = StopSwitch::default();
    let pressed = switch.clone();
    // Without the handler Ctrl-C still ends this tool; the calibrator goes on.
    let _ = ctrlc::set_handler(move || {
        pressed.ask();
    });
    switch
}

fn flow(switch: &StopSwitch) -> ControlFlow<()> {
    match switch.is_asked() {
        true => ControlFlow::Break(()),
        false => ControlFlow::Continue(()),
    }
}

/// Turns anything but a full pass into exit code 7.
fn judge(outcome: &Outcome, wanted: usize) -> Result<()> {
    let refused = outcome
        .points
        .iter()
        .filter(|point| point.verdict != Verdict::Pass)
        .count();
    match outcome.state {
        RunState::Failed => Err(Error::NotPassed(
            "the record could not be stored; the results above are all there is".to_owned(),
        )),
        RunState::Stopped => Err(Error::NotPassed(format!(
            "stopped after {} of {wanted} points; the exciter is silent",
            outcome.points.len()
        ))),
        _ if refused > 0 => Err(Error::NotPassed(format!(
            "{refused} of {wanted} points were refused"
        ))),
        _ => Ok(()),
    }
}
