//! `calib phase`: phase by comparison, ISO 5347-9.

use super::Context;
use calib_host::Result;
use calib_metrology::phase5347::{self, Limits, PhaseResult};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;

/// The form of the file, for `--help`.
const FORM: &str = "\
FILE.toml, everything in degrees:
  reference_deg = 1.0      # limits of Annex A: phi_r,
  phasemeter_deg = 0.5     # phi_p
  amplifier_deg = 0.3      # and phi_a
  [[frequency]]
  frequency_hz = 160
  phase_difference_deg = [-1.0, -1.2, -0.8]
  reference_phase_deg = 0.1  # default 0

See docs/metrology/phase.md.";

/// `calib phase FILE.toml`.
#[derive(Debug, Args)]
#[command(after_help = FORM)]
pub(crate) struct Phase {
    /// Limits and readings (TOML).
    file: PathBuf,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Output {
    limits: Limits,
    results: Vec<PhaseResult>,
    remarks: Vec<String>,
}

impl Phase {
    /// Evaluates and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let file = phase5347::load(&self.file)?;
        let output = Output {
            limits: file.limits,
            results: file
                .points
                .iter()
                .map(|point| phase5347::evaluate(point, &file.limits))
                .collect(),
            remarks: phase5347::remarks(&file),
        };
        context.print(&output, || {
            phase5347::report(&output.results, &output.remarks)
        })
    }
}
