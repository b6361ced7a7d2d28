//! `calib check RECORD`: a record against ISO 16063-21.

use super::Context;
use calib_certificate::{Particulars, missing, with_certified_uncertainty};
use calib_core::settings::Example;
use calib_host::{Error, Result};
use calib_metrology::check::{self, Missing};
use calib_protocol::record;
use clap::Args;
use std::path::PathBuf;

/// `calib check RECORD`.
#[derive(Debug, Args)]
pub(crate) struct Check {
    /// Downloaded record.
    record: PathBuf,
    /// Statements of the laboratory beside the record (TOML; may be repeated).
    #[arg(long, value_name = "FILE.toml")]
    particulars: Vec<PathBuf>,
    /// Apply the requirements of Example 1 or 2 instead of the record's own.
    #[arg(long, value_parser = clap::value_parser!(u8).range(1..=2))]
    example: Option<u8>,
}

impl Check {
    /// Judges and prints; a failed requirement is not a pass.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let bytes = std::fs::read(&self.record)
            .map_err(|error| Error::file("read", &self.record, error))?;
        let record = record::decode(&bytes).map_err(|error| {
            Error::input(
                self.record.display().to_string(),
                error.to_string(),
                "give a file that `calib download` wrote",
            )
        })?;
        let example = self.example.map(|number| match number {
            1 => Example::Example1,
            _ => Example::Example2,
        });
        let particulars = Particulars::read(&self.particulars)?;
        let missing = missing(&record, &particulars);
        let missing = missing.map(|(item, clause)| Missing { item, clause });
        let certified = with_certified_uncertainty(&record, &particulars);
        let result = check::check(&certified, missing.collect(), example);
        context.print(&result, || check::report(&result))?;
        let failed =
            (!result.passed).then(|| "the record does not fulfil every requirement".into());
        Error::not_passed(failed)
    }
}
