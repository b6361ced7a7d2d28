//! `calib export`: the logbook for other programs, as a data set of its own or as a part of a lake.

use crate::cli::Context;
use crate::cli::certificate::Laboratory;
use calib_certificate::Particulars;
use calib_host::Result;
use calib_logbook::{add_to_lake, export};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// `calib export --parquet DIR` or `calib export --lake DIR`.
#[derive(Debug, Args)]
#[command(after_help = "\
duckdb: SELECT * FROM read_parquet('DIR/points/*/*.parquet', hive_partitioning = true)
polars: pl.scan_parquet('DIR/points', hive_partitioning=True)

A lake has laboratories, instruments and years as folders below each table; docs/fleet.md has its tables:
duckdb: SELECT * FROM read_parquet('DIR/points/**/*.parquet', hive_partitioning = true, union_by_name = true)")]
pub(crate) struct Export {
    /// A new folder for the data set.
    #[arg(long, value_name = "DIR", required_unless_present = "lake")]
    parquet: Option<PathBuf>,
    /// A lake that many laboratories add to: records it has are not written again.
    #[arg(long, value_name = "DIR", conflicts_with = "parquet")]
    lake: Option<PathBuf>,
    /// Name of the laboratory in the lake [default: that in the file of the laboratory].
    #[arg(long, value_name = "NAME", requires = "lake")]
    laboratory_name: Option<String>,
    #[command(flatten)]
    laboratory: Laboratory,
}

#[derive(Serialize, JsonSchema)]
pub(in crate::cli) struct Exported {
    /// Files that were written.
    files: Vec<PathBuf>,
    /// Records that were new to the lake; none of a data set.
    records: Option<usize>,
}

impl Export {
    /// Writes the data set, or adds to the lake.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let logbook = context.logbook()?;
        let exported = match (&self.lake, &self.parquet) {
            (Some(lake), _) => {
                let added = add_to_lake(&logbook, lake, &self.name()?)?;
                Exported {
                    files: added.files,
                    records: Some(added.records),
                }
            }
            (None, parquet) => Exported {
                files: export(&logbook, parquet.as_deref().unwrap_or(Path::new("")))?,
                records: None,
            },
        };
        if exported.records == Some(0) {
            context.remark("the lake has all of it already");
        }
        context.print(&exported, || {
            let files = exported.files.iter();
            files.map(|file| format!("{}\n", file.display())).collect()
        })
    }

    /// The laboratory's name: the one given, else that in its file.
    fn name(&self) -> Result<String> {
        match &self.laboratory_name {
            Some(name) => Ok(name.clone()),
            None => {
                let stated = Particulars::read(&self.laboratory.before(&[]))?.laboratory;
                Ok(stated.name.unwrap_or_default())
            }
        }
    }
}
