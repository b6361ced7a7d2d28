//! `calib sync`: what the logbook lacks, from every calibrator that is connected.

use super::{Context, measure, progress};
use calib_files::file::Existing;
use calib_host::{Error, Result};
use calib_link::{Client, session};
use calib_logbook::{Logbook, waiting};
use calib_protocol::record::RecordSummary;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::Path;

/// `calib sync`.
#[derive(Debug, Args)]
#[command(after_help = "\
Without --device calib asks every port that may be a calibrator. It downloads and enters records the
logbook lacks: of runs in which a link broke, that the button began, or that another computer
followed. Nothing is removed from the calibrator.")]
pub(crate) struct Sync {}

/// Records that came from a calibrator.
#[derive(Serialize, JsonSchema)]
pub(super) struct Synced {
    device: String,
    instrument_serial: String,
    /// Running numbers of the records that were fetched.
    fetched: Vec<u32>,
    /// Records that the logbook had.
    known: usize,
    /// Why the logbook has not taken all of them yet.
    waiting: Option<String>,
}

impl Sync {
    /// Asks one calibrator after another; one that does not answer keeps no other from being asked.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let (mut all, mut failed) = (Vec::new(), None);
        for device in context.devices()? {
            match sync(context, &device) {
                Ok(synced) => all.push(synced),
                Err(error) if failed.is_none() => failed = Some(error),
                Err(error) => context.remark(&error.to_string()),
            }
        }
        context.print(&all, || all.iter().map(Synced::text).collect())?;
        failed.map_or(Ok(()), Err)
    }
}

impl Synced {
    fn text(&self) -> String {
        let numbers: Vec<String> = self.fetched.iter().map(u32::to_string).collect();
        let fetched = match numbers.as_slice() {
            [] => "nothing new".to_owned(),
            numbers => format!("fetched {}", numbers.join(", ")),
        };
        let known = self.known;
        let line = format!("{} at {}", self.instrument_serial, self.device);
        format!("{line}: {fetched}; the logbook had {known}\n")
    }
}

fn sync(context: &Context, device: &str) -> Result<Synced> {
    let mut client = context.connect_to(device)?;
    let serial = client.info()?.serial;
    let path = context.logbook_path();
    let all = client.records()?;
    let lacking = lacking(&path, &all)?;
    for id in &lacking {
        fetch(context, &mut client, *id, &path)?;
    }
    // What an earlier one left there too.
    let keys = session::stated_key(&mut client)?;
    let waiting = measure::enter(context, &path, keys.as_slice()).err();
    Ok(Synced {
        device: device.to_owned(),
        instrument_serial: serial.as_str().to_owned(),
        known: all.len() - lacking.len(),
        fetched: lacking,
        waiting,
    })
}

/// Running numbers of those of an instrument's records that the logbook has not.
fn lacking(path: &Path, all: &[RecordSummary]) -> Result<Vec<u32>> {
    let logbook = Logbook::open(path)?;
    let mut lacking = Vec::new();
    for line in all {
        if !logbook.has(&line.sha256)? {
            lacking.push(line.id);
        }
    }
    Ok(lacking)
}

/// Puts a record where it waits for the logbook, on disk at once: a link that breaks keeps those before it.
fn fetch(context: &Context, client: &mut Client, id: u32, logbook: &Path) -> Result<()> {
    let folder =
        tempfile::tempdir().map_err(|error| Error::file("create", &std::env::temp_dir(), error))?;
    let bar = progress::bytes(context);
    let fetched = session::fetch(client, id, folder.path(), Existing::Keep, |progress| {
        bar.set_length(progress.total.into());
        bar.set_position(progress.done.into());
    });
    bar.finish_and_clear();
    waiting::put(logbook, &fetched?.bytes)?;
    Ok(())
}
