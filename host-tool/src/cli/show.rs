//! `calib show RECORD`: a record in the terminal.

use super::Context;
use super::certificate::Laboratory;
use super::source::{self, Content, Whose};
use calib_certificate::{self as certificate, Certificate, Language, SensorKind};
use calib_host::{Result, judged, terminal};
use calib_output::ChangeView;
use calib_record::hash_chain::Standing;
use clap::Args;
use std::path::PathBuf;

/// `calib show RECORD`.
#[derive(Debug, Args)]
pub(crate) struct Show {
    /// File of a downloaded record, or the running number of one that is still
    /// in the calibrator (it is downloaded first).
    record: PathBuf,
    #[command(flatten)]
    whose: Whose,
    /// Directory for a download.
    #[arg(long, short, default_value = ".", value_name = "DIR")]
    out: PathBuf,
    /// Unit of the sensitivities, as of `calib sensors add` [default: that of the sensor].
    #[arg(long, value_name = "UNIT")]
    unit: Option<SensorKind>,
    #[command(flatten)]
    laboratory: Laboratory,
}

impl Show {
    /// Draws S over f, with a table of the points; of a change of settings, what was
    /// in force before and is since.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let found = source::find_of(context, &self.whose, &self.record, &self.out)?;
        let record = match &found.content {
            Content::Calibration(record) => record,
            Content::ReferenceChange(change) => {
                return context.print(&ChangeView::from(&**change), || {
                    terminal::show_change(change)
                });
            }
        };
        if found.standing == Standing::Broken {
            context.remark("the chain of records is broken: this one, or the one before, was altered or removed");
        }
        let logbook = context.logbook_if_there()?;
        let files = self.laboratory.before(&[]);
        let mut particulars = judged::of_record(&files, record, logbook.as_ref())?;
        judged::show_in(&mut particulars, self.unit)?;
        let certificate = Certificate::from_record(record, &particulars);
        let document = certificate::Document::new(&certificate, Language::default());
        context.print(&document, || {
            terminal::show(record, &certificate, terminal::columns())
        })
    }
}
