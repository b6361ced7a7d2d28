//! `calib history SERIAL`: drift over the years beside the uncertainty.

use crate::cli::{Context, number::positive, time};
use calib_host::{Error, Result, terminal};
use calib_logbook::History as Drift;
use calib_metrology::text::Table;
use calib_output::number::fixed;
use clap::Args;

/// Columns and rows of the plot.
pub(super) const SIZE: (usize, usize) = (80, 12);

/// `calib history SERIAL`.
#[derive(Debug, Args)]
#[command(after_help = "\
A change between two calibrations is judged by its own expanded uncertainty. With one reference in
one instrument, the reference's calibration, the gain and the ratio of the channels are common and not
in it. E_n is the change over that uncertainty; beyond 1 it is marked, and the exit code is 7.")]
pub(crate) struct History {
    /// Serial number of the sensor.
    serial: String,
    /// Frequency to compare at, Hz.
    #[arg(long, value_name = "HZ", default_value_t = 160.0, value_parser = positive::<f64>)]
    frequency: f64,
}

impl History {
    /// Draws the drift and warns where it exceeds the uncertainty.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let history = context.logbook()?.history(&self.serial, self.frequency)?;
        if history.results.is_empty() {
            return Err(Error::input(
                format!("sensor {}", self.serial),
                format!(
                    "no record of it holds a passed point at {} Hz",
                    self.frequency
                ),
                "`calib logbook records` lists what is kept",
            ));
        }
        context.print(&history, || text(&history))?;
        let exceeded = history
            .results
            .iter()
            .filter(|result| result.drift_exceeds_uncertainty);
        match exceeded.count() {
            0 => Ok(()),
            count => Err(Error::NotPassed(format!(
                "the sensor changed by more than the uncertainty of the change, {count} times"
            ))),
        }
    }
}

/// The results over time with U, under a heading.
pub(super) fn plot(history: &Drift) -> String {
    format!(
        "{} at {} Hz, change from the first in %, bars are U\n{}",
        history.sensor,
        history.frequency_hz,
        terminal::show_history(history, SIZE.0, SIZE.1)
    )
}

fn text(history: &Drift) -> String {
    let mut table = Table::new(&[
        "measured",
        "record",
        history.unit,
        "U/%",
        "drift/%",
        "U of it/%",
        "E_n",
        "",
    ]);
    for result in &history.results {
        let drift = result.drift_rel;
        table.row([
            time::date_and_minute(u64::try_from(result.unix_time_s).unwrap_or(0)),
            result.record_id.to_string(),
            format!("{:.5}", result.sensitivity),
            format!("{:.2}", 100.0 * result.expanded_uncertainty_rel),
            drift.map_or(String::new(), |drift| signed(100.0 * drift)),
            result
                .u_drift_rel
                .map_or(String::new(), |u| format!("{:.2}", 100.0 * u)),
            result.e_n.map_or(String::new(), signed),
            match result.drift_exceeds_uncertainty {
                true => "changed".to_owned(),
                false => String::new(),
            },
        ]);
    }
    format!("{}\n{table}", plot(history))
}

/// Two decimals with a sign; zero has none.
pub(super) fn signed(value: f64) -> String {
    let text = fixed(value, 2);
    match value > 0.0 && text != "0.00" {
        true => format!("+{text}"),
        false => text,
    }
}
