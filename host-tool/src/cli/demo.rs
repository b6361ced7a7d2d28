//! `calib demo`: a whole calibration without hardware.

use super::{Context, progress::RunProgress, run, time};
use calib_host::demo::{self, DemoReport, Event};
use calib_host::{Error, Result};
use clap::Args;
use std::path::PathBuf;

/// `calib demo`.
#[derive(Debug, Args)]
pub(crate) struct Demo {
    /// Directory for record and certificate.
    #[arg(long, short, default_value = "demo", value_name = "DIR")]
    out: PathBuf,
    /// Draws another device under test and another exciter; 0 is the standard one.
    #[arg(long, default_value_t = 0, value_name = "N")]
    seed: u64,
}

impl Demo {
    /// Calibrates a simulated accelerometer and compares with its truth.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let stop = run::stop_on_interrupt();
        let mut progress = None;
        let report = demo::run(self.seed, &self.out, time::unix_time_s(), |event| {
            match event {
                Event::Step(what) => {
                    progress = None;
                    context.remark(&format!("{what} ..."));
                }
                Event::Progress(state, list) => progress
                    .get_or_insert_with(|| RunProgress::new(context))
                    .show(state, list),
            }
            stop()
        })?;
        context.print(&report, || text(&report))?;
        let refused = report.points.iter().filter(|point| point.verdict != "pass");
        match refused.count() {
            0 => Ok(()),
            count => Err(Error::NotPassed(format!("{count} points were refused"))),
        }
    }
}

fn text(report: &DemoReport) -> String {
    let point = &report.reference;
    let measured = f64::from(point.sensitivity_v_per_ms2);
    let deviation_percent = 100.0 * (measured / point.truth_v_per_ms2 - 1.0);
    let mut lines = vec![
        format!(
            "S({} Hz) = {:.3} mV/(m/s2), U = {:.2} % (k = {:.2}), phase {:.2} deg",
            point.frequency_hz,
            1e3 * measured,
            point.expanded_uncertainty_percent,
            point.coverage_factor,
            point.phase_deg,
        ),
        format!(
            "truth      {:.3} mV/(m/s2), {deviation_percent:+.2} % from it,         phase {:.2} deg",
            1e3 * point.truth_v_per_ms2,
            point.truth_phase_deg,
        ),
    ];
    lines.extend(report.files.iter().map(|file| file.display().to_string()));
    lines.join("\n")
}
