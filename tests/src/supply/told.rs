//! Everything a host was told, and whether it still holds.

use crate::bench::{Fault, point};
use calib_core::point::PointResult;
use calib_core::settings::Settings;
use calib_core::verdict::Verdict;
use calib_files::file::Existing;
use calib_link::Client;
use calib_link::session::{self, Outcome};
use calib_protocol::message::RunState;
use calib_protocol::record::{self, RecordSummary, RunLabels, Sha256Sum};
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::Path;

/// Blocks of a point, in turn: every change of settings is one.
const BLOCKS: [u16; 3] = [3, 4, 5];
/// Records the host leaves in the instrument after it has released the others.
const LEFT: u32 = 5;
/// Releases of a round; some 130 fill a sector.
const RELEASES: u32 = 25;

/// Action of a host on the instrument.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Doing {
    /// Waiting until it hears.
    #[default]
    Boot,
    /// Looking whether everything is there.
    Look,
    /// Writing settings.
    Settings,
    /// Measuring and storing.
    Measure,
    /// Downloading the record.
    Download,
    /// Releasing records, which lets sectors be erased.
    Release,
}

/// Knowledge of the host.
#[derive(Default)]
pub(super) struct Told {
    pub(super) doing: Doing,
    /// Records compared so far.
    pub(super) compared: u64,
    /// Runs reported as finished.
    pub(super) stored: u32,
    /// Their sums, as far as they were listed.
    records: BTreeMap<u32, Option<Sha256Sum>>,
    /// Results of the newest run.
    measured: Option<Outcome>,
    settings: Option<Settings>,
    /// A change that was begun may or may not have come through.
    attempted: Option<Settings>,
    /// Only records the host released may be gone.
    released: u32,
}

impl Told {
    /// Everything told is there, and nothing is half there.
    pub(super) fn look(&mut self, client: &mut Client, folder: &Path) -> Result<(), Fault> {
        self.doing = Doing::Look;
        client.info()?;
        let found = client.settings()?;
        let candidates = [&self.settings, &self.attempted];
        let known = candidates
            .iter()
            .any(|known| known.as_ref() == Some(&found));
        if self.settings.is_some() && !known {
            return Err("the settings are neither the old nor the new ones".into());
        }
        (self.settings, self.attempted) = (Some(found), None);
        let records = client.records()?;
        self.compare(&records)?;
        // What was stored before the cut, though nobody was told.
        for record in &records {
            self.records.insert(record.id, Some(record.sha256));
        }
        let newest = records.last().map(|record| record.id);
        let oldest = records.first().map(|record| record.id);
        for id in [newest, oldest].into_iter().flatten() {
            self.fetch(client, id, folder)?;
        }
        Ok(())
    }

    fn compare(&mut self, records: &[RecordSummary]) -> Result<(), Fault> {
        for (id, sum) in &self.records {
            match records.iter().find(|record| record.id == *id) {
                Some(record) if sum.is_none_or(|sum| sum == record.sha256) => self.compared += 1,
                Some(_) => return Err(format!("record {id} is another one").into()),
                None if *id <= self.released => {}
                None => return Err(format!("record {id} is lost").into()),
            }
        }
        // What has made room does not come back.
        self.records
            .retain(|id, _| records.iter().any(|record| record.id == *id));
        Ok(())
    }

    /// Writes other settings, which somebody holds the button for.
    pub(super) fn change_settings(&mut self, client: &mut Client) -> Result<(), Fault> {
        let mut settings = self.settings.clone().ok_or("no settings were read")?;
        let place = BLOCKS.iter().position(|blocks| *blocks == settings.blocks);
        settings.blocks = BLOCKS[place.map_or(0, |place| place + 1) % BLOCKS.len()];
        self.attempted = Some(settings.clone());
        client.write_settings(settings)?;
        self.settings = self.attempted.take();
        // The log of it is a record.
        let records = client.records()?;
        let last = records.last().ok_or("a change of settings has no log")?;
        self.records.insert(last.id, Some(last.sha256));
        Ok(())
    }

    /// Measures a point; the record counts as told when the run is reported as finished.
    pub(super) fn measure(&mut self, client: &mut Client) -> Result<(), Fault> {
        self.doing = Doing::Measure;
        let list = [point(160.0, 10.0)];
        let outcome = session::run(client, &list, RunLabels::default(), |_| {
            ControlFlow::Continue(())
        })?;
        let passed = |result: &PointResult| result.verdict == Verdict::Pass;
        if outcome.state != RunState::Finished || !outcome.points.iter().all(passed) {
            return Err(format!("a run ends {:?}: {:?}", outcome.state, outcome.points).into());
        }
        self.stored += 1;
        // From here on the host counts on it.
        self.records.insert(outcome.record_id, None);
        let records = client.records()?;
        let last = records.last().filter(|last| last.id == outcome.record_id);
        let last = last.ok_or("the record of a finished run is not in the list")?;
        self.records.insert(last.id, Some(last.sha256));
        self.measured = Some(outcome);
        Ok(())
    }

    /// Downloads the newest record.
    pub(super) fn download(&mut self, client: &mut Client, folder: &Path) -> Result<(), Fault> {
        self.doing = Doing::Download;
        let newest = self.records.last_key_value();
        let (id, _) = newest.ok_or("nothing to download")?;
        self.fetch(client, *id, folder)
    }

    /// Releases what the host keeps, but for the newest.
    pub(super) fn release(&mut self, client: &mut Client) -> Result<(), Fault> {
        self.doing = Doing::Release;
        let newest = self.records.last_key_value().map_or(0, |(id, _)| *id);
        // Before it is said: the request may get through and its answer not.
        self.released = newest.saturating_sub(LEFT);
        // Again and again: each writes, and so lets sectors fill and be erased.
        for _ in 0..RELEASES {
            client.release(self.released)?;
        }
        Ok(())
    }

    /// Downloads a record, going on where a cut broke off, and compares its content.
    fn fetch(&self, client: &mut Client, id: u32, folder: &Path) -> Result<(), Fault> {
        let fetched = session::fetch(client, id, folder, Existing::Keep, |_| ())?;
        let content = std::fs::read(&fetched.path)?;
        let sum = record::check(&content).map(|_| record::digest(&content));
        let known = self.records.get(&id).copied().flatten();
        if sum.ok() != known {
            return Err(format!("record {id} has another content than its sum says").into());
        }
        let before = id.checked_sub(1).and_then(|id| self.records.get(&id));
        let before = before.copied().flatten();
        if before.is_some_and(|sum| sum != fetched.link.previous_sha256) {
            return Err(format!("record {id} does not follow the one before").into());
        }
        let measured = self.measured.as_ref().filter(|run| run.record_id == id);
        let Some(run) = measured else { return Ok(()) };
        match record::decode(&content)?.points.as_slice() == run.points.as_slice() {
            true => Ok(()),
            false => Err(format!("record {id} is not what was measured").into()),
        }
    }
}
