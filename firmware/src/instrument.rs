//! The calibrator as its hosts see it.

use crate::identity::Identity;
use crate::self_test::{self, SelfTest};
use crate::shared_archive::SharedArchive;
use crate::state::{self, Order, Run};
use crate::update;
use calib_core::conformity::Conformity;
use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_core::point_state::Reason;
use calib_core::points::default_points;
use calib_core::self_test::{Line, MAX_LINES};
use calib_core::settings::Settings;
use calib_core::stored_list::StoredList;
use calib_core::thermometer::may_work_at;
use calib_firmware::command::{Instrument, RecordPage, RecordPart, check_list};
use calib_firmware::lease::Lease;
use calib_firmware::restarts::MINUTE_MS;
use calib_firmware::session::LinkName;
use calib_protocol::capture::CapturePart;
use calib_protocol::frame::PROTOCOL_VERSION;
use calib_protocol::health::{Defect, Health};
use calib_protocol::lists::{KeptList, ListChange};
use calib_protocol::message::{Info, Refusal, Request, RunSpec, RunState, SettingsChange, Status};
use calib_protocol::record::RunLabels;
use calib_protocol::signature::DeviceKey;
use calib_protocol::update::{RunningImage, UpdateStep};
use core::sync::atomic::Ordering;
use embassy_time::{Duration, Instant, Timer, with_timeout};
use heapless::Vec;

/// A host waits this long for settings while the record area is read: a sector that a power cut
/// left half erased is erased in 1 to 2 s first.
const READING_LIMIT: Duration = Duration::from_secs(5);

/// One host's view; all share everything behind it.
#[derive(Clone, Copy)]
pub(crate) struct Calibrator {
    pub(crate) link: LinkName,
    pub(crate) identity: &'static Identity,
    pub(crate) archive: &'static SharedArchive,
}

impl Calibrator {
    /// The host has gone.
    pub(crate) fn leave(&self) {
        state::with_session(|session| session.leave(self.link));
    }

    /// A tap of the button: measures the chosen list, or the default list where none is.
    pub(crate) async fn tap(&mut self) {
        let Err(refusal) = self.start_alone().await else {
            return;
        };
        defmt::warn!("button: {}", defmt::Debug2Format(&refusal));
        let is_chosen = self.archive.chosen(|list| list.is_some()) == Ok(true);
        let impossible = matches!(refusal, Refusal::PointImpossible { .. });
        let stale = is_chosen || impossible || state::conformity().is_some();
        if stale && !state::status().state.is_running() {
            // What the lamps said before was of another device.
            state::set_conformity(Some(Conformity::NotJudgeable));
        }
    }

    async fn start_alone(&mut self) -> Result<(), Refusal> {
        let settings = state::settings();
        let look_through = |points: &[PointSpec]| {
            check_list(points, &settings, crate::board::SAMPLE_RATE_HZ as f32)
                .map(|()| points.len())
        };
        let points = self.archive.chosen(|list| match list {
            // Settings may be others than when it was stored.
            Some(list) => look_through(&list.points),
            None => look_through(&default_points()),
        })??;
        let record_id = self.may_start(points).await?;
        // No await from here on.
        self.archive.chosen(|list| {
            state::RUN.lock(|run| fill(&mut run.borrow_mut(), record_id, list));
        })?;
        // Whoever pressed it is there.
        state::with_lease(|lease, _| *lease = Lease::NONE);
        go()
    }

    /// Whether a run of so many points may begin, and the running number of its record.
    async fn may_start(&self, points: usize) -> Result<u32, Refusal> {
        let defects = state::defects();
        if !defects.is_none() {
            return Err(Refusal::Degraded(defects));
        }
        let record_id = self.archive.prepare(points).await?;
        if state::status().state.is_running() || self_test::is_under_way() {
            return Err(Refusal::Busy);
        }
        if state::TEMPERATURE_C
            .get()
            .is_some_and(|value| !may_work_at(value))
        {
            return Err(Refusal::TemperatureOutOfRange);
        }
        match state::ALIGNED.load(Ordering::Relaxed) {
            true => Ok(record_id),
            false => Err(Refusal::ChannelsNotAligned),
        }
    }
}

/// The run of a tap.
fn fill(run: &mut Run, record_id: u32, list: Option<&StoredList>) {
    run.begin(record_id);
    run.spec.excitation = ExcitationKind::SingleSine;
    let (unix_time_s, reading) = state::time();
    run.clock = reading;
    run.spec.labels = RunLabels {
        unix_time_s,
        ..RunLabels::BLANK
    };
    run.spec.points.clear();
    // A run has room for more points than either list.
    let _ = match list {
        Some(list) => {
            run.list.clone_from(&list.terms);
            run.spec.points.extend_from_slice(&list.points)
        }
        None => run.spec.points.extend_from_slice(&default_points()),
    };
}

/// Longest wait of a stop for an exciter at rest. An order waits for the block in work and for its evaluation, 27 ms;
/// a host says NOT STOPPED after 200.
const REST_LIMIT: Duration = Duration::from_millis(100);

/// Has the run begin that was put down.
fn go() -> Result<(), Refusal> {
    let points = state::RUN.lock(|run| run.borrow().spec.points.len() as u16);
    state::set_conformity(None);
    state::update_status(|status| {
        // Level and block of the run before would be shown as this one's.
        *status = Status {
            state: RunState::Settling,
            points,
            overruns: status.overruns,
            samples: status.samples,
            ..Status::IDLE
        };
    });
    state::ORDERS
        .try_send(Order::Start)
        .map_err(|_| Refusal::Busy)
}

impl Instrument for Calibrator {
    fn admit(&mut self, request: &Request) -> Result<(), Refusal> {
        let now_ms = Instant::now().as_millis();
        state::with_session(|session| session.admit(self.link, request, now_ms))
    }

    fn info(&mut self) -> Info {
        let identity = self.identity;
        Info {
            protocol_version: PROTOCOL_VERSION,
            firmware_version: identity.version.clone(),
            git_hash: identity.git_hash.clone(),
            serial: identity.serial.clone(),
            sample_rate_hz: crate::board::SAMPLE_RATE_HZ as f32,
            reset_cause: identity.reset_cause,
            last_panic: identity.last_panic.clone(),
            records: self.archive.records(),
            uptime_ms: Instant::now().as_millis(),
            stack_unused_bytes: crate::board::unused_stack_bytes(),
            instrument_temperature_c: state::TEMPERATURE_C.get(),
        }
    }

    fn health(&mut self) -> Health {
        // What was a minute ago has nothing to do with what is.
        let has_lived = Instant::now().as_millis() >= MINUTE_MS;
        Health {
            deadlines: crate::timing::deadlines(crate::board::CORE_MHZ),
            timebase_ppm: state::TIMEBASE_PPM.get(),
            option_bytes: Some(crate::board::option_bytes()),
            defects: state::defects(),
            restarts: match has_lived && state::defects().is_none() {
                true => Vec::new(),
                false => self.identity.restarts.clone(),
            },
        }
    }

    fn status(&mut self) -> Status {
        state::status()
    }

    fn point(&mut self, index: u16) -> Option<PointResult> {
        state::RUN.lock(|run| run.borrow().results.get(usize::from(index)).copied())
    }

    async fn start(&mut self, spec: RunSpec) -> Result<u32, Refusal> {
        self.tell_time(spec.labels.unix_time_s);
        let record_id = self.may_start(spec.points.len()).await?;
        // No await from here on: the other link cannot come in between.
        state::RUN.lock(|run| {
            let mut run = run.borrow_mut();
            run.begin(record_id);
            run.spec = spec;
        });
        let lease_s = state::settings().lease_s;
        state::with_lease(|lease, now_ms| *lease = Lease::begin(lease_s, now_ms));
        go()?;
        Ok(record_id)
    }

    async fn stop(&mut self) -> Result<(), Refusal> {
        // Nobody would take the order; the exciter is at rest.
        if !state::MEASURES.load(Ordering::Relaxed) {
            return Ok(());
        }
        let is_driven = || state::DRIVEN.load(Ordering::Relaxed);
        let comes_to_rest = async {
            state::ORDERS.send(Order::Stop(Reason::Stopped)).await;
            let is_obeyed = || state::ORDERS.is_empty() && !state::PLAYS.load(Ordering::Relaxed);
            while !is_obeyed() || is_driven() {
                Timer::after_millis(1).await;
            }
        };
        let rests = with_timeout(REST_LIMIT, comes_to_rest).await;
        // Without samples nobody takes the order, and the drive has gone silent by itself.
        match rests.is_ok() || !is_driven() {
            true => Ok(()),
            false => Err(Refusal::StillDriven),
        }
    }

    async fn stop_run(&mut self, record_id: u32) -> Result<(), Refusal> {
        // What is no more needs no stop, and what came after it is another run.
        match state::RUN.lock(|run| run.borrow().record_id) == record_id {
            true => self.stop().await,
            false => Ok(()),
        }
    }

    async fn records(&mut self, from: u32) -> Result<RecordPage, Refusal> {
        self.archive.page(from).await
    }

    async fn read_record(&mut self, id: u32, offset: u32) -> Result<RecordPart, Refusal> {
        self.archive.read(id, offset).await
    }

    async fn release(&mut self, through: u32) -> Result<(), Refusal> {
        if state::status().state.is_running() {
            return Err(Refusal::Busy);
        }
        self.archive.release(through).await
    }

    async fn ready(&mut self) -> Result<(), Refusal> {
        let read = async {
            while !state::STORED_READ.load(Ordering::Relaxed) {
                Timer::after_millis(10).await;
            }
        };
        with_timeout(READING_LIMIT, read)
            .await
            .map_err(|_| Refusal::Busy)
    }

    fn settings(&mut self) -> Settings {
        state::settings()
    }

    async fn self_test(&mut self) -> Result<Vec<Line, MAX_LINES>, Refusal> {
        if state::status().state.is_running() {
            return Err(Refusal::Busy);
        }
        let test = SelfTest::begin().ok_or(Refusal::Busy)?;
        let records = match self.archive.look_through().await {
            Err(Refusal::Busy) => return Err(Refusal::Busy),
            looked => looked.ok(),
        };
        let health = self.health();
        let identity = self.identity;
        let panicked = identity.last_panic.is_some();
        Ok(test
            .carry_out(records, &health, identity.reset_cause, panicked)
            .await)
    }

    fn button_held(&mut self) -> bool {
        let held = state::BUTTON_HELD.load(Ordering::Relaxed);
        state::BUTTON_USED.fetch_or(held, Ordering::Relaxed);
        held
    }

    async fn key(&mut self) -> Result<Option<DeviceKey>, Refusal> {
        self.archive.key()
    }

    async fn make_key(&mut self) -> Result<(), Refusal> {
        if state::status().state.is_running() {
            return Err(Refusal::Busy);
        }
        self.archive.make_key().await
    }

    async fn change_settings(&mut self, change: &SettingsChange) -> Result<(), Refusal> {
        if state::status().state.is_running() {
            return Err(Refusal::Busy);
        }
        self.archive.log_change(self.identity, change).await?;
        take_settings(&change.settings);
        Ok(())
    }

    fn image(&mut self) -> Option<RunningImage> {
        update::image(self.identity.image)
    }

    fn update(&mut self, step: &UpdateStep, older_allowed: bool) -> Result<(), Refusal> {
        // It holds the core up, and with it the count.
        state::with_clock(|clock, _| clock.forget());
        update::carry_out(step, older_allowed)
    }

    async fn list(&mut self, place: u8) -> Result<Option<KeptList>, Refusal> {
        self.archive.list(place)
    }

    async fn change_lists(&mut self, change: &ListChange, held: bool) -> Result<(), Refusal> {
        if state::status().state.is_running() {
            return Err(Refusal::Busy);
        }
        self.archive.change_lists(change, held).await
    }

    fn tell_time(&mut self, unix_time_s: u64) {
        state::with_clock(|clock, now_ms| clock.tell(unix_time_s, now_ms));
    }

    fn capture(&mut self, pairs: u16) -> Result<(), Refusal> {
        if !state::MEASURES.load(Ordering::Relaxed) {
            return Err(Refusal::Degraded(state::defects()));
        }
        state::with_capture(|capture| capture.arm(pairs))
    }

    fn read_capture(&mut self, offset: u16) -> Result<CapturePart, Refusal> {
        state::with_capture(|capture| capture.part(offset))
    }
}

/// Settings that are stored are in force, and those that could not be read are of
/// no interest any more.
fn take_settings(settings: &Settings) {
    state::take_settings(settings.clone());
    state::note_defect(Defect::Settings, false);
}
