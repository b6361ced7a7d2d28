//! `calib capture`: the waveforms of both channels.

use super::measure::stop_on_interrupt;
use super::number::positive;
use super::{Context, time};
use calib_core::point::PointSpec;
use calib_core::point_state::PointState;
use calib_host::{Error, Result, terminal};
use calib_link::Client;
use calib_link::capture::{self, Capture, Inputs, Measured, Report};
use calib_output::StateView;
use calib_protocol::capture::MAX_CAPTURE_PAIRS;
use calib_protocol::record::RunLabels;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;

/// Columns every terminal has.
const COLUMNS: usize = 80;

/// For `--help`.
const EXAMPLES: &str = "\
What is done depends on what is given:
  calib capture                              what is there now: d.c., the highest
                                             lines; during a run, its tone
  calib capture --frequency 160 --level 10   plays 160 Hz at 10 m/s2 r.m.s. and
                                             captures while the level is held
  calib capture --frequency 159.155          what an excitation from elsewhere
                                             does at this very frequency
  calib capture --csv waveform.csv           the waveform for other programs:
                                             time_s,reference_v,dut_v

Harmonics 2 to 5 are relative to the fundamental, their phases to n times its
phase. Noise is what is left after d.c., fundamental and harmonics, up to half
the sample rate. Volts are those at the input connectors.

A capture disturbs nothing: the measurement gets the same samples. A point that
is measured for it leaves a record in the calibrator, like any other.";

/// `calib capture`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct CaptureVerb {
    /// Frequency of the tone, Hz. With --level the tone is played; without, this must be
    /// the exact frequency of a tone that is there.
    #[arg(long, short, value_name = "HZ", value_parser = positive::<f64>)]
    frequency: Option<f64>,
    /// Play the tone at this acceleration, m/s2 r.m.s.
    #[arg(long, short, value_name = "MS2", requires = "frequency", value_parser = positive::<f32>)]
    level: Option<f32>,
    /// Samples of each channel, 1 to 16384; default: ten cycles, at least 4096.
    #[arg(long, short, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=i64::from(MAX_CAPTURE_PAIRS)))]
    pairs: Option<u16>,
    /// Write the waveform here.
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Output<'a> {
    /// Number of the record of the point that was played for it.
    record_id: Option<u32>,
    /// How the point ended; none when none was played.
    state: Option<StateView>,
    /// Code of the reason for a refusal, in snake case.
    reason: Option<String>,
    #[serde(flatten)]
    report: &'a Report,
}

/// Captured waveforms, and their purpose.
struct Captured {
    capture: Capture,
    /// Exact frequency of the tone, if one is known.
    frequency_hz: Option<f64>,
    record_id: Option<u32>,
    point_state: Option<PointState>,
}

impl CaptureVerb {
    /// Captures, analyses and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let mut client = context.connect()?;
        let inputs = Inputs::of(&mut client)?;
        let captured = match (self.frequency, self.level) {
            (Some(frequency_hz), Some(level)) => {
                self.at_level(context, &mut client, &inputs, (frequency_hz, level))?
            }
            _ => self.as_it_is(&mut client, &inputs)?,
        };
        let Captured {
            capture,
            point_state,
            ..
        } = captured;
        let report = Report::new(&capture, captured.frequency_hz)
            .map_err(|error| usage(&error.to_string(), "choose --frequency and --pairs to suit"))?;
        if let Some(path) = &self.csv {
            capture::write_csv(&capture, path)?;
        }
        let (state, reason) = point_state.map(StateView::of).unzip();
        let output = Output {
            record_id: captured.record_id,
            state,
            reason: reason.flatten(),
            report: &report,
        };
        context.print(&output, || {
            terminal::show_capture(&capture, &report, COLUMNS)
        })?;
        match point_state {
            Some(PointState::Refused(reason)) => {
                Err(Error::NotPassed(format!("the point was refused: {reason}")))
            }
            _ => Ok(()),
        }
    }

    /// Plays a point and captures while its level is held.
    fn at_level(
        &self,
        context: &Context,
        client: &mut Client,
        inputs: &Inputs,
        (frequency_hz, level_rms_ms2): (f64, f32),
    ) -> Result<Captured> {
        let point = PointSpec {
            frequency_hz: frequency_hz as f32,
            acceleration_rms_ms2: level_rms_ms2,
        };
        let labels = RunLabels {
            unix_time_s: time::unix_time_s(),
            ..RunLabels::default()
        };
        let pairs = self.pairs(frequency_hz, inputs);
        let flow = stop_on_interrupt(context);
        let stop = || flow().is_break();
        let measured = capture::measure(client, inputs, point, pairs, labels, stop)?;
        let point_state = measured.point.map(|point| point.state);
        let capture = measured.capture.clone();
        Ok(Captured {
            capture: capture.ok_or_else(|| not_held(&measured))?,
            frequency_hz: Some(measured.frequency_hz),
            record_id: Some(measured.record_id),
            point_state,
        })
    }

    /// Captures what is there.
    fn as_it_is(&self, client: &mut Client, inputs: &Inputs) -> Result<Captured> {
        let status = client.status()?;
        let in_work = capture::tone_frequency_hz(status.frequency_hz, inputs.sample_rate_hz);
        let frequency_hz = self.frequency.or(in_work);
        let pairs = self.pairs(frequency_hz.unwrap_or(f64::INFINITY), inputs);
        Ok(Captured {
            capture: inputs.capture(client, pairs)?,
            frequency_hz,
            record_id: None,
            point_state: None,
        })
    }

    fn pairs(&self, frequency_hz: f64, inputs: &Inputs) -> u16 {
        let usual = || capture::pairs_for(frequency_hz, inputs.sample_rate_hz);
        self.pairs.unwrap_or_else(usual)
    }
}

fn usage(problem: &str, hint: &str) -> Error {
    Error::usage(problem, hint)
}

/// Why there is no capture of a point.
fn not_held(measured: &Measured) -> Error {
    let why = match measured.point.map(|point| point.state) {
        Some(PointState::Refused(reason)) => reason.to_string(),
        Some(PointState::Valid) => "the measurement was shorter than the capture".to_owned(),
        None => "the run was stopped; the exciter is silent".to_owned(),
    };
    Error::NotPassed(format!("nothing captured: {why}"))
}
