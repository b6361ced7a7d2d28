//! `calib turnover`: a reference that responds to d.c., checked by turning it over in gravity.

use super::{Context, source, time};
use calib_host::self_check::{self, Found};
use calib_host::{Error, Result};
use calib_metrology::reciprocity::{Change, change_text};
use calib_metrology::turn_over::{TurnOver, TurnOverReadings, turn_over};
use clap::Args;
use jiff::Timestamp;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// `calib turnover`.
#[derive(Debug, Args)]
#[command(after_help = "\
For references that respond to steady acceleration (piezoresistive, capacitive, servo): a voltmeter reads the
output with the axis up, down, down, up, and again, at least twice. The file has the readings and the equipment
(docs/metrology/reciprocity.md#turning-over-in-gravity). An IEPE or charge reference does not respond: use
`calib selfcheck`.

The first check after a calibration is the baseline (--baseline). The result is kept in the logbook, and is on
the chart of `calib assure` and on certificates. It changes no table and extends no interval. Exit code 7 when
the reference changed, or differs from its certificate.")]
pub(crate) struct Turnover {
    /// Readings, gravity, voltmeter and tilt (TOML).
    #[arg(value_name = "FILE")]
    readings: PathBuf,
    /// Any record of the calibrator with this reference, for its table: a file, or the number of one in the
    /// calibrator.
    #[arg(value_name = "RECORD")]
    record: PathBuf,
    /// Makes this check the baseline of later ones: the reference has just come back from calibration.
    #[arg(long)]
    baseline: bool,
}

/// The result.
#[derive(Serialize, JsonSchema)]
pub(super) struct Output {
    /// The sensitivity with its budget.
    #[serde(flatten)]
    found: TurnOver,
    /// Against the baseline, if there is one, and against the certificate.
    changes: Vec<Change>,
    /// Kept in the logbook.
    kept: bool,
}

impl Turnover {
    /// Evaluates, compares, keeps.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let read = TurnOverReadings::read(&self.readings)?;
        let source = source::find(context, &self.record, Path::new("."))?;
        let mut record = source.calibration()?.clone();
        record.head.labels.unix_time_s = self.measured_s(&read)?;
        let found = turn_over(&read, &record.settings.reference)?;
        let logbook = context.logbook_if_there()?;
        let kept = Found::Gravity(found.clone());
        let changes = self_check::changes(logbook.as_ref(), &record, &kept)?;
        if let Some(logbook) = &logbook {
            self_check::keep(logbook, &record, &kept, self.baseline)?;
        }
        let output = Output {
            found,
            changes,
            kept: logbook.is_some(),
        };
        context.print(&output, || text(&output))?;
        let changed = output.changes.iter().find(|change| change.significant);
        Error::not_passed(changed.map(|change| format!("the reference {}", change.words())))
    }
}

impl Turnover {
    /// When it was read, s since 1970-01-01 UTC.
    fn measured_s(&self, read: &TurnOverReadings) -> Result<u64> {
        let Some(told) = &read.measured else {
            return Ok(time::unix_time_s());
        };
        let seconds = told.parse::<Timestamp>().ok().map(Timestamp::as_second);
        let seconds = seconds.and_then(|seconds| u64::try_from(seconds).ok());
        seconds.ok_or_else(|| {
            Error::input(
                self.readings.display().to_string(),
                format!("measured: {told} is no time"),
                "as 2026-11-23T14:30:00Z",
            )
        })
    }
}

fn text(output: &Output) -> String {
    let kept = match output.kept {
        true => "kept in the logbook",
        false => "not kept: there is no logbook",
    };
    format!(
        "{}\n{}\n{kept}",
        output.found.report(),
        change_text(&output.changes)
    )
}
