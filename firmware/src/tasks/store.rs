//! Records out: from an ended run to the archive.

use crate::board::{RECORD_AREA, RandomSource, RecordFlash, axi_static, wrong_words_of_records};
use crate::identity::Identity;
use crate::{retained, state};
use calib_core::closing::Closing;
use calib_core::conformity::judge;
use calib_core::self_test::WrongWords;
use calib_core::stored_list::{StoredList, StoredLists};
use calib_firmware::archive::{Archive, Directory, LastAccess, MAX_ITEM, Memory};
use calib_firmware::command::{RecordPage, RecordPart};
use calib_firmware::restarts::{LeftOut, Reached};
use calib_protocol::health::Defect;
use calib_protocol::lists::{KeptList, ListChange};
use calib_protocol::message::{Refusal, RunState, SettingsChange};
use calib_protocol::record::{Record, RunLabels};
use calib_protocol::signature::DeviceKey;
use core::sync::atomic::Ordering;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::mutex::{Mutex, MutexGuard};
use embassy_time::{Duration, with_timeout};

/// Longest time to read and repair the record area: of its eight sectors a power
/// cut leaves two at most to be erased, each in 4 s (DS12110 Rev 11, table 140).
const OPENING_LIMIT: Duration = Duration::from_secs(20);

type Lock = Mutex<CriticalSectionRawMutex, Option<Archive<'static, RecordFlash>>>;
type Guard<'a> = MutexGuard<'a, CriticalSectionRawMutex, Option<Archive<'static, RecordFlash>>>;

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

    /// Waits until nothing is being stored, and keeps it so.
    pub(crate) async fn rest(&self) -> impl Sized + '_ {
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

/// Reads the record area and takes its settings into force; whatever becomes of
/// it, the links are up.
async fn open(shared: &'static SharedArchive, flash: RecordFlash) {
    axi_static!(DIRECTORY: Directory);
    axi_static!(SCRATCH: [u8; MAX_ITEM]);
    axi_static!(RECORD: Record);
    axi_static!(LISTS: StoredLists);
    axi_static!(LISTS_BEFORE: StoredLists);
    static LAST_ACCESS: LastAccess = LastAccess::new();
    let memory = Memory {
        directory: DIRECTORY.take(),
        scratch: SCRATCH.take(),
        record: RECORD.take(),
        lists: LISTS.take(),
        lists_before: LISTS_BEFORE.take(),
        last_access: &LAST_ACCESS,
        factory: state::factory_settings,
    };
    let mut place = shared.0.lock().await;
    let opening = Archive::open(flash, RECORD_AREA, memory);
    let opened = with_timeout(OPENING_LIMIT, opening).await;
    let Ok(Ok(archive)) = opened else {
        return state::note_defect(Defect::Archive, true);
    };
    defmt::info!("{} records", archive.len());
    if let Some(settings) = archive.settings() {
        state::take_settings(settings.clone());
    }
    state::note_defect(Defect::Settings, archive.settings_are_unreadable());
    *place = Some(archive);
}

/// Reads the record area, and stores every run that ends.
#[embassy_executor::task]
pub(crate) async fn store(
    archive: &'static SharedArchive,
    flash: RecordFlash,
    identity: &'static Identity,
) -> ! {
    match identity.left_out.has(LeftOut::ARCHIVE) {
        true => state::note_defect(Defect::Archive, true),
        false => {
            retained::enter(Reached::Archive);
            open(archive, flash).await;
        }
    }
    state::STORED_READ.store(true, Ordering::Relaxed);
    retained::enter(Reached::Running);
    // What made the board restart belongs to the first record after it.
    let mut incident = identity.incident.clone();
    loop {
        state::RUN_ENDED.wait().await;
        let mut archive = archive.0.lock().await;
        // No run is started without one.
        let Some(archive) = archive.as_mut() else {
            continue;
        };
        let record = archive.draft(&state::settings());
        name(record, identity);
        record.incident.clone_from(&incident);
        state::RUN.lock(|run| {
            let run = run.borrow();
            record.head.labels.clone_from(&run.spec.labels);
            record.complete = run.complete;
            record.list.clone_from(&run.list);
            record.clock = run.clock;
            record.closing = run.closing;
            record.points.clear();
            // The same capacity: all of them fit.
            let _ = record.points.extend_from_slice(&run.results);
            record.untried.clear();
            let untried = run.spec.points.get(run.results.len()..);
            let _ = record
                .untried
                .extend_from_slice(untried.unwrap_or_default());
        });
        // A stop may come behind the last point: every one was tried then, and the first could not be repeated.
        let stopped = match record.closing {
            Closing::Refused(reason) => reason.ends_run(),
            Closing::None | Closing::Changed(_) => !record.complete,
        };
        let judged = (!record.list.is_none()).then(|| {
            let complete = record.complete;
            judge(&record.list, &record.points, complete, &record.closing)
        });
        let stored = archive.store().await;
        let ended = match stored {
            Ok(()) => {
                incident = None;
                state::set_conformity(judged);
                match stopped {
                    true => RunState::Stopped,
                    false => RunState::Finished,
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
fn name(record: &mut Record, identity: &Identity) {
    record.head.instrument_serial.clone_from(&identity.serial);
    record.head.firmware = identity.firmware();
    record.image = identity.image;
    record.head.sample_rate_hz = crate::board::SAMPLE_RATE_HZ as f32;
}
