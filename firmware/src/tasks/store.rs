//! Records out: from an ended run to the archive.

use crate::board::{RECORD_AREA, RecordFlash};
use crate::identity::Identity;
use crate::state;
use calib_core::settings::{Example, InputScale, Limits, Method, ReferenceCalibration, Settings};
use calib_firmware::archive::{Archive, ArchiveError, Memory};
use calib_firmware::command::{RecordPage, RecordPart};
use calib_protocol::message::{Refusal, RunSpec, RunState};
use calib_protocol::record::Record;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::mutex::Mutex;
use heapless::{String, Vec};
use static_cell::ConstStaticCell;

/// The archive behind a lock. Nobody waits for it on behalf of a host: while
/// it is being written, a host hears that the calibrator is busy.
pub(crate) struct SharedArchive(Mutex<CriticalSectionRawMutex, Archive<RecordFlash>>);

impl SharedArchive {
    /// Reads the record area; returns the archive and the stored settings.
    pub(crate) async fn open(
        flash: RecordFlash,
        memory: Memory,
    ) -> Result<(Self, Option<Settings>), ArchiveError> {
        let (archive, settings) = Archive::open(flash, RECORD_AREA, memory).await?;
        Ok((Self(Mutex::new(archive)), settings))
    }

    /// Stored records; while one is being written, without it.
    pub(crate) fn records(&self) -> u32 {
        match self.0.try_lock() {
            Ok(archive) => archive.len(),
            Err(_) => 0,
        }
    }

    /// Running number of the next record, when there is room for this run.
    pub(crate) async fn prepare(&self, spec: &RunSpec) -> Result<u32, Refusal> {
        let mut archive = self.0.try_lock().map_err(|_| Refusal::Busy)?;
        archive.check_room(longest_record(spec)).await?;
        Ok(archive.next_id())
    }

    /// See [`Archive::page`].
    pub(crate) fn page(&self, from: u32) -> Result<RecordPage, Refusal> {
        let archive = self.0.try_lock().map_err(|_| Refusal::Busy)?;
        Ok(archive.page(from))
    }

    /// See [`Archive::read`].
    pub(crate) async fn read(&self, id: u32, offset: u32) -> Result<RecordPart, Refusal> {
        let mut archive = self.0.try_lock().map_err(|_| Refusal::Busy)?;
        archive.read(id, offset).await
    }

    /// See [`Archive::store_settings`].
    pub(crate) async fn store_settings(&self, settings: &Settings) -> Result<(), Refusal> {
        let mut archive = self.0.try_lock().map_err(|_| Refusal::Busy)?;
        Ok(archive.store_settings(settings).await?)
    }
}

/// Bytes a record of this run can take: each point at most 110, and the
/// fullest settings and labels.
fn longest_record(spec: &RunSpec) -> usize {
    110 * spec.points.len() + 2048
}

/// Stores every run that ends.
#[embassy_executor::task]
pub(crate) async fn store(archive: &'static SharedArchive, identity: &'static Identity) -> ! {
    // Some 20 KB: too large for a stack.
    static RECORD: ConstStaticCell<Record> = ConstStaticCell::new(empty());
    let record = RECORD.take();
    record.instrument_serial = identity.serial.clone();
    record.firmware = identity.firmware();
    loop {
        state::RUN_ENDED.wait().await;
        let mut archive = archive.0.lock().await;
        record.id = archive.next_id();
        record.settings = state::settings();
        state::RUN.lock(|run| {
            let run = run.borrow();
            record.labels.clone_from(&run.spec.labels);
            record.complete = run.complete;
            record.points.clear();
            // The same capacity: all of them fit.
            let _ = record.points.extend_from_slice(&run.results);
        });
        let ended = match archive.store(record).await {
            Ok(()) if record.complete => RunState::Finished,
            Ok(()) => RunState::Stopped,
            Err(error) => {
                defmt::error!("record not stored: {}", defmt::Display2Format(&error));
                RunState::Failed
            }
        };
        drop(archive);
        state::update_status(|status| status.state = ended);
    }
}

/// A record of nothing.
const fn empty() -> Record {
    Record {
        id: 0,
        instrument_serial: String::new(),
        firmware: String::new(),
        sample_rate_hz: crate::board::SAMPLE_RATE_HZ as f32,
        labels: state::NO_LABELS,
        settings: Settings {
            method: Method::Calibrator,
            example: Example::Example2,
            reference: ReferenceCalibration {
                serial: String::new(),
                certificate: String::new(),
                calibrated_day: 0,
                due_day: 0,
                points: Vec::new(),
            },
            reference_input: InputScale { volt_per_code: 0.0 },
            dut_input: InputScale { volt_per_code: 0.0 },
            drive_full_scale_peak_v: 0.0,
            limits: Limits {
                drive_peak_v: 0.0,
                acceleration_peak_ms2: 0.0,
                velocity_peak_ms: 0.0,
                displacement_peak_m: 0.0,
            },
            blocks: 0,
            influences: Vec::new(),
        },
        complete: false,
        points: Vec::new(),
    }
}
