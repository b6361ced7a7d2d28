//! Records out: from an ended run to the archive.

use crate::board::{RECORD_AREA, RecordFlash};
use crate::identity::Identity;
use crate::state;
use calib_core::settings::Settings;
use calib_firmware::archive::{Archive, ArchiveError, Memory};
use calib_firmware::command::{RecordPage, RecordPart};
use calib_protocol::message::{Refusal, RunState, SettingsChange};
use calib_protocol::record::{Record, RunLabels};
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::mutex::{Mutex, MutexGuard};

/// The archive behind a lock. Nobody waits for it on behalf of a host: while
/// it is being written, a host hears that the calibrator is busy.
pub(crate) struct SharedArchive(Mutex<CriticalSectionRawMutex, Archive<'static, RecordFlash>>);

type ArchiveGuard<'a> = MutexGuard<'a, CriticalSectionRawMutex, Archive<'static, RecordFlash>>;

impl SharedArchive {
    /// Reads the record area; returns the archive and the stored settings.
    pub(crate) async fn open(
        flash: RecordFlash,
        memory: Memory<'static>,
    ) -> Result<(Self, Option<Settings>), ArchiveError> {
        let archive = Archive::open(flash, RECORD_AREA, memory).await?;
        let settings = archive.settings().cloned();
        Ok((Self(Mutex::new(archive)), settings))
    }

    /// Stored records; while one is being written, none are counted.
    pub(crate) fn records(&self) -> u32 {
        self.0.try_lock().map_or(0, |archive| archive.len())
    }

    /// Running number of the next record, when there is room for so many
    /// points.
    pub(crate) async fn prepare(&self, points: usize) -> Result<u32, Refusal> {
        let mut archive = self.lock()?;
        archive.check_room(points).await?;
        Ok(archive.next_id())
    }

    /// See [`Archive::page`].
    pub(crate) async fn page(&self, from: u32) -> Result<RecordPage, Refusal> {
        Ok(self.lock()?.page(from).await?)
    }

    /// See [`Archive::read`].
    pub(crate) async fn read(&self, id: u32, offset: u32) -> Result<RecordPart, Refusal> {
        self.lock()?.read(id, offset).await
    }

    /// See [`Archive::release`].
    pub(crate) async fn release(&self, through: u32) -> Result<(), Refusal> {
        Ok(self.lock()?.release(through).await?)
    }

    /// See [`Archive::store_settings`].
    pub(crate) async fn store_settings(&self, settings: &Settings) -> Result<(), Refusal> {
        Ok(self.lock()?.store_settings(settings).await?)
    }

    /// See [`Archive::log_change`].
    pub(crate) async fn log_change(
        &self,
        identity: &Identity,
        change: &SettingsChange,
    ) -> Result<(), Refusal> {
        let mut archive = self.lock()?;
        let record = archive.draft();
        sign(record, identity);
        record.head.labels = RunLabels {
            unix_time_s: change.unix_time_s,
            operator: change.operator.clone(),
            ..RunLabels::BLANK
        };
        record.settings.clone_from(&change.settings);
        Ok(archive.log_change().await?)
    }

    /// Waits until nothing is being stored, and keeps it so.
    pub(crate) async fn rest(&self) -> impl Sized + '_ {
        self.0.lock().await
    }

    fn lock(&self) -> Result<ArchiveGuard<'_>, Refusal> {
        self.0.try_lock().map_err(|_| Refusal::Busy)
    }
}

/// Stores every run that ends.
#[embassy_executor::task]
pub(crate) async fn store(archive: &'static SharedArchive, identity: &'static Identity) -> ! {
    // What made the board restart belongs to the first record after it.
    let mut incident = identity.incident.clone();
    loop {
        state::RUN_ENDED.wait().await;
        let mut archive = archive.0.lock().await;
        let record = archive.draft();
        sign(record, identity);
        record.settings = state::settings();
        record.incident.clone_from(&incident);
        state::RUN.lock(|run| {
            let run = run.borrow();
            record.head.labels.clone_from(&run.spec.labels);
            record.complete = run.complete;
            record.points.clear();
            // The same capacity: all of them fit.
            let _ = record.points.extend_from_slice(&run.results);
        });
        let complete = record.complete;
        let stored = archive.store().await;
        drop(archive);
        let ended = match stored {
            Ok(()) => {
                incident = None;
                if complete {
                    RunState::Finished
                } else {
                    RunState::Stopped
                }
            }
            Err(error) => {
                defmt::error!("record not stored: {}", defmt::Display2Format(&error));
                RunState::Failed
            }
        };
        state::update_status(|status| status.state = ended);
    }
}

/// Puts down whose record it is.
fn sign(record: &mut Record, identity: &Identity) {
    record.head.instrument_serial.clone_from(&identity.serial);
    record.head.firmware = identity.firmware();
    record.head.sample_rate_hz = crate::board::SAMPLE_RATE_HZ as f32;
}
