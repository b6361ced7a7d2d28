//! The archive that every task and host of the firmware shares.

use crate::board::{RandomSource, RecordFlash, wrong_words_of_records};
use crate::identity::Identity;
use crate::state;
use calib_core::self_test::WrongWords;
use calib_core::stored_list::StoredList;
use calib_firmware::archive::Archive;
use calib_firmware::command::{RecordPage, RecordPart};
use calib_protocol::health::Defect;
use calib_protocol::lists::{KeptList, ListChange};
use calib_protocol::message::{Refusal, SettingsChange};
use calib_protocol::record::{Record, RunLabels};
use calib_protocol::signature::DeviceKey;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::mutex::{Mutex, MutexGuard};

type Lock = Mutex<CriticalSectionRawMutex, Option<Archive<'static, RecordFlash>>>;
pub(crate) type Guard<'a> =
    MutexGuard<'a, CriticalSectionRawMutex, Option<Archive<'static, RecordFlash>>>;

/// The archive behind a lock. Nobody waits for it on behalf of a host: while
/// it is being read at the start, or written, a host hears that the calibrator
/// is busy. One that cannot be read never comes.
pub(crate) struct SharedArchive(Lock, RandomSource);

/// The archive, for as long as it is held.
struct ArchiveGuard<'a>(Guard<'a>);

impl SharedArchive {
    /// Before the record area was read.
    pub(crate) const fn new(random: RandomSource) -> Self {
        Self(Mutex::new(None), random)
    }

    /// Stored records; while one is being written, none are counted.
    pub(crate) fn records(&self) -> u32 {
        let archive = self.0.try_lock().ok();
        archive.map_or(0, |archive| archive.as_ref().map_or(0, Archive::len))
    }

    /// Running number of the next record, when there is room for so many
    /// points.
    pub(crate) async fn prepare(&self, points: usize) -> Result<u32, Refusal> {
        let mut archive = self.lock()?;
        let archive = archive.get()?;
        archive.check_room(points).await?;
        Ok(archive.next_id())
    }

    /// See [`Archive::page`].
    pub(crate) async fn page(&self, from: u32) -> Result<RecordPage, Refusal> {
        Ok(self.lock()?.get()?.page(from).await?)
    }

    /// See [`Archive::read`].
    pub(crate) async fn read(&self, id: u32, offset: u32) -> Result<RecordPart, Refusal> {
        self.lock()?.get()?.read(id, offset).await
    }

    /// See [`Archive::release`].
    pub(crate) async fn release(&self, through: u32) -> Result<(), Refusal> {
        Ok(self.lock()?.get()?.release(through).await?)
    }

    /// See [`Archive::public_key`].
    pub(crate) fn key(&self) -> Result<Option<DeviceKey>, Refusal> {
        Ok(self.lock()?.get()?.public_key())
    }

    /// See [`Archive::make_key`].
    pub(crate) async fn make_key(&self) -> Result<(), Refusal> {
        let mut archive = self.lock()?;
        let archive = archive.get()?;
        let random = self.1.bytes().await.ok_or(Refusal::NoRandomness)?;
        Ok(archive.make_key(&random).await?)
    }

    /// See [`Archive::log_change`].
    pub(crate) async fn log_change(
        &self,
        identity: &Identity,
        change: &SettingsChange,
    ) -> Result<(), Refusal> {
        let mut archive = self.lock()?;
        let archive = archive.get()?;
        let record = archive.draft(&change.settings);
        name(record, identity);
        record.head.labels = RunLabels {
            unix_time_s: change.unix_time_s,
            operator: change.operator.clone(),
            ..RunLabels::BLANK
        };
        Ok(archive.log_change().await?)
    }

    /// The list at this place, from 0.
    pub(crate) fn list(&self, place: u8) -> Result<Option<KeptList>, Refusal> {
        let mut archive = self.lock()?;
        Ok(archive.get()?.list(place))
    }

    /// Looks at the list that a tap of the button measures.
    pub(crate) fn chosen<T>(
        &self,
        look: impl FnOnce(Option<&StoredList>) -> T,
    ) -> Result<T, Refusal> {
        let mut archive = self.lock()?;
        Ok(look(archive.get()?.lists().chosen()))
    }

    /// See [`Archive::change_lists`].
    pub(crate) async fn change_lists(
        &self,
        change: &ListChange,
        held: bool,
    ) -> Result<(), Refusal> {
        let mut archive = self.lock()?;
        let archive = archive.get()?;
        match (change.is_done_in(archive.lists()), held) {
            (true, _) => Ok(()),
            (false, true) => archive.change_lists(change).await,
            (false, false) => Err(Refusal::ButtonNotHeld),
        }
    }

    /// Stored records that cannot be read, and words of the record area whose check bits do not fit.
    pub(crate) async fn look_through(&self) -> Result<(u32, WrongWords), Refusal> {
        let mut archive = self.lock()?;
        let unreadable = archive.get()?.unreadable().await;
        Ok((unreadable, wrong_words_of_records().await))
    }

    /// Waits until nothing is being stored, and keeps it so; the archive is there once it was read.
    pub(crate) async fn hold(&self) -> Guard<'_> {
        self.0.lock().await
    }

    fn lock(&self) -> Result<ArchiveGuard<'_>, Refusal> {
        let archive = self.0.try_lock().map_err(|_| Refusal::Busy)?;
        Ok(ArchiveGuard(archive))
    }
}

impl ArchiveGuard<'_> {
    /// The archive, once it was read.
    fn get(&mut self) -> Result<&mut Archive<'static, RecordFlash>, Refusal> {
        let defects = state::defects();
        self.0.as_mut().ok_or(match defects.has(Defect::Archive) {
            true => Refusal::Degraded(defects),
            false => Refusal::Busy,
        })
    }
}

/// Puts down whose record it is.
pub(crate) fn name(record: &mut Record, identity: &Identity) {
    record.head.instrument_serial.clone_from(&identity.serial);
    record.head.firmware = identity.firmware();
    record.image = identity.image;
    record.head.sample_rate_hz = crate::board::SAMPLE_RATE_HZ as f32;
}
