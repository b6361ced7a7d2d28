//! State that every page sees.

use super::waveforms::Waveforms;
use calib_output::{InfoView, PointView, SetPoint, StatusView};
use schemars::JsonSchema;
use serde::Serialize;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::watch;

/// The link to the calibrator.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Link {
    /// Nobody asked for one.
    #[default]
    None,
    /// It works.
    Connected,
    /// It broke; it is being tried again.
    Lost,
}

/// The running or last run.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct RunView {
    /// Running number among the runs of this server.
    pub number: u32,
    /// True until its end is known.
    pub running: bool,
    /// How it ended, in words; empty before.
    pub ended: String,
    /// The list that is measured.
    pub list: Vec<SetPoint>,
    /// Where it stands.
    pub status: Option<StatusView>,
    /// Work done, 0 to 1.
    pub fraction: f64,
    /// Time left by this computer's clock, s; none at the beginning.
    pub left_s: Option<f64>,
    /// Results, in the order of the list.
    pub points: Vec<PointView>,
    /// Serial number of the device under test.
    pub dut_serial: String,
    /// Running number of the record in the calibrator.
    pub record_id: Option<u32>,
    /// Number of the record in the logbook.
    pub logbook_record: Option<i64>,
}

/// Everything a page shows.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct Snapshot {
    /// The link.
    pub link: Link,
    /// The calibrator's address, as typed.
    pub device: String,
    /// Who it is.
    pub info: Option<InfoView>,
    /// Last error, with the way out.
    pub trouble: Option<String>,
    /// The running or last run.
    pub run: Option<RunView>,
    /// Running number of the latest waveforms; 0 before any.
    pub waveforms: u32,
}

/// A snapshot that many look at; each change is told to all.
#[derive(Clone)]
pub(super) struct Shared {
    snapshot: Arc<Mutex<Snapshot>>,
    version: Arc<watch::Sender<u64>>,
    /// Stored form of the last run's record.
    record: Arc<Mutex<Option<Vec<u8>>>>,
    /// Too large to go with every view.
    waveforms: Arc<Mutex<Waveforms>>,
}

impl Shared {
    pub(super) fn new() -> Self {
        Self {
            snapshot: Arc::default(),
            version: Arc::new(watch::Sender::new(0)),
            record: Arc::default(),
            waveforms: Arc::default(),
        }
    }

    /// Changes the snapshot and tells everybody.
    pub(super) fn change(&self, change: impl FnOnce(&mut Snapshot)) {
        change(&mut self.lock());
        self.version.send_modify(|version| *version += 1);
    }

    /// Changes the run, if there is one.
    pub(super) fn change_run(&self, change: impl FnOnce(&mut RunView)) {
        self.change(|snapshot| {
            if let Some(run) = &mut snapshot.run {
                change(run);
            }
        });
    }

    pub(super) fn snapshot(&self) -> Snapshot {
        self.lock().clone()
    }

    /// Samples per second of the calibrator; 0 without one.
    pub(super) fn sample_rate_hz(&self) -> f32 {
        let snapshot = self.lock();
        snapshot
            .info
            .as_ref()
            .map_or(0.0, |info| info.sample_rate_hz)
    }

    pub(super) fn changes(&self) -> watch::Receiver<u64> {
        self.version.subscribe()
    }

    pub(super) fn keep_record(&self, bytes: Option<Vec<u8>>) {
        *self.record.lock().unwrap_or_else(PoisonError::into_inner) = bytes;
    }

    pub(super) fn record(&self) -> Option<Vec<u8>> {
        self.record
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .clone()
    }

    /// Keeps waveforms under the next number, and tells everybody that they are there.
    pub(super) fn keep_waveforms(&self, mut new: Waveforms) {
        let mut kept = self
            .waveforms
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        new.number = kept.number + 1;
        let number = new.number;
        *kept = new;
        drop(kept);
        self.change(|snapshot| snapshot.waveforms = number);
    }

    pub(super) fn waveforms(&self) -> Waveforms {
        let kept = self.waveforms.lock();
        kept.unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn lock(&self) -> MutexGuard<'_, Snapshot> {
        self.snapshot.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
