//! `calib download ID`: a stored record into a file.

use super::{Context, progress};
use calib_host::{Result, session};
use clap::Args;
use serde::Serialize;
use std::path::PathBuf;

/// `calib download ID`.
#[derive(Debug, Args)]
pub(crate) struct Download {
    /// Running number of the record; `calib records` lists them.
    id: u32,
    /// Directory for the file.
    #[arg(long, short, default_value = ".", value_name = "DIR")]
    out: PathBuf,
}

#[derive(Serialize)]
struct Downloaded {
    file: PathBuf,
    bytes: usize,
    resumed_at: usize,
    points: usize,
}

impl Download {
    /// Downloads the record; an interrupted download goes on where it ended.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let mut client = context.connect()?;
        client.info()?;
        let bar = progress::bytes(context);
        let download = session::download(&mut client, self.id, &self.out, |progress| {
            bar.set_length(progress.total.into());
            bar.set_position(progress.done.into());
        });
        bar.finish_and_clear();
        let download = download?;
        let result = Downloaded {
            file: download.path,
            bytes: download.bytes,
            resumed_at: download.resumed_at,
            points: download.record.points.len(),
        };
        context.print(&result, || {
            format!("{} ({} points)", result.file.display(), result.points)
        })
    }
}
