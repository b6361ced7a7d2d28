//! `calib identify`: model parameters of an accelerometer.

use super::Context;
use super::number::finite;
use calib_files::file;
use calib_host::{Error, Result};
use calib_metrology::identify::{self, Identification, Spread, Weighting};
use calib_metrology::input::Source;
use calib_metrology::record;
use calib_metrology::shock::{self, Choice};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// The forms of the files, for `--help`.
const FORM: &str = "\
POINTS.csv has one header line and the columns
  frequency_hz   magnitude   phase_deg (or phase_rad)
  u_magnitude (or u_magnitude_percent, u_magnitude_rel)   u_phase_deg
with standard uncertainties; without the last two the fit is unweighted.
The phase of an output that lags is negative.

RECORD.csv has the columns time_s, input (acceleration) and output, equally
spaced in time.

See docs/metrology/identification.md.";

/// `calib identify POINTS.csv`.
#[derive(Debug, Args)]
#[command(after_help = FORM)]
pub(crate) struct Identify {
    /// Sinusoidal calibration points (CSV).
    #[arg(required_unless_present = "shock", conflicts_with = "shock")]
    points: Option<PathBuf>,
    /// Identify from a shock record instead (CSV: time_s, input, output).
    #[arg(long, value_name = "RECORD.csv")]
    shock: Option<PathBuf>,
    /// Shock: lowest frequency used, Hz.
    #[arg(long, requires = "shock", value_name = "HZ", value_parser = finite::<f64>)]
    from_hz: Option<f64>,
    /// Shock: highest frequency used, Hz.
    #[arg(long, requires = "shock", value_name = "HZ", value_parser = finite::<f64>)]
    to_hz: Option<f64>,
    /// Shock: pre-warp the bilinear mapping at the resonance.
    #[arg(long, requires = "shock")]
    pre_warp: bool,
    /// Shock: known delay of the input channel behind the output channel, s.
    #[arg(
        long,
        requires = "shock",
        default_value_t = 0.0,
        value_name = "S",
        allow_negative_numbers = true,
        value_parser = finite::<f64>
    )]
    input_delay_s: f64,
    /// Shock: uncertainty coefficient of (27) from a budget, for the test.
    #[arg(long, requires = "shock", value_name = "U0", value_parser = finite::<f64>)]
    u0: Option<f64>,
    /// Ignore the stated uncertainties.
    #[arg(long)]
    unweighted: bool,
    /// Significance p of the chi-squared test (37), at most 0.05.
    #[arg(long, default_value_t = 0.05, value_name = "P", value_parser = finite::<f64>)]
    significance: f64,
    /// Monte Carlo trials for the uncertainties; 0 for none.
    #[arg(long, default_value_t = 20_000, value_name = "N")]
    trials: usize,
    /// Seed of the random numbers.
    #[arg(long, default_value_t = 1, value_name = "N")]
    seed: u64,
    /// Write the chart of the empirical test here (SVG).
    #[arg(long, value_name = "FILE.svg")]
    chart: Option<PathBuf>,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Output {
    #[serde(flatten)]
    identification: Identification,
    monte_carlo: Option<Spread>,
}

impl Identify {
    /// Identifies and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        match (&self.shock, &self.points) {
            (Some(record), _) => self.identify_shock(context, record),
            (None, Some(points)) => self.identify_points(context, points),
            (None, None) => Ok(()),
        }
    }

    fn identify_shock(&self, context: &Context, path: &Path) -> Result<()> {
        for (name, value) in [
            ("--from-hz", self.from_hz),
            ("--to-hz", self.to_hz),
            ("--u0", self.u0),
        ] {
            if value.is_some_and(|value| value <= 0.0) {
                return Err(Error::usage(
                    format!("{name} must be greater than zero"),
                    "leave it out for the default",
                ));
            }
        }
        let record = record::read(Source::read(path)?)?;
        let choice = Choice {
            from_hz: self.from_hz,
            to_hz: self.to_hz,
            u0: self.u0,
            prewarp: self.pre_warp,
            input_delay_s: self.input_delay_s,
        };
        let result = shock::identify(&record, &choice).map_err(|error| error.of_file(path))?;
        if let Some(chart) = &self.chart {
            file::replace(chart, shock::simulation_chart(&record, &result).as_bytes())?;
        }
        let consistent = result.consistent;
        context.print(&result, || shock::report(&result))?;
        passed(consistent)
    }

    fn identify_points(&self, context: &Context, path: &Path) -> Result<()> {
        if !(self.significance > 0.0 && self.significance <= 0.05) {
            return Err(Error::usage(
                format!("--significance {} is outside 0 .. 0.05", self.significance),
                "ISO 16063-43 8.5.1 asks for p of at most 0.05",
            ));
        }
        let points = identify::read(Source::read(path)?)?;
        let weighting = match self.unweighted || !points.has_uncertainties {
            true => Weighting::None,
            false => Weighting::Covariance,
        };
        let identification = identify::identify(&points, weighting, self.significance)
            .map_err(|error| error.of_file(path))?;
        let monte_carlo = match weighting {
            Weighting::Covariance if self.trials > 0 => {
                identify::propagate(&points, &identification, self.trials.max(1000), self.seed)
            }
            _ => None,
        };
        if let Some(chart) = &self.chart {
            let svg = identify::response_chart(&points, &identification);
            file::replace(chart, svg.as_bytes())?;
        }
        let output = Output {
            identification,
            monte_carlo,
        };
        context.print(&output, || {
            identify::report(&output.identification, output.monte_carlo.as_ref())
        })?;
        passed(output.identification.consistent)
    }
}

/// A rejected model was printed, but is not to be used; one that could not be tested is no failure.
fn passed(consistent: Option<bool>) -> Result<()> {
    let rejected =
        "the data reject the model: its parameters and their uncertainties are not to be used";
    Error::not_passed((consistent == Some(false)).then(|| rejected.to_owned()))
}
