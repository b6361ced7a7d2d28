//! Lamps, button, watchdog, and the depth of the stack.

use crate::board::{Lamps, PushButton, Watchdog, silence_now, unused_stack_bytes};
use crate::instrument::Calibrator;
use crate::retained;
use crate::state::{self, Order};
use calib_core::point_state::{PointState, Reason};
use calib_firmware::button::{Button, PERIOD_MS, Press};
use calib_firmware::lamps::{Lit, Shown};
use calib_firmware::lease::Lease;
use calib_firmware::restarts::{MINUTE_MS, Reason as Why, Way};
use calib_protocol::health::Defect;
use calib_protocol::message::RunState;
use core::sync::atomic::Ordering;
use embassy_time::{Duration, Timer};

/// Button and lamps are looked at this often.
const PERIOD: Duration = Duration::from_millis(PERIOD_MS);
/// Periods in which acquiring, driving and measuring must each have moved: 100 ms.
const ALIVE_PERIODS: u8 = 5;
/// Periods after which a restart has nothing to do with those before.
const MINUTE_PERIODS: u32 = (MINUTE_MS / PERIOD_MS) as u32;
/// A hand that stays on the button for so long wants what was left out to be tried again: 3 s.
const AGAIN_PERIODS: u32 = 150;

/// Watches over everything else.
#[embassy_executor::task]
pub(crate) async fn supervise(
    mut lamps: Lamps,
    push_button: PushButton,
    mut watchdog: Watchdog,
    mut instrument: Calibrator,
) -> ! {
    watchdog.unleash();
    watchdog.pet();
    let mut periods = 0_u32;
    let mut alive = Alive::default();
    let mut button = Button::new(push_button.is_down());
    let mut state_before = RunState::Idle;
    loop {
        // No ticker: one that was held up makes up for it at once, and tasks would seem to stand
        // still in periods that never were.
        Timer::after(PERIOD).await;
        periods = periods.saturating_add(1);
        if periods == MINUTE_PERIODS {
            retained::live_on();
        }
        if let Some(task) = alive.hanging()
            && !state::RESTARTING.load(Ordering::Relaxed)
        {
            // Everything but that task still works: say which it is. If not
            // even this does, the watchdog restarts the board.
            panic!("the task {task} stands still");
        }
        watchdog.pet();
        let ran = state_before.is_running();
        look(&mut button, push_button.is_down(), ran, &mut instrument).await;
        if state::defects().has(Defect::Restarts) && button.is_held_for(AGAIN_PERIODS) {
            try_again();
        }
        let state = state::status().state;
        if state.is_running() {
            keep_lease().await;
        }
        if state != state_before && !state.is_running() {
            defmt::info!("{=u32} bytes of stack never used", unused_stack_bytes());
        }
        state_before = state;
        show(&mut lamps, state, periods);
    }
}

/// Whether acquiring, driving and measuring go on.
#[derive(Default)]
struct Alive {
    /// Count of each task when it last moved, and for how many periods it
    /// has not moved since.
    tasks: [(u32, u8); 3],
}

impl Alive {
    /// A task that has stood still for [`ALIVE_PERIODS`], if there is one.
    fn hanging(&mut self) -> Option<&'static str> {
        if !state::MEASURES.load(Ordering::Relaxed) {
            return None;
        }
        // In this order: without blocks measuring stands still as well, and
        // without orders the drive goes on by itself.
        let counts = [
            ("acquire", &state::ACQUIRE_ALIVE),
            ("drive", &state::DRIVE_ALIVE),
            ("measure", &state::MEASURE_ALIVE),
        ];
        let mut hanging = None;
        for ((name, count), (before, periods)) in counts.into_iter().zip(&mut self.tasks) {
            let count = count.load(Ordering::Relaxed);
            *periods = if count == *before {
                periods.saturating_add(1)
            } else {
                0
            };
            *before = count;
            if *periods >= ALIVE_PERIODS {
                hanging = hanging.or(Some(name));
            }
        }
        hanging
    }
}

/// Looks at the button and does what it says. A press is as old as the last look: when a run went on then, it was
/// for that one, and letting go begins none.
async fn look(button: &mut Button, is_down: bool, ran: bool, instrument: &mut Calibrator) {
    if state::BUTTON_USED.swap(false, Ordering::Relaxed) {
        button.consume();
    }
    match button.look(is_down) {
        Press::Down if ran || state::status().state.is_running() => {
            button.consume();
            if state::status().state.is_exciting() {
                state::ORDERS.send(Order::Stop(Reason::Stopped)).await;
            }
        }
        Press::Tap => instrument.tap().await,
        Press::Down | Press::Nothing => {}
    }
    state::BUTTON_HELD.store(button.is_held(), Ordering::Relaxed);
}

/// Ends a run whose host has been silent for longer than its lease grants.
async fn keep_lease() {
    let run_out = state::with_lease(|lease, now_ms| {
        let run_out = lease.has_run_out(now_ms);
        if run_out {
            // Once is enough.
            *lease = Lease::NONE;
        }
        run_out
    });
    if run_out {
        state::ORDERS.send(Order::Stop(Reason::HostsSilent)).await;
    }
}

/// Restarts, and leaves nothing out.
fn try_again() -> ! {
    silence_now();
    retained::leave(Way::Asked, Why::new());
    cortex_m::peripheral::SCB::sys_reset()
}

fn show(lamps: &mut Lamps, state: RunState, periods: u32) {
    let Lit { green, yellow, red } = shown(state).lit(periods);
    lamps.green.set(green);
    lamps.yellow.set(yellow);
    lamps.red.set(red);
}

/// State the lamps show: the one that matters most.
fn shown(state: RunState) -> Shown {
    let defects = state::defects();
    if !defects.is_none() {
        return Shown::Degraded(defects, state.is_running());
    }
    if state.is_running() {
        return Shown::Running;
    }
    if let Some(conformity) = state::conformity() {
        return Shown::Judged(conformity);
    }
    let refused = state::RUN.lock(|run| {
        let run = run.borrow();
        run.results
            .iter()
            .any(|point| point.state != PointState::Valid)
    });
    match state == RunState::Failed || refused {
        true => Shown::Refused,
        false => Shown::Ready,
    }
}
