//! `calib gap record`: a dataset from a calibrator.

use super::super::Context;
use super::super::hand::done_by_hand;
use super::super::measure::stop_on_interrupt;
use super::super::number::{finite, positive};
use super::super::progress::RunProgress;
use calib_certificate::SensorKind;
use calib_core::point::PointSpec;
use calib_host::emulated::{self, EmulatedBoard};
use calib_host::gap::design::diagnostic_points;
use calib_host::gap::known::Known;
use calib_host::gap::recorded::{Recorded, Setting, record, under};
use calib_host::in_unit::Stating;
use calib_host::{Error, Result};
use calib_link::Client;
use calib_link::session;
use calib_output::PointView;
use calib_twin::dataset::{self, Point};
use calib_twin::rig::Rig;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::io::{IsTerminal, stdin};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Seconds between two emulated runs: mounting and warming up.
const EMULATED_PAUSE_S: f64 = 900.0;

/// `calib gap record`.
#[derive(Debug, Args)]
pub(crate) struct RecordVerb {
    /// Folder of the dataset.
    #[arg(long, value_name = "DATASET")]
    out: PathBuf,
    /// Beliefs of the simulation about the connected calibrator: a rig file, rig.toml, a dataset,
    /// or `standard`. With `--device emulated` it may be left out.
    #[arg(long, value_name = "RIG")]
    believed: Option<PathBuf>,
    /// Record from an emulated calibrator on this rig file (`demo`: that of the demo). The simulation
    /// then believes all that the file states, except its effects.
    #[arg(long, value_name = "RIG", conflicts_with = "believed")]
    emulated: Option<PathBuf>,
    /// Point list, .toml or .csv; default: the diagnostic plan, 64 points at most.
    #[arg(long, value_name = "FILE")]
    points: Option<PathBuf>,
    /// Level of points that state none; the diagnostic plan goes from a fifth of it to ten
    /// times it. m/s2 r.m.s.
    #[arg(long, default_value_t = 10.0, value_name = "MS2", value_parser = positive::<f32>)]
    level: f32,
    /// Runs; before each one but the first the device under test is mounted anew.
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=20))]
    runs: u8,
    /// Leave harmonics and means out: faster over a slow line.
    #[arg(long)]
    no_waveforms: bool,
    /// Do not wait for the operator between runs.
    #[arg(long)]
    yes: bool,
    /// Rotation of the device under test about the axis of motion, degrees.
    #[arg(
        long,
        value_name = "DEG,...",
        value_delimiter = ',',
        default_value = "0",
        allow_negative_numbers = true,
        value_parser = finite::<f64>
    )]
    rotation: Vec<f64>,
    /// Angle between the axis of motion and the vertical, degrees.
    #[arg(
        long,
        value_name = "DEG,...",
        value_delimiter = ',',
        default_value = "0",
        allow_negative_numbers = true,
        value_parser = finite::<f64>
    )]
    tilt: Vec<f64>,
    /// Mass on the armature, kg; default: that of the rig file, else 0.
    #[arg(long, value_name = "KG,...", value_delimiter = ',', value_parser = finite::<f64>)]
    payload: Vec<f64>,
    /// Transducer temperature, degrees Celsius; default: what the instrument's own sensor shows,
    /// less what its processor warms itself.
    #[arg(
        long,
        value_name = "C,...",
        value_delimiter = ',',
        allow_negative_numbers = true,
        value_parser = finite::<f64>
    )]
    temperature: Vec<f64>,
}

fn usage(problem: impl Into<String>, hint: &str) -> Error {
    Error::usage(problem, hint)
}

/// Where the points are measured.
enum Source {
    Connected(Box<Client>),
    Emulated(Box<Rig>),
}

/// Dataset that was written, and its size.
#[derive(Serialize, JsonSchema)]
pub(in crate::cli) struct Written {
    /// Folder of the dataset.
    dataset: PathBuf,
    /// Rows of the dataset.
    rows: usize,
    /// Runs measured.
    runs: u8,
    /// Points the calibrator refused.
    refused: Vec<PointView>,
    /// Known responses of the chain that were taken out of the rows.
    taken_out: Vec<String>,
}

impl RecordVerb {
    /// Measures and writes the dataset.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        self.check()?;
        let (known, emulated) = self.believed(context)?;
        let mut source = match emulated {
            Some(rig) => Source::Emulated(Box::new(rig)),
            None => Source::Connected(Box::new(context.connect()?)),
        };
        let (mut rows, mut refused) = (Vec::<Point>::new(), Vec::new());
        let stop = stop_on_interrupt(context);
        let begun = Instant::now();
        let mut ended_s = 0.0;
        for run in 0..usize::from(self.runs) {
            let setting = self.setting(run, &known);
            let start_s = match (run, &source) {
                (0, _) => 0.0,
                (_, Source::Emulated(_)) => ended_s + EMULATED_PAUSE_S,
                (_, Source::Connected(_)) => {
                    self.remount(context, &setting)?;
                    begun.elapsed().as_secs_f64().max(ended_s)
                }
            };
            let done = self.measure(context, &mut source, &known, &setting, start_s, &stop)?;
            ended_s = start_s + done.duration_s;
            rows.extend(done.rows.into_iter().flatten());
            let view = |point| PointView::new(point, done.sample_rate_hz);
            refused.extend(done.refused.iter().map(view));
            if let Some(reason) = done.ended_by {
                context.remark(&format!("the calibrator ended the run early: {reason}"));
            }
            if done.stopped {
                context.remark("stopped: what was measured so far is written");
                break;
            }
        }
        self.write(context, &known, &rows, refused)
    }

    fn write(
        &self,
        context: &Context,
        known: &Known,
        rows: &[Point],
        refused: Vec<PointView>,
    ) -> Result<()> {
        if rows.len() < 2 {
            return Err(Error::NotPassed(format!(
                "{} points were measured, a dataset has two at least; `calib run` says of each why \
                 it is refused",
                rows.len()
            )));
        }
        dataset::write(&self.out, &known.nominal, rows)
            .map_err(|error| Error::file("write", &self.out, error))?;
        let result = Written {
            dataset: self.out.clone(),
            rows: rows.len(),
            runs: self.runs,
            refused,
            taken_out: known.corrections(),
        };
        context.print(&result, || {
            format!(
                "{}: {} rows, {} points refused by the calibrator\ntaken out as known: {}",
                self.out.display(),
                rows.len(),
                result.refused.len(),
                known.corrections().join("; ")
            )
        })
    }

    fn check(&self) -> Result<()> {
        if self.out.join("points.csv").exists() {
            return Err(Error::input(
                self.out.display().to_string(),
                "holds a dataset already, and is not overwritten",
                "give another folder with --out",
            ));
        }
        for (name, values) in [
            ("--rotation", &self.rotation),
            ("--tilt", &self.tilt),
            ("--payload", &self.payload),
            ("--temperature", &self.temperature),
        ] {
            if !matches!(values.len(), 0 | 1) && values.len() != usize::from(self.runs) {
                return Err(usage(
                    format!("{name} has {} values for {} runs", values.len(), self.runs),
                    "give one for all runs, or one for each",
                ));
            }
        }
        if self.payload.iter().any(|mass_kg| *mass_kg < 0.0) {
            return Err(usage("--payload is a mass in kg, not negative", "as 0.02"));
        }
        let waits = self.runs > 1 && !self.yes && self.emulated.is_none();
        if waits && !stdin().is_terminal() {
            return Err(usage(
                "several runs wait for the operator, and nobody is at the keyboard",
                "--yes goes on without waiting",
            ));
        }
        Ok(())
    }

    /// Beliefs, and the rig to emulate.
    fn believed(&self, context: &Context) -> Result<(Known, Option<Rig>)> {
        if let Some(file) = &self.emulated {
            let rig = rig_of(file)?;
            return Ok((Known::of(&rig), Some(rig)));
        }
        match &self.believed {
            Some(path) if path.as_os_str() == "demo" => Ok((Known::of(&Rig::standard()), None)),
            Some(path) => Ok((Known::load(path)?, None)),
            None if matches!(context.device.as_deref(), Some("emulated" | "emulated-usb")) => {
                Ok((Known::of(&Rig::standard()), None))
            }
            None => Err(usage(
                "nothing says what the simulation believes of this calibrator",
                "give its rig file with --believed; docs/gap.md shows one",
            )),
        }
    }

    fn setting(&self, run: usize, known: &Known) -> Setting {
        let of = |values: &[f64]| values.get(run).or(values.first()).copied();
        Setting {
            run,
            rotation_deg: of(&self.rotation).unwrap_or(0.0),
            tilt_deg: of(&self.tilt).unwrap_or(0.0),
            payload_kg: of(&self.payload).unwrap_or(known.payload_kg()),
            temperature_c: of(&self.temperature),
        }
    }

    /// Asks the operator to mount the device anew.
    fn remount(&self, context: &Context, setting: &Setting) -> Result<()> {
        let what = format!(
            "run {} of {}: mount the device under test anew: rotation {} degrees, tilt {} degrees, \
             payload {} kg{}",
            setting.run + 1,
            self.runs,
            setting.rotation_deg,
            setting.tilt_deg,
            setting.payload_kg,
            setting
                .temperature_c
                .map_or_else(String::new, |value| format!(", {value} degrees Celsius"))
        );
        if self.yes {
            context.remark(&what);
            return Ok(());
        }
        let left = usage(
            "the operator has left: no run without a mounting",
            "--yes goes on without waiting",
        );
        done_by_hand(&format!("{what}, then press Enter"), left)
    }

    fn measure(
        &self,
        context: &Context,
        source: &mut Source,
        known: &Known,
        setting: &Setting,
        start_s: f64,
        stop: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Recorded> {
        let mut emulated;
        let client = match source {
            Source::Connected(client) => client,
            Source::Emulated(rig) => {
                let rig = under(rig, setting, &known.nominal, start_s);
                let board = EmulatedBoard::power_on_calibrated(&rig, None)?;
                emulated = Client::new(Box::new(board.link()));
                &mut emulated
            }
        };
        let points = self.points(client, known, setting)?;
        let sample_rate_hz = client.info()?.sample_rate_hz;
        let mut progress =
            RunProgress::new(context, Stating::new(SensorKind::default(), sample_rate_hz));
        let waveforms = !self.no_waveforms;
        let recorded = record(
            client,
            known,
            &points,
            setting,
            start_s,
            waveforms,
            |state, now| {
                progress.show(state, now);
                stop()
            },
        );
        Ok(recorded?)
    }

    fn points(
        &self,
        client: &mut Client,
        known: &Known,
        setting: &Setting,
    ) -> Result<Vec<PointSpec>> {
        if let Some(path) = &self.points {
            return Ok(session::read_points(path, self.level)?);
        }
        let limits = client.settings()?.limits;
        let exciter = &known.nominal.exciter;
        let payload_kg = setting.payload_kg;
        Ok(diagnostic_points(self.level, &limits, exciter, payload_kg))
    }
}

fn rig_of(file: &Path) -> Result<Rig> {
    if file.as_os_str() == "demo" {
        return Ok(Rig::standard());
    }
    Ok(emulated::rig_file::load(file)?)
}
