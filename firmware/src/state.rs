//! State the tasks share: short copies under a critical section.

use crate::board::{CONVERTERS, promise};
use calib_core::closing::Closing;
use calib_core::conformity::Conformity;
use calib_core::point::{ExcitationKind, PointResult};
use calib_core::point_state::Reason;
use calib_core::settings::Settings;
use calib_core::stored_list::ListTerms;
use calib_firmware::capture::Capture;
use calib_firmware::clock::{CRYSTAL_PPM, Clock, INTERNAL_PPM};
use calib_firmware::lease::Lease;
use calib_firmware::session::Session;
use calib_protocol::clock::ClockReading;
use calib_protocol::health::{Defect, Defects};
use calib_protocol::message::{RunSpec, Status};
use calib_protocol::record::{MAX_POINTS, RunLabels};
use core::cell::{Cell, RefCell};
use core::sync::atomic::{AtomicBool, AtomicU32};
use embassy_sync::blocking_mutex::CriticalSectionMutex;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::channel::Channel;
use embassy_sync::signal::Signal;
use embassy_time::Instant;
use heapless::Vec;

/// Looks at what tasks share, and changes it, in one critical section.
fn look_at<S: Copy, T>(
    shared: &CriticalSectionMutex<Cell<S>>,
    look: impl FnOnce(&mut S) -> T,
) -> T {
    shared.lock(|cell| {
        let mut state = cell.get();
        let result = look(&mut state);
        cell.set(state);
        result
    })
}

static STATUS: CriticalSectionMutex<Cell<Status>> =
    CriticalSectionMutex::new(Cell::new(Status::IDLE));

/// A copy of the status.
pub(crate) fn status() -> Status {
    STATUS.lock(Cell::get)
}

/// Changes the status.
pub(crate) fn update_status(change: impl FnOnce(&mut Status)) {
    look_at(&STATUS, change);
}

static DEFECTS: CriticalSectionMutex<Cell<Defects>> =
    CriticalSectionMutex::new(Cell::new(Defects::NONE));

/// Defects of the instrument.
pub(crate) fn defects() -> Defects {
    DEFECTS.lock(Cell::get)
}

/// Something does not work from now on, or works again.
pub(crate) fn note_defect(defect: Defect, is_there: bool) {
    if is_there {
        defmt::error!("degraded: {=str}", defect.text());
    }
    DEFECTS.lock(|defects| {
        let others = defects.get().without(defect);
        defects.set(match is_there {
            true => others.with(defect),
            false => others,
        });
    });
}

static CONFORMITY: CriticalSectionMutex<Cell<Option<Conformity>>> =
    CriticalSectionMutex::new(Cell::new(None));

/// Result of the chosen list, since a tap of the button measured it; none for any other run.
pub(crate) fn conformity() -> Option<Conformity> {
    CONFORMITY.lock(Cell::get)
}

/// Another run begins, or one was judged.
pub(crate) fn set_conformity(conformity: Option<Conformity>) {
    CONFORMITY.lock(|cell| cell.set(conformity));
}

static LEASE: CriticalSectionMutex<Cell<Lease>> = CriticalSectionMutex::new(Cell::new(Lease::NONE));

/// Looks at the lease of the run in work, and changes it; `now_ms` counts from the start.
pub(crate) fn with_lease<T>(look: impl FnOnce(&mut Lease, u32) -> T) -> T {
    let now_ms = Instant::now().as_millis() as u32;
    look_at(&LEASE, |lease| look(lease, now_ms))
}

static CLOCK: CriticalSectionMutex<Cell<Clock>> =
    CriticalSectionMutex::new(Cell::new(Clock::UNKNOWN));

/// Looks at the time of day, and changes it; `now_ms` counts from the start.
pub(crate) fn with_clock<T>(look: impl FnOnce(&mut Clock, u64) -> T) -> T {
    let now_ms = Instant::now().as_millis();
    look_at(&CLOCK, |clock| look(clock, now_ms))
}

/// Seconds since 1970-01-01 UTC and where they come from; 0 and nothing where nobody told the time.
pub(crate) fn time() -> (u64, ClockReading) {
    let ppm = match defects().has(Defect::Clock) {
        true => INTERNAL_PPM,
        false => CRYSTAL_PPM,
    };
    with_clock(|clock, now_ms| clock.read(now_ms, ppm))
}

static SESSION: CriticalSectionMutex<Cell<Session>> =
    CriticalSectionMutex::new(Cell::new(Session::free()));

/// Looks at the session, and changes it.
pub(crate) fn with_session<T>(look: impl FnOnce(&mut Session) -> T) -> T {
    look_at(&SESSION, look)
}

/// The running or last run.
pub(crate) struct Run {
    /// The request.
    pub(crate) spec: RunSpec,
    /// Results so far, in order.
    pub(crate) results: Vec<PointResult, MAX_POINTS>,
    /// Every point was attempted.
    pub(crate) complete: bool,
    /// Outcome of repeating the first valid point at the end.
    pub(crate) closing: Closing,
    /// Running number its record has or will have.
    pub(crate) record_id: u32,
    /// The list a tap of the button chose; none where a host began it.
    pub(crate) list: ListTerms,
    /// Where its time comes from, if no host began it.
    pub(crate) clock: ClockReading,
}

impl Run {
    /// Before the first.
    const NONE: Self = Self {
        spec: RunSpec {
            points: Vec::new(),
            excitation: ExcitationKind::SingleSine,
            labels: RunLabels::BLANK,
        },
        results: Vec::new(),
        complete: false,
        closing: Closing::None,
        record_id: 0,
        list: ListTerms::NONE,
        clock: ClockReading::NONE,
    };

    /// Begins anew, with points and list still to come.
    pub(crate) fn begin(&mut self, record_id: u32) {
        self.results.clear();
        self.complete = false;
        self.closing = Closing::None;
        self.record_id = record_id;
        self.list = ListTerms::NONE;
        self.clock = ClockReading::NONE;
    }
}

/// The running or last run.
// Note(unsafe): in AXI SRAM, for the stack needs the room. The section is
// cleared before the first task runs, and this value is all zero: empty
// vectors and strings, false, no temperature.
#[unsafe(link_section = ".axisram")]
pub(crate) static RUN: CriticalSectionMutex<RefCell<Run>> =
    CriticalSectionMutex::new(RefCell::new(Run::NONE));
promise!(
    CriticalSectionMutex<RefCell<Run>>,
    CriticalSectionMutex::new(RefCell::new(Run::NONE))
);

/// The sample pairs a host asked for.
// Note(unsafe): in AXI SRAM and all zero, as the run.
#[unsafe(link_section = ".axisram")]
static CAPTURE: CriticalSectionMutex<RefCell<Capture>> =
    CriticalSectionMutex::new(RefCell::new(Capture::new()));
promise!(
    CriticalSectionMutex<RefCell<Capture>>,
    CriticalSectionMutex::new(RefCell::new(Capture::new()))
);

/// Looks at the capture, and changes it. The longest work under the lock is to
/// copy a block of 500 words, some microseconds, where blocks take 10 ms.
pub(crate) fn with_capture<T>(look: impl FnOnce(&mut Capture) -> T) -> T {
    CAPTURE.lock(|capture| look(&mut capture.borrow_mut()))
}

/// Orders to the measuring task.
#[derive(Clone, Copy, Debug, PartialEq, Eq, defmt::Format)]
pub(crate) enum Order {
    /// Measure the points of [`RUN`].
    Start,
    /// Silence the exciter and end the run, for this reason.
    Stop(Reason),
}

/// Orders to the measuring task. A start is only given when it is idle.
pub(crate) static ORDERS: Channel<CriticalSectionRawMutex, Order, 4> = Channel::new();

/// The measuring task has ended a run: it can be stored.
pub(crate) static RUN_ENDED: Signal<CriticalSectionRawMutex, ()> = Signal::new();

/// A value as it was last read; none while it cannot be read.
pub(crate) struct Reading(CriticalSectionMutex<Cell<Option<f32>>>);

impl Reading {
    const fn new() -> Self {
        Self(CriticalSectionMutex::new(Cell::new(None)))
    }

    pub(crate) fn get(&self) -> Option<f32> {
        self.0.lock(Cell::get)
    }

    /// Takes a reading, or that there is none.
    pub(crate) fn set(&self, value: Option<f32>) {
        self.0.lock(|cell| cell.set(value));
    }
}

/// Temperature of the processor, degrees Celsius.
pub(crate) static TEMPERATURE_C: Reading = Reading::new();
/// Supply of the converters, V.
pub(crate) static SUPPLY_V: Reading = Reading::new();
/// How much faster the clock is than the frames of the USB host, ppm.
pub(crate) static TIMEBASE_PPM: Reading = Reading::new();

/// Rises while samples come in.
pub(crate) static ACQUIRE_ALIVE: AtomicU32 = AtomicU32::new(0);
/// Rises while the exciter is fed.
pub(crate) static DRIVE_ALIVE: AtomicU32 = AtomicU32::new(0);
/// The measurement wants the exciter driven.
pub(crate) static PLAYS: AtomicBool = AtomicBool::new(false);
/// Something other than silence is played, or queued.
pub(crate) static DRIVEN: AtomicBool = AtomicBool::new(false);
/// Rises while blocks are worked on.
pub(crate) static MEASURE_ALIVE: AtomicU32 = AtomicU32::new(0);

/// Since the converters were started, both channels were shown to be of the same instants.
pub(crate) static ALIGNED: AtomicBool = AtomicBool::new(false);
/// Samples come in and are worked on: acquire, drive and measure run.
pub(crate) static MEASURES: AtomicBool = AtomicBool::new(false);
/// The record area has been read, or cannot be.
pub(crate) static STORED_READ: AtomicBool = AtomicBool::new(false);

/// A block is being evaluated.
pub(crate) static EVALUATING: AtomicBool = AtomicBool::new(false);

/// The board is silent and about to restart: what stands still is meant to.
pub(crate) static RESTARTING: AtomicBool = AtomicBool::new(false);

/// A hand is on the button.
pub(crate) static BUTTON_HELD: AtomicBool = AtomicBool::new(false);
/// The press has been good for something; taken by whoever looks at the button.
pub(crate) static BUTTON_USED: AtomicBool = AtomicBool::new(false);

static SETTINGS: CriticalSectionMutex<RefCell<Option<Settings>>> =
    CriticalSectionMutex::new(RefCell::new(None));

/// The settings in force; before any were stored, those of the factory.
pub(crate) fn settings() -> Settings {
    SETTINGS
        .lock(|settings| settings.borrow().clone())
        .unwrap_or_else(factory_settings)
}

/// Settings of an instrument that was never told any: a field calibrator's, on this board.
pub(crate) fn factory_settings() -> Settings {
    Settings::field_calibrator_with(&CONVERTERS)
}

/// Takes other settings into force.
pub(crate) fn take_settings(settings: Settings) {
    SETTINGS.lock(|current| current.replace(Some(settings)));
}
