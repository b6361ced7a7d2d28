//! `calib demo`: a whole calibration without hardware.

use super::{Context, measure, progress, progress::RunProgress, time};
use calib_certificate::SensorKind;
use calib_host::demo::{self, DemoReport, Event};
use calib_host::in_unit::Stating;
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
        let stop = measure::stop_on_interrupt(context);
        let mut shown = None;
        let report = demo::run(self.seed, &self.out, time::unix_time_s(), |event| {
            match event {
                Event::Step(what) => {
                    shown = None;
                    context.remark(&format!("{what} ..."));
                }
                Event::Progress {
                    progress,
                    list,
                    sample_rate_hz,
                } => shown
                    .get_or_insert_with(|| {
                        RunProgress::new(
                            context,
                            Stating::new(SensorKind::default(), *sample_rate_hz),
                        )
                    })
                    .show(progress, list),
            }
            stop()
        })?;
        progress::print_result(context, &report, || text(&report))?;
        let refused = report.points.iter().filter(|p| !p.measured.is_valid());
        let count = refused.count();
        Error::not_passed((count > 0).then(|| format!("{count} points were refused")))
    }
}

fn text(report: &DemoReport) -> String {
    let point = &report.reference;
    let measured = point.measured.sensitivity_v_per_ms2;
    let measured = measured.map_or(f64::NAN, f64::from);
    let certified = point.certified;
    let truth = point.truth_sensitivity_v_per_ms2;
    let mut lines = vec![
        format!(
            "S({} Hz) = {:.3} mV/(m/s2), U = {:.2} % (k = {:.2}), phase {:.2} deg",
            point.measured.set.frequency_hz,
            1e3 * measured,
            certified.map_or(f64::NAN, |u| 100.0 * u.expanded_uncertainty_rel),
            certified.map_or(f64::NAN, |u| u.coverage_factor),
            point.measured.phase_deg.unwrap_or(f64::NAN),
        ),
        format!(
            "truth      {:.3} mV/(m/s2), {:+.2} % from it,         phase {:.2} deg",
            1e3 * truth,
            100.0 * (measured / truth - 1.0),
            point.truth_phase_deg,
        ),
    ];
    lines.extend(report.files.iter().map(|file| file.display().to_string()));
    lines.join("\n")
}
