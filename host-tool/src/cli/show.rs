//! `calib show RECORD`: a record in the terminal.

use super::{Context, source};
use calib_host::certificate::{self, Certificate, Language, Particulars};
use calib_host::{Result, terminal};
use clap::Args;
use std::path::PathBuf;

/// Columns every terminal has.
const COLUMNS: usize = 80;

/// `calib show RECORD`.
#[derive(Debug, Args)]
pub(crate) struct Show {
    /// File of a downloaded record, or the running number of one that is still
    /// in the calibrator (it is downloaded first).
    record: String,
    /// Where a download goes.
    #[arg(long, short, default_value = ".", value_name = "DIR")]
    out: PathBuf,
}

impl Show {
    /// Draws S over f, with a table of the points.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let record = source::find(context, &self.record, &self.out)?;
        let certificate = Certificate::from_record(&record, &Particulars::default());
        let document = certificate::document(&certificate, Language::default());
        context.print(&document, || terminal::show(&record, &certificate, COLUMNS))
    }
}
