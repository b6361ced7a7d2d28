//! State that every page sees.

use super::stops::{NotStopped, StopState, StopView};
use super::waveforms::Waveforms;
use crate::in_unit::StatedPoint;
use crate::refusals::Refused;
use calib_certificate::SensorKind;
use calib_core::point::PointSpec;
use calib_link::StopSwitch;
use calib_output::{InfoView, SetPoint, StatusView};
use calib_protocol::record::RunLabels;
use schemars::JsonSchema;
use serde::Serialize;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::watch;

/// The link to the calibrator.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Connection {
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
    pub points: Vec<StatedPoint>,
    /// Unit of `in_unit` of the points.
    pub unit: &'static str,
    /// Points of the list that cannot be measured, and why: nothing was moved.
    pub impossible: Vec<Refused>,
    /// Serial number of the device under test.
    pub dut_serial: String,
    /// Running number of the record in the calibrator.
    pub record_id: Option<u32>,
    /// Number of the record in the logbook.
    pub logbook_record: Option<i64>,
    /// The measured quantity, and how it is stated.
    #[serde(skip)]
    pub(super) measured: Measured,
}

/// The device under test of a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Measured {
    pub(super) labels: RunLabels,
    pub(super) kind: SensorKind,
    /// Results of the run that this one completes.
    pub(super) kept: Vec<StatedPoint>,
}

impl RunView {
    /// Points that have one.
    pub(super) fn valid(&self) -> Vec<StatedPoint> {
        let valid = self.points.iter().filter(|point| point.measured.is_valid());
        valid.cloned().collect()
    }

    /// Points of the list that have no valid result: refused, or never tried.
    pub(super) fn without_result(&self) -> Vec<PointSpec> {
        let is_valid = |set: &&SetPoint| {
            let of = |point: &StatedPoint| point.measured.is_valid() && point.measured.set == **set;
            !self.points.iter().any(of)
        };
        self.list
            .iter()
            .filter(is_valid)
            .map(PointSpec::from)
            .collect()
    }
}

/// A list the calibrator keeps for a tap of its button.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct KeptListView {
    /// Its name.
    pub name: String,
    /// A tap of the button measures it.
    pub chosen: bool,
}

/// Everything a page shows.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct Snapshot {
    /// The link.
    pub link: Connection,
    /// The calibrator's address, as typed.
    pub device: String,
    /// Who it is.
    pub info: Option<InfoView>,
    /// The first 64 bits of its public key, as people compare them; none where its records are not signed.
    pub key: Option<String>,
    /// The lists it keeps, as they were when the link was opened.
    pub lists: Vec<KeptListView>,
    /// Last error, with the way out.
    pub trouble: Option<String>,
    /// The running or last run.
    pub run: Option<RunView>,
    /// Running number of the latest waveforms; 0 before any.
    pub waveforms: u32,
    /// The latest stop.
    pub stop: Option<StopView>,
    /// Who signs the certificates that are given out; none where nobody does.
    pub signer: Option<String>,
    /// Entries of the logbook that nobody has signed, as of the last certificate.
    pub unsigned_entries: Option<i64>,
    /// Port on which this server takes nothing but stops.
    pub stop_port: u16,
}

/// A snapshot that many look at; each change is told to all.
#[derive(Clone)]
pub(super) struct Shared {
    snapshot: Arc<Mutex<Snapshot>>,
    version: Arc<watch::Sender<u64>>,
    /// Stored forms of the last run's record, and of what it completes, oldest first.
    records: Arc<Mutex<Vec<Vec<u8>>>>,
    /// Too large to go with every view.
    waveforms: Arc<Mutex<Waveforms>>,
}

impl Shared {
    pub(super) fn new() -> Self {
        Self {
            snapshot: Arc::default(),
            version: Arc::new(watch::Sender::new(0)),
            records: Arc::default(),
            waveforms: Arc::default(),
        }
    }

    /// Changes the snapshot and tells everybody.
    pub(super) fn change(&self, change: impl FnOnce(&mut Snapshot)) {
        change(&mut self.lock());
        self.tell();
    }

    fn tell(&self) {
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

    /// Takes a run under the next number, unless one is taken already. One that completes the last keeps its record.
    pub(super) fn accept_run(&self, mut new: RunView, completes: bool) -> Option<u32> {
        let mut snapshot = self.lock();
        let before = snapshot.run.as_ref();
        if before.is_some_and(|run| run.running) {
            return None;
        }
        new.number = before.map_or(0, |run| run.number) + 1;
        let number = new.number;
        snapshot.run = Some(new);
        snapshot.trouble = None;
        drop(snapshot);
        if !completes {
            self.lock_records().clear();
        }
        self.tell();
        Some(number)
    }

    /// Ends a run whose list holds points that cannot be measured.
    pub(super) fn refuse_list(&self, impossible: Vec<Refused>) {
        self.change_run(|run| run.impossible = impossible);
        self.not_begun("nothing was moved: the list holds points that cannot be measured");
    }

    /// Ends a run that never began.
    pub(super) fn not_begun(&self, why: &str) {
        self.change_run(|run| {
            run.running = false;
            run.ended = why.to_owned();
        });
    }

    pub(super) fn is_running(&self) -> bool {
        self.lock().run.as_ref().is_some_and(|run| run.running)
    }

    /// Counts a stop on the switch; which run it is for is decided at this moment.
    pub(super) fn ask_stop(&self, of: Option<u32>, switch: &StopSwitch) -> Result<u64, NotStopped> {
        let mut snapshot = self.lock();
        let running = snapshot.run.as_ref().filter(|run| run.running);
        let running = running.map_or(0, |run| run.number);
        match of {
            Some(of) if running != 0 && of != running => {
                return Err(NotStopped::Late { of, running });
            }
            _ => {}
        }
        let number = switch.ask();
        snapshot.stop = Some(StopView {
            number,
            run: running,
            state: StopState::Asked,
            after_s: None,
        });
        drop(snapshot);
        self.tell();
        Ok(number)
    }

    /// Whether a stop was asked for that is for this run.
    pub(super) fn is_stopped(&self, run: u32) -> bool {
        self.lock()
            .stop
            .as_ref()
            .is_some_and(|stop| stop.run == run)
    }

    pub(super) fn is_latest_stop(&self, number: u64) -> bool {
        let snapshot = self.lock();
        snapshot
            .stop
            .as_ref()
            .is_some_and(|stop| stop.number == number)
    }

    /// Tells what became of a stop, if it is the latest.
    pub(super) fn note_stop(&self, number: u64, state: StopState, after_s: Option<f64>) {
        self.change(|snapshot| {
            let latest = snapshot.stop.as_mut().filter(|stop| stop.number == number);
            if let Some(stop) = latest {
                (stop.state, stop.after_s) = (state, after_s);
            }
        });
    }

    /// Says under which number the logbook has a run.
    pub(super) fn note_logbook_record(&self, run: u32, id: i64) {
        self.change(|snapshot| {
            if let Some(of) = snapshot.run.as_mut().filter(|of| of.number == run) {
                of.logbook_record = Some(id);
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

    pub(super) fn keep_record(&self, bytes: Vec<u8>) {
        self.lock_records().push(bytes);
    }

    /// Records of the last run, oldest first; none before one has ended.
    pub(super) fn records(&self) -> Vec<Vec<u8>> {
        self.lock_records().clone()
    }

    fn lock_records(&self) -> MutexGuard<'_, Vec<Vec<u8>>> {
        self.records.lock().unwrap_or_else(PoisonError::into_inner)
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
