//! `calib sensitivity`: sensitivity from readings, by clause 6.

use super::Context;
use super::convert::QuantityName;
use calib_core::settings::Example;
use calib_host::{Error, Result};
use calib_metrology::sensitivity::{self, PointSensitivity, Quantity};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;

/// The form of the file, for `--help`.
const FORM: &str = "\
READINGS.csv has frequency_hz, dut_v, and one of
  reference_sensitivity, reference_v                            direct comparison
  reference_sensitivity, reference_before_v, reference_after_v  consecutive (4.5 a)
  amplitude_rms or amplitude_peak, with dut_rms_v or dut_peak_v in place of dut_v
                                                                calibrator, S = X/A
reference_sensitivity is in V per unit; _mv or _v behind its name say the unit.
Phases are optional: dut_deg, reference_deg, reference_before_deg,
reference_after_deg, reference_sensitivity_deg.

See docs/metrology/sensitivity.md.";

/// `calib sensitivity READINGS.csv`.
#[derive(Debug, Args)]
#[command(after_help = FORM)]
pub(crate) struct Sensitivity {
    /// Readings (CSV).
    file: PathBuf,
    /// Drift allowed by Table 3: 1 laboratory (0.1 %), 2 field (0.3 %).
    #[arg(long, default_value_t = 2, value_parser = clap::value_parser!(u8).range(1..=2))]
    example: u8,
    /// Quantity the sensitivities refer to.
    #[arg(long, value_enum, default_value_t = QuantityName::Acceleration)]
    quantity: QuantityName,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Output {
    quantity: Quantity,
    unit: &'static str,
    points: Vec<PointSensitivity>,
    remarks: Vec<String>,
}

impl Sensitivity {
    /// Evaluates and prints; a refused point is not a pass.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let example = match self.example {
            1 => Example::Example1,
            _ => Example::Example2,
        };
        let quantity = Quantity::from(self.quantity);
        let readings = sensitivity::load(&self.file, quantity)?;
        let output = Output {
            quantity,
            unit: quantity.unit(),
            points: sensitivity::evaluate(&readings, example),
            remarks: readings.remarks,
        };
        context.print(&output, || {
            sensitivity::report(&output.points, output.unit, &output.remarks)
        })?;
        let refused = |point: &&PointSensitivity| point.sensitivity.is_none();
        let (count, all) = (
            output.points.iter().filter(refused).count(),
            output.points.len(),
        );
        Error::not_passed((count > 0).then(|| format!("{count} of {all} points were refused")))
    }
}
