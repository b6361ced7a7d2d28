//! How long blocks, turns of tasks and interrupts take at most, by the core's cycle counter.

use calib_protocol::health::{Deadline, MAX_DEADLINES, Work};
use core::sync::atomic::{AtomicU32, Ordering};
use cortex_m::peripheral::DWT;
use embassy_executor::SpawnToken;
use embassy_stm32::interrupt::typelevel::{Handler, Interrupt};
use heapless::Vec;

/// One piece of work. None interrupts itself.
struct Watched {
    /// Task whose turns are timed, as the executor names it; 0 of what is no task.
    task: AtomicU32,
    /// The cycle in which it began last.
    begun: AtomicU32,
    /// Longest so far, cycles.
    longest: AtomicU32,
}

impl Watched {
    const IDLE: Self = Self {
        task: AtomicU32::new(0),
        begun: AtomicU32::new(0),
        longest: AtomicU32::new(0),
    };

    fn begin(&self) {
        self.begun.store(DWT::cycle_count(), Ordering::Relaxed);
    }

    fn end(&self) {
        let cycles = DWT::cycle_count().wrapping_sub(self.begun.load(Ordering::Relaxed));
        self.longest.fetch_max(cycles, Ordering::Relaxed);
    }
}

/// In the order of [`Work`].
static WATCHED: [Watched; Work::ALL.len()] = [const { Watched::IDLE }; Work::ALL.len()];

fn watched(work: Work) -> Option<&'static Watched> {
    WATCHED.get(work as usize)
}

/// Does `act`, and notes how long it took.
pub(crate) fn timed<T>(work: Work, act: impl FnOnce() -> T) -> T {
    begin(work);
    let done = act();
    end(work);
    done
}

/// Work that is no one call begins; [`end`] follows.
pub(crate) fn begin(work: Work) {
    watched(work).inspect(|watched| watched.begin());
}

/// It ends.
pub(crate) fn end(work: Work) {
    watched(work).inspect(|watched| watched.end());
}

/// The task about to be spawned; its turns count as `work`.
pub(crate) fn turns_of<S>(work: Work, token: SpawnToken<S>) -> SpawnToken<S> {
    watched(work).inspect(|watched| watched.task.store(token.id(), Ordering::Relaxed));
    token
}

/// Times that pieces of work took, and may take, on a core of so many MHz.
pub(crate) fn deadlines(core_mhz: f32) -> Vec<Deadline, MAX_DEADLINES> {
    let told = Work::ALL.into_iter().zip(&WATCHED);
    told.map(|(work, watched)| Deadline {
        work: work as u8,
        longest_us: watched.longest.load(Ordering::Relaxed) as f32 / core_mhz,
        allowed_us: allowed_us(work),
    })
    .collect()
}

/// Time a piece of work may take, microseconds: a block lasts 10 ms. To take the samples or to make the drive,
/// both above the evaluation, a tenth of it, and half of it with all else their tasks do; to evaluate, the
/// block and most of the one that is made up for meanwhile ([`crate::tasks::drive`]). Tasks that have time wait
/// for each other, and the watchdog for 250 ms.
fn allowed_us(work: Work) -> f32 {
    match work {
        Work::Acquire | Work::Drive => 1_000.0,
        Work::Evaluate | Work::MeasureTask => 17_000.0,
        Work::AcquireTask | Work::DriveTask => 5_000.0,
        Work::SerialTask
        | Work::UsbTask
        | Work::SuperviseTask
        | Work::StoreTask
        | Work::SensorTask
        | Work::TimebaseTask => 100_000.0,
        Work::DmaInterrupt | Work::UsbInterrupt | Work::UartInterrupt => 1_000.0,
    }
}

/// Handler of an interrupt before all others of it: the piece of work with this number begins.
pub(crate) struct Begin<const WORK: usize>;

/// Handler of an interrupt after all others of it: that piece of work ends.
pub(crate) struct End<const WORK: usize>;

impl<I: Interrupt, const WORK: usize> Handler<I> for Begin<WORK> {
    unsafe fn on_interrupt() {
        WATCHED.get(WORK).inspect(|watched| watched.begin());
    }
}

impl<I: Interrupt, const WORK: usize> Handler<I> for End<WORK> {
    unsafe fn on_interrupt() {
        WATCHED.get(WORK).inspect(|watched| watched.end());
    }
}

fn of_task(task: u32) -> Option<&'static Watched> {
    let mut all = WATCHED.iter();
    all.find(|watched| watched.task.load(Ordering::Relaxed) == task)
}

// What the executor calls, by its feature `trace`. Note(unsafe): names and arguments are those of
// embassy-executor 0.10, `raw/trace.rs`.

#[unsafe(no_mangle)]
fn _embassy_trace_task_exec_begin(_executor: u32, task: u32) {
    of_task(task).inspect(|watched| watched.begin());
}

#[unsafe(no_mangle)]
fn _embassy_trace_task_exec_end(_executor: u32, task: u32) {
    of_task(task).inspect(|watched| watched.end());
}

#[unsafe(no_mangle)]
fn _embassy_trace_poll_start(_executor: u32) {}

#[unsafe(no_mangle)]
fn _embassy_trace_task_new(_executor: u32, _task: u32) {}

#[unsafe(no_mangle)]
fn _embassy_trace_task_end(_executor: u32, _task: u32) {}

#[unsafe(no_mangle)]
fn _embassy_trace_task_ready_begin(_executor: u32, _task: u32) {}

#[unsafe(no_mangle)]
fn _embassy_trace_executor_idle(_executor: u32) {}
