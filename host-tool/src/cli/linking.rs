//! `calib linking`: links comparisons, judges degrees of equivalence.

use super::Context;
use calib_files::file;
use calib_host::Result;
use calib_metrology::input::Source;
use calib_metrology::linking::{self, Degree, Judgement, LinkedFrequency, equivalence_chart};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// The forms of the files, for `--help`.
const FORM: &str = "\
FILE.toml:
  title = \"...\"
  coverage_factor = 2
  [[cipm]]                        # results of the key comparison
  laboratory = \"PTB\"
  frequency_hz = 160
  value = 0.12985
  standard_uncertainty = 0.00005  # or expanded_uncertainty, with k = 2
  [[rmo]]                         # results of the regional comparison, alike

FILE.csv (--doe): laboratory, frequency_hz, degree_of_equivalence,
expanded_uncertainty.

See docs/metrology/linking.md.";

/// `calib linking FILE.toml` or `calib linking --doe FILE.csv`.
#[derive(Debug, Args)]
#[command(after_help = FORM)]
pub(crate) struct Linking {
    /// Results of both comparisons (TOML).
    #[arg(required_unless_present = "doe", conflicts_with = "doe")]
    file: Option<PathBuf>,
    /// Judge a table of published degrees of equivalence (CSV).
    #[arg(long, value_name = "FILE.csv")]
    doe: Option<PathBuf>,
    /// Also print the degrees of equivalence between pairs.
    #[arg(long)]
    pairs: bool,
    /// Write the graph of the degrees of equivalence here (SVG).
    #[arg(long, value_name = "FILE.svg")]
    chart: Option<PathBuf>,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Output {
    title: String,
    coverage_factor: f64,
    frequencies: Vec<LinkedFrequency>,
    #[serde(flatten)]
    judgement: Judgement,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct DoeOutput {
    #[serde(flatten)]
    judgement: Judgement,
    remarks: Vec<String>,
}

impl Linking {
    /// Links or judges, and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        match (&self.doe, &self.file) {
            (Some(table), _) => self.judge(context, table),
            (None, Some(path)) => self.link(context, path),
            (None, None) => Ok(()),
        }
    }

    fn judge(&self, context: &Context, path: &Path) -> Result<()> {
        let table = linking::read_table(Source::read(path)?)?;
        self.draw(&table.degrees)?;
        let output = DoeOutput {
            judgement: linking::judge(&table.degrees),
            remarks: table.remarks,
        };
        context.print(&output, || {
            let remarks: String = output.remarks.iter().map(|r| format!("  {r}\n")).collect();
            linking::doe_report(&output.judgement) + &remarks
        })
    }

    fn link(&self, context: &Context, path: &Path) -> Result<()> {
        let results = linking::load(path)?;
        let frequencies = results.link_all();
        let degrees = degrees(&frequencies);
        self.draw(&degrees)?;
        let output = Output {
            title: results.title.clone(),
            coverage_factor: results.coverage_factor,
            judgement: linking::judge(&degrees),
            frequencies,
        };
        context.print(&output, || {
            linking::link_report(&results, &output.frequencies, self.pairs)
        })
    }

    fn draw(&self, degrees: &[Degree]) -> Result<()> {
        let Some(path) = &self.chart else {
            return Ok(());
        };
        Ok(file::replace(path, equivalence_chart(degrees).as_bytes())?)
    }
}

fn degrees(frequencies: &[LinkedFrequency]) -> Vec<Degree> {
    frequencies
        .iter()
        .flat_map(|entry| {
            entry.linked.laboratories.iter().map(|laboratory| Degree {
                laboratory: laboratory.laboratory.clone(),
                frequency_hz: entry.frequency_hz,
                d: laboratory.d,
                u_expanded: laboratory.u_expanded,
            })
        })
        .collect()
}
