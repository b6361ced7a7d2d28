//! Records out: from an ended run to the archive.

use crate::board::{RECORD_AREA, RecordFlash, axi_static};
use crate::identity::Identity;
use crate::shared_archive::{SharedArchive, name};
use crate::{retained, state};
use calib_core::closing::Closing;
use calib_core::conformity::judge;
use calib_core::stored_list::StoredLists;
use calib_firmware::archive::{Archive, Directory, LastAccess, MAX_ITEM, Memory};
use calib_firmware::restarts::{LeftOut, Reached};
use calib_protocol::health::Defect;
use calib_protocol::message::RunState;
use calib_protocol::record::Record;
use core::sync::atomic::Ordering;
use embassy_time::{Duration, with_timeout};

/// Longest time to read and repair the record area: of its eight sectors a power
/// cut leaves two at most to be erased, each in 4 s (DS12110 Rev 11, table 140).
const OPENING_LIMIT: Duration = Duration::from_secs(20);

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
    let mut place = shared.hold().await;
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
        let mut archive = archive.hold().await;
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
