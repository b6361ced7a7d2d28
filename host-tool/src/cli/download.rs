//! `calib download ID...`: stored records into files, and their hash chain checked.

use super::{Context, progress};
use calib_files::file::Existing;
use calib_host::{Error, Result};
use calib_link::Client;
use calib_link::session::{self, Fetched};
use calib_protocol::record::{self, RecordKind};
use calib_record::hash_chain::{Break, Standing};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;

/// `calib download ID...`.
#[derive(Debug, Args)]
pub(crate) struct Download {
    /// Running numbers of the records; `calib records` lists them.
    #[arg(required_unless_present = "all", value_name = "ID")]
    ids: Vec<u32>,
    /// Downloads every record.
    #[arg(long, conflicts_with = "ids")]
    all: bool,
    /// Directory for the files.
    #[arg(long, short, default_value = ".", value_name = "DIR")]
    out: PathBuf,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Downloaded {
    file: PathBuf,
    bytes: usize,
    resumed_at: usize,
    #[schemars(with = "&str")]
    kind: RecordKind,
    points: u16,
    record_chain: Standing,
}

impl Downloaded {
    fn text(&self) -> String {
        let content = match self.kind {
            RecordKind::Calibration => format!("{} points", self.points),
            RecordKind::ReferenceChange => "change of settings".to_owned(),
        };
        let chain = match self.record_chain {
            Standing::First => "first of the hash chain",
            Standing::Verified => "hash chain verified",
            Standing::NotAtHand => "the record before is not at hand",
            Standing::Broken => "HASH CHAIN BROKEN",
        };
        format!("{} ({content}; {chain})\n", self.file.display())
    }
}

impl Download {
    /// Downloads the records; an interrupted download goes on where it ended.
    /// Reports the hash chain once the files are there.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let mut client = context.connect()?;
        client.info()?;
        let ids = match self.all {
            true => client.records()?.iter().map(|line| line.id).collect(),
            false => self.ids.clone(),
        };
        let fetched: Result<Vec<Fetched>> = ids
            .iter()
            .map(|id| self.fetch(context, &mut client, *id))
            .collect();
        let fetched = fetched?;
        let evidence = session::evidence(&mut client, &fetched, &self.out)?;
        let done: Vec<Downloaded> = fetched
            .into_iter()
            .map(|record| Downloaded {
                points: record::inspect(&record.bytes).map_or(0, |(line, _)| line.points),
                kind: record.link.kind,
                record_chain: evidence.standing(record.link.id),
                file: record.path,
                bytes: record.bytes.len(),
                resumed_at: record.resumed_at,
            })
            .collect();
        match &done[..] {
            [one] if !self.all => context.print(one, || one.text())?,
            all => context.print(&all, || all.iter().map(Downloaded::text).collect())?,
        }
        judge(&client, &evidence.breaks())
    }

    fn fetch(&self, context: &Context, client: &mut Client, id: u32) -> Result<Fetched> {
        let bar = progress::bytes(context);
        let fetched = session::fetch(client, id, &self.out, Existing::Keep, |progress| {
            bar.set_length(progress.total.into());
            bar.set_position(progress.done.into());
        });
        bar.finish_and_clear();
        Ok(fetched?)
    }
}

/// A broken hash chain is a failure, with every break by its number.
fn judge(client: &Client, breaks: &[Break]) -> Result<()> {
    if breaks.is_empty() {
        return Ok(());
    }
    let breaks: Vec<String> = breaks.iter().map(ToString::to_string).collect();
    Err(Error::input(
        format!("chain of the records of {}", client.name()),
        breaks.join("; "),
        "do not use these records; compare them with those in another folder or in the logbook",
    ))
}
