//! `calib predict`: a transducer's output for a record, or the input behind it.

use super::Context;
use super::number::finite;
use calib_files::file;
use calib_host::{Error, Result};
use calib_metrology::discrete::Mapping;
use calib_metrology::input::Source;
use calib_metrology::oscillator::Oscillator;
use calib_metrology::predict::{self, Estimate, Model, Request};
use calib_metrology::record;
use calib_metrology::text::significant;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;

/// Forms of the files, for `--help`.
const FORM: &str = "\
RECORD.csv has the columns time_s and input (acceleration), or with --inverse
time_s and output. --model takes the file of `calib identify --json`.

See docs/metrology/prediction.md.";

/// `calib predict RECORD.csv --model MODEL.json`.
#[derive(Debug, Args)]
#[command(after_help = FORM)]
pub(crate) struct Predict {
    /// Record of the acceleration, or with --inverse of the output (CSV).
    record: PathBuf,
    /// Identified model (JSON of `calib identify`, or TOML).
    #[arg(long, value_name = "FILE", required_unless_present = "s0")]
    model: Option<PathBuf>,
    /// Sensitivity at low frequencies, instead of --model.
    #[arg(long, conflicts_with = "model", requires_all = ["f0_hz", "delta"], value_parser = finite::<f64>)]
    s0: Option<f64>,
    /// Resonance frequency, Hz.
    #[arg(long, value_parser = finite::<f64>)]
    f0_hz: Option<f64>,
    /// Damping coefficient.
    #[arg(long, value_parser = finite::<f64>)]
    delta: Option<f64>,
    /// Estimate the acceleration behind an output.
    #[arg(long)]
    inverse: bool,
    /// Inverse: cut-off of the stabilising low-pass filter; default f0 / 2.
    #[arg(long, requires = "inverse", value_name = "HZ", value_parser = finite::<f64>)]
    cutoff_hz: Option<f64>,
    /// Standard uncertainty of each sample of the record (independent noise).
    #[arg(long, default_value_t = 0.0, value_name = "U", value_parser = finite::<f64>)]
    u_sample: f64,
    /// Use the plain bilinear mapping, without pre-warping.
    #[arg(long)]
    no_pre_warp: bool,
    /// Write time, value and standard uncertainty here (CSV).
    #[arg(long, short, value_name = "FILE.csv")]
    out: Option<PathBuf>,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Output {
    quantity: &'static str,
    sample_rate_hz: f64,
    mapping: Mapping,
    samples: usize,
    peak: f64,
    peak_time_s: f64,
    #[serde(rename = "standard_uncertainty_peak")]
    u_peak: f64,
    cutoff_hz: Option<f64>,
    regularisation_error_max: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    estimate: Option<Estimate>,
}

impl Predict {
    /// Computes, writes and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let model = self.load()?;
        let record = record::read(Source::read(&self.record)?)?;
        let (signal, name) = match self.inverse {
            true => (record.output.as_ref(), "output"),
            false => (record.input.as_ref(), "input"),
        };
        let signal = signal.ok_or_else(|| {
            Error::input(
                format!("{}:1", self.record.display()),
                format!("there is no column '{name}'"),
                "columns: time_s, and input (acceleration) or, with --inverse, output",
            )
        })?;
        if self.u_sample < 0.0 {
            return Err(Error::usage(
                "--u-sample must not be negative",
                "state the standard uncertainty of one sample",
            ));
        }
        let request = Request {
            sample_rate_hz: record.sample_rate_hz,
            mapping: match self.no_pre_warp {
                true => Mapping::Bilinear,
                false => Mapping::BilinearPrewarped,
            },
            u_sample: self.u_sample,
            cutoff_hz: self.cutoff_hz.unwrap_or(model.oscillator.f0_hz / 2.0),
        };
        let estimate = match self.inverse {
            true => predict::estimate_input(&model, signal, &request)?,
            false => predict::predict_output(&model, signal, &request),
        };
        self.finish(context, estimate, &request, record.start_s)
    }

    fn load(&self) -> Result<Model> {
        let model = match (&self.model, self.s0, self.f0_hz, self.delta) {
            (Some(path), ..) => predict::load_model(path),
            (None, Some(s0), Some(f0_hz), Some(delta)) => {
                Model::new(Oscillator { s0, f0_hz, delta }, [0.0; 3])
            }
            _ => Err(calib_files::Error::usage(
                "the model is not complete",
                "give --model FILE, or --s0, --f0-hz and --delta",
            )),
        };
        Ok(model?)
    }

    fn finish(
        &self,
        context: &Context,
        estimate: Estimate,
        request: &Request,
        start_s: f64,
    ) -> Result<()> {
        let time = |index: usize| start_s + index as f64 / request.sample_rate_hz;
        let peak = (0..estimate.values.len())
            .max_by(|&a, &b| {
                estimate.values[a]
                    .abs()
                    .total_cmp(&estimate.values[b].abs())
            })
            .unwrap_or(0);
        let largest = |values: &Vec<f64>| values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        if let Some(path) = &self.out {
            let mut text = String::from("time_s,value,u_value\n");
            for (index, value) in estimate.values.iter().enumerate() {
                let _ = writeln!(
                    text,
                    "{:e},{value:e},{:e}",
                    time(index),
                    estimate.u_values[index]
                );
            }
            file::replace(path, text.as_bytes())?;
        }
        let output = Output {
            quantity: if self.inverse {
                "acceleration"
            } else {
                "output"
            },
            sample_rate_hz: request.sample_rate_hz,
            mapping: request.mapping,
            samples: estimate.values.len(),
            peak: estimate.values[peak],
            peak_time_s: time(peak),
            u_peak: estimate.u_values[peak],
            cutoff_hz: self.inverse.then_some(request.cutoff_hz),
            regularisation_error_max: estimate.regularisation_error.as_ref().map(largest),
            estimate: self.out.is_none().then_some(estimate),
        };
        context.print(&output, || text(&output, self.out.is_some()))
    }
}

fn text(output: &Output, written: bool) -> String {
    let mut text = format!(
        "Estimated {} at {} S/s, {} samples\n  peak {} at {} s, standard uncertainty {}\n",
        output.quantity,
        significant(output.sample_rate_hz, 7),
        output.samples,
        significant(output.peak, 6),
        significant(output.peak_time_s, 6),
        significant(output.u_peak, 2)
    );
    if let (Some(cutoff), Some(error)) = (output.cutoff_hz, output.regularisation_error_max) {
        let _ = writeln!(
            text,
            "  low-pass filter at {} Hz takes at most {} from it: not in the uncertainty",
            significant(cutoff, 5),
            significant(error, 2)
        );
    }
    if !written {
        text.push_str("  every sample: add --out FILE.csv, or --json\n");
    }
    text
}
