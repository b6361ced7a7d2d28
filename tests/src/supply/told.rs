//! Everything a host was told, and whether it still holds.

use crate::rigged::{Fault, point};
use calib_core::point::PointResult;
use calib_core::point_state::PointState;
use calib_core::settings::Settings;
use calib_files::file::Existing;
use calib_link::Client;
use calib_link::session::{self, Outcome};
use calib_protocol::message::RunState;
use calib_protocol::record::{self, RecordSummary, RunLabels, Sha256Sum};
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

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

/// Knowledge of the host, which whoever watches it may look at between two bytes on the line.
#[derive(Clone, Default)]
pub(super) struct Told(Arc<Mutex<Known>>);

/// Everything a host was told.
#[derive(Clone, Default)]
pub(super) struct Known {
    pub(super) doing: Doing,
    /// Records compared so far.
    pub(super) compared: u64,
    /// Runs reported as finished.
    pub(super) stored: u32,
    /// How often the host was told that something is stored.
    pub(super) tells: u32,
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

impl Known {
    fn compare(&mut self, records: &[RecordSummary]) -> Result<(), Fault> {
        for (id, sum) in &self.records {
            match records.iter().find(|record| record.id == *id) {
                Some(record) if sum.is_none_or(|sum| sum == record.sha256) => self.compared += 1,
                Some(_) => return Err(format!("record {id} is another one").into()),
                None if *id <= self.released => {}
                None => return Err(format!("record {id} is lost").into()),
            }
        }
        // What has made room does not come back, and what was stored before the cut counts, though
        // nobody was told.
        self.records = records
            .iter()
            .map(|record| (record.id, Some(record.sha256)))
            .collect();
        Ok(())
    }

    /// The settings are those the host wrote last, or tried to.
    fn accept(&mut self, found: Settings) -> Result<(), Fault> {
        let candidates = [&self.settings, &self.attempted];
        let known = candidates
            .iter()
            .any(|known| known.as_ref() == Some(&found));
        if self.settings.is_some() && !known {
            return Err("the settings are neither the old nor the new ones".into());
        }
        (self.settings, self.attempted) = (Some(found), None);
        Ok(())
    }

    /// Settings other than those in force, as they are about to be written.
    fn attempt_others(&mut self) -> Result<Settings, Fault> {
        let mut settings = self.settings.clone().ok_or("no settings were read")?;
        let place = BLOCKS.iter().position(|blocks| *blocks == settings.blocks);
        settings.blocks = BLOCKS[place.map_or(0, |place| place + 1) % BLOCKS.len()];
        self.attempted = Some(settings.clone());
        Ok(settings)
    }

    fn newest(&self) -> Option<u32> {
        self.records.last_key_value().map(|(id, _)| *id)
    }

    fn sum(&self, id: u32) -> Option<Sha256Sum> {
        self.records.get(&id).copied().flatten()
    }
}

impl Told {
    /// A copy that goes its own way from here on.
    pub(super) fn apart(&self) -> Self {
        Self(Arc::new(Mutex::new(self.known().clone())))
    }

    /// Knowledge at this instant. No request may be made while it is held.
    pub(super) fn known(&self) -> MutexGuard<'_, Known> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Notes what the host turns to.
    pub(super) fn turn_to(&self, doing: Doing) {
        self.known().doing = doing;
    }

    /// Everything told is there, and nothing is half there.
    pub(super) fn look(&self, client: &mut Client, folder: &Path) -> Result<(), Fault> {
        self.turn_to(Doing::Look);
        client.info()?;
        let found = client.settings()?;
        self.known().accept(found)?;
        let records = client.records()?;
        self.known().compare(&records)?;
        let newest = records.last().map(|record| record.id);
        let oldest = records.first().map(|record| record.id);
        for id in [newest, oldest].into_iter().flatten() {
            self.fetch(client, id, folder)?;
        }
        Ok(())
    }

    /// Writes other settings, which somebody holds the button for.
    pub(super) fn change_settings(&self, client: &mut Client) -> Result<(), Fault> {
        let settings = self.known().attempt_others()?;
        client.write_settings(settings)?;
        {
            let mut known = self.known();
            known.settings = known.attempted.take();
            known.tells += 1;
        }
        // The log of it is a record.
        let records = client.records()?;
        let last = records.last().ok_or("a change of settings has no log")?;
        self.known().records.insert(last.id, Some(last.sha256));
        Ok(())
    }

    /// Measures a point; the record counts as told when the run is reported as finished.
    pub(super) fn measure(&self, client: &mut Client) -> Result<(), Fault> {
        self.turn_to(Doing::Measure);
        let list = [point(160.0, 10.0)];
        let outcome = session::run(client, &list, RunLabels::default(), |_| {
            ControlFlow::Continue(())
        })?;
        let passed = |result: &PointResult| result.state == PointState::Valid;
        if outcome.state != RunState::Finished || !outcome.points.iter().all(passed) {
            return Err(format!("a run ends {:?}: {:?}", outcome.state, outcome.points).into());
        }
        let id = outcome.record_id;
        {
            let mut known = self.known();
            known.stored += 1;
            known.tells += 1;
            // From here on the host counts on it.
            known.records.insert(id, None);
        }
        let records = client.records()?;
        let last = records.last().filter(|last| last.id == id);
        let last = last.ok_or("the record of a finished run is not in the list")?;
        let mut known = self.known();
        known.records.insert(last.id, Some(last.sha256));
        known.measured = Some(outcome);
        Ok(())
    }

    /// Downloads the newest record.
    pub(super) fn download(&self, client: &mut Client, folder: &Path) -> Result<(), Fault> {
        self.turn_to(Doing::Download);
        let newest = self.known().newest();
        self.fetch(client, newest.ok_or("nothing to download")?, folder)
    }

    /// Releases what the host keeps, but for the newest.
    pub(super) fn release(&self, client: &mut Client) -> Result<(), Fault> {
        self.turn_to(Doing::Release);
        let newest = self.known().newest().unwrap_or(0);
        // Before it is said: the request may get through and its answer not.
        let released = newest.saturating_sub(LEFT);
        self.known().released = released;
        // Again and again: each writes, and so lets sectors fill and be erased.
        for _ in 0..RELEASES {
            client.release(released)?;
        }
        Ok(())
    }

    /// Downloads a record, going on where a cut broke off, and compares its content.
    fn fetch(&self, client: &mut Client, id: u32, folder: &Path) -> Result<(), Fault> {
        let fetched = session::fetch(client, id, folder, Existing::Keep, |_| ())?;
        let content = std::fs::read(&fetched.path)?;
        let sum = record::check(&content).map(|_| record::digest(&content));
        let known = self.known();
        if sum.ok() != known.sum(id) {
            return Err(format!("record {id} has another content than its sum says").into());
        }
        let before = id.checked_sub(1).and_then(|id| known.sum(id));
        if before.is_some_and(|sum| sum != fetched.link.previous_sha256) {
            return Err(format!("record {id} does not follow the one before").into());
        }
        let measured = known.measured.as_ref().filter(|run| run.record_id == id);
        let Some(run) = measured else { return Ok(()) };
        match record::decode(&content)?.points.as_slice() == run.points.as_slice() {
            true => Ok(()),
            false => Err(format!("record {id} is not what was measured").into()),
        }
    }
}
