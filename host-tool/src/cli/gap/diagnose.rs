//! `calib gap diagnose`: one answer per dataset.

use super::super::Context;
use super::{refused, text};
use calib_gap::{Answer, Options, diagnose_all};
use calib_host::{Error, Result};
use clap::Args;
use std::path::PathBuf;

/// `calib gap diagnose`.
#[derive(Debug, Args)]
pub(crate) struct Diagnose {
    /// Dataset folders (rig.toml with points.csv or record.csv).
    #[arg(required = true, value_name = "DATASET")]
    datasets: Vec<PathBuf>,
    /// Effects that must not be named.
    #[arg(long, value_delimiter = ',', value_name = "EFFECT")]
    without: Vec<String>,
    /// Score on this dataset instead of on held-out rows.
    #[arg(long, value_name = "DATASET")]
    validate: Option<PathBuf>,
    /// Largest number of effects at a time.
    #[arg(long, default_value_t = 2, value_parser = clap::value_parser!(u8).range(0..=3))]
    max_effects: u8,
    /// Write a self-contained HTML report.
    #[arg(long, value_name = "OUT.html")]
    report: Option<PathBuf>,
}

impl Diagnose {
    /// Diagnoses and prints; with several datasets JSON is an array.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let options = Options {
            without: self.without,
            validate: self.validate,
            most_effects: usize::from(self.max_effects),
        };
        let several = self.datasets.len() > 1;
        let show = several && !context.quiet;
        let answers = diagnose_all(&self.datasets, &options, |done, all| {
            if show && (done % 10 == 0 || done == all) {
                eprintln!("{done} of {all} datasets");
            }
        });
        let answers = answers
            .into_iter()
            .collect::<Result<Vec<Answer>, _>>()
            .map_err(refused)?;
        if let Some(path) = &self.report {
            let page = calib_gap::report(&answers);
            std::fs::write(path, page).map_err(|e| Error::file("write", path, e))?;
        }
        match answers.as_slice() {
            [one] => context.print(one, || text::answer(one)),
            many => context.print(&many, || {
                many.iter()
                    .map(text::answer)
                    .collect::<Vec<_>>()
                    .join("\n\n")
            }),
        }
    }
}
