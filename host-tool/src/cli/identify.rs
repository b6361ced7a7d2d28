//! `calib identify`: model parameters of an accelerometer.

use super::Context;
use calib_host::metrology::identify::{self, Identification, Spread, Weighting};
use calib_host::metrology::input::Source;
use calib_host::{Error, Result, file};
use clap::Args;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// The forms of the files, for `--help`.
const FORM: &str = "\
POINTS.csv has one header line and the columns
  frequency_hz   magnitude   phase_deg (or phase_rad)
  u_magnitude (or u_magnitude_percent, u_magnitude_rel)   u_phase_deg
with standard uncertainties; without the last two the fit is unweighted.
The phase of an output that lags is negative.

See docs/metrology/identification.md.";

/// `calib identify POINTS.csv`.
#[derive(Debug, Args)]
#[command(after_help = FORM)]
pub(crate) struct Identify {
    /// Sinusoidal calibration points (CSV).
    points: PathBuf,
    /// Ignore the stated uncertainties.
    #[arg(long)]
    unweighted: bool,
    /// Significance p of the chi-squared test (37), at most 0.05.
    #[arg(long, default_value_t = 0.05, value_name = "P")]
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

#[derive(Serialize)]
struct Output {
    #[serde(flatten)]
    identification: Identification,
    monte_carlo: Option<Spread>,
}

impl Identify {
    /// Identifies and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        self.from_points(context, &self.points)
    }

    fn from_points(&self, context: &Context, path: &Path) -> Result<()> {
        if !(self.significance > 0.0 && self.significance <= 0.05) {
            return Err(Error::Usage {
                problem: format!("--significance {} is outside 0 .. 0.05", self.significance),
                hint: "ISO 16063-43 8.5.1 asks for p of at most 0.05".into(),
            });
        }
        let points = identify::read(Source::read(path)?)?;
        let weighting = match self.unweighted || !points.has_uncertainties {
            true => Weighting::None,
            false => Weighting::Covariance,
        };
        let identification = identify::identify(&points, weighting, self.significance)?;
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
        })
    }
}
