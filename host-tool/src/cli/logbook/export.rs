//! `calib export --parquet DIR`: the logbook for other programs.

use crate::cli::Context;
use calib_host::Result;
use calib_logbook::export;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;

/// `calib export --parquet DIR`.
#[derive(Debug, Args)]
#[command(after_help = "\
duckdb: SELECT * FROM read_parquet('DIR/points/*/*.parquet', hive_partitioning = true)
polars: pl.scan_parquet('DIR/points', hive_partitioning=True)")]
pub(crate) struct Export {
    /// A new folder for the data set.
    #[arg(long, value_name = "DIR")]
    parquet: PathBuf,
}

#[derive(Serialize, JsonSchema)]
pub(in crate::cli) struct Exported {
    files: Vec<PathBuf>,
}

impl Export {
    /// Writes the data set.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let files = export(&context.logbook()?, &self.parquet)?;
        let exported = Exported { files };
        context.print(&exported, || {
            let files = exported.files.iter();
            files.map(|file| format!("{}\n", file.display())).collect()
        })
    }
}
