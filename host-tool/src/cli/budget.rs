//! `calib budget`: evaluates an uncertainty budget.

use super::Context;
use calib_core::budget::Table;
use calib_files::file;
use calib_host::{Error, Result};
use calib_metrology::budget::{self, Budget, Evaluation};
use calib_metrology::evaluated::EvaluationView;
use calib_metrology::monte_carlo::{self, Comparison, Options, Plan};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// The form of the file, for `--help`.
const FORM: &str = "\
A budget is a TOML file:

  measurand = \"sensitivity magnitude at 160 Hz\"
  coverage_factor = 2            # or coverage_probability = 0.95, or neither
  [[component]]
  label = \"Reference\"
  value = 0.5                    # percent: half-width, or expanded for normal
  distribution = \"normal\"        # rectangular, triangular, u_shaped, special
  k = 2                          # normal only; special has divisor = ...
  sensitivity_coefficient = 1    # default 1
  degrees_of_freedom = 9         # default infinite
  [[correlation]]
  a = \"Reference\"
  b = \"Gain\"
  r = 0.5                        # or \"unknown\": the bound of D.4

See docs/metrology/budget.md for the rest: phase budgets, two stages, models.";

/// `calib budget FILE`.
#[derive(Debug, Args)]
#[command(after_help = FORM)]
pub(crate) struct BudgetVerb {
    /// Budget to evaluate (TOML).
    #[arg(required_unless_present = "template")]
    file: Option<PathBuf>,
    /// Print an empty budget with every row of a table of Annex A.
    #[arg(long, value_enum, value_name = "TABLE", conflicts_with = "file")]
    template: Option<Template>,
    /// Also propagate the distributions and judge the first-order result.
    #[arg(long)]
    monte_carlo: bool,
    /// Seed of the random numbers.
    #[arg(long, default_value_t = 1, value_name = "N")]
    seed: u64,
    /// Trials at which Monte Carlo gives up.
    #[arg(long, default_value_t = 20_000_000, value_name = "N")]
    most_trials: usize,
    /// Write the contribution chart here (SVG).
    #[arg(long, value_name = "FILE.svg")]
    chart: Option<PathBuf>,
}

/// Tables of ISO 16063-21 Annex A on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Template {
    /// Magnitude at calibration conditions.
    A1,
    /// Phase at calibration conditions.
    A2,
    /// Magnitude over the complete frequency and amplitude range.
    A3,
    /// Phase over the complete frequency and amplitude range.
    A4,
}

impl From<Template> for Table {
    fn from(template: Template) -> Self {
        match template {
            Template::A1 => Self::A1,
            Template::A2 => Self::A2,
            Template::A3 => Self::A3,
            Template::A4 => Self::A4,
        }
    }
}

impl BudgetVerb {
    /// Evaluates and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        if let Some(template) = self.template {
            let template = budget::template(template.into());
            return context.print(&template, || template.to_toml());
        }
        // The command line demands one of the two.
        let path = self.file.as_deref().ok_or_else(|| {
            Error::usage(
                "a budget file is missing",
                "name a file, or use --template a1",
            )
        })?;
        let budget = budget::load(path)?;
        let evaluation = budget::evaluate(&budget);
        let monte_carlo = self
            .monte_carlo
            .then(|| self.propagate(&budget, &evaluation));
        if let Some(path) = &self.chart {
            file::replace(path, budget::contribution_chart(&evaluation).as_bytes())?;
        }
        let view = EvaluationView::new(&evaluation, monte_carlo.as_ref());
        context.print(&view, || {
            let mut text = budget::report(&evaluation);
            if let Some(comparison) = &monte_carlo {
                text.push_str(&monte_carlo::report(comparison, evaluation.unit));
            }
            text
        })
    }

    /// Draws to a fifth of the tolerance the comparison needs (GUM-S1 8.2).
    fn propagate(&self, budget: &Budget, evaluation: &Evaluation) -> Comparison {
        let options = Options {
            probability: evaluation.coverage_probability.clamp(0.5, 0.9999),
            seed: self.seed,
            share: 0.2,
            most_trials: self.most_trials,
            ..Options::default()
        };
        let outcome = monte_carlo::propagate(&Plan::new(budget), &options);
        monte_carlo::validate(evaluation, &outcome, 2)
    }
}
