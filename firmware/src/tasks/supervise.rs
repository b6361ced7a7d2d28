//! Lamps, button, watchdog.

use crate::board::{Lamps, Watchdog};
use crate::instrument::Calibrator;
use crate::state::{self, Order};
use calib_core::point::ExcitationKind;
use calib_core::points::default_points;
use calib_core::verdict::Verdict;
use calib_firmware::command::Instrument;
use calib_protocol::message::{RunSpec, RunState};
use calib_protocol::record::RunLabels;
use core::sync::atomic::Ordering;
use embassy_stm32::gpio::{Input, Level};
use embassy_time::{Duration, Ticker};

/// Button and lamps are looked at this often; a bounce is shorter.
const PERIOD: Duration = Duration::from_millis(20);
/// Periods in which acquiring and measuring must each have moved: 100 ms.
const ALIVE_PERIODS: u8 = 5;

/// Watches over everything else.
#[embassy_executor::task]
pub(crate) async fn supervise(
    mut lamps: Lamps,
    button: Input<'static>,
    mut watchdog: Watchdog,
    mut instrument: Calibrator,
) -> ! {
    watchdog.unleash();
    let mut alive = Alive::default();
    let mut pressed_before = button.is_high();
    let mut ticker = Ticker::every(PERIOD);
    loop {
        ticker.next().await;
        if alive.check() {
            watchdog.pet();
        }
        let pressed = button.is_high();
        if pressed && !pressed_before {
            on_button(&mut instrument).await;
        }
        pressed_before = pressed;
        show(&mut lamps, state::status().state);
    }
}

/// Whether acquiring and measuring go on.
#[derive(Default)]
struct Alive {
    acquire: u32,
    measure: u32,
    periods: u8,
}

impl Alive {
    /// False once either has stood still for [`ALIVE_PERIODS`].
    fn check(&mut self) -> bool {
        let acquire = state::ACQUIRE_ALIVE.load(Ordering::Relaxed);
        let measure = state::MEASURE_ALIVE.load(Ordering::Relaxed);
        if acquire != self.acquire && measure != self.measure {
            (self.acquire, self.measure, self.periods) = (acquire, measure, 0);
        } else {
            self.periods = self.periods.saturating_add(1);
        }
        self.periods < ALIVE_PERIODS
    }
}

/// Starts the default list, or stops the run there is.
async fn on_button(instrument: &mut Calibrator) {
    if matches!(
        state::status().state,
        RunState::Settling | RunState::Measuring
    ) {
        state::ORDERS.send(Order::Stop).await;
        return;
    }
    let run = RunSpec {
        points: default_points().into_iter().collect(),
        excitation: ExcitationKind::SingleSine,
        labels: RunLabels::default(),
    };
    if let Err(refusal) = instrument.start(run).await {
        defmt::warn!("button: {}", defmt::Debug2Format(&refusal));
    }
}

fn show(lamps: &mut Lamps, state: RunState) {
    let busy = matches!(
        state,
        RunState::Settling | RunState::Measuring | RunState::Storing
    );
    let refused = state::RUN.lock(|run| {
        let run = run.borrow();
        run.results
            .iter()
            .any(|point| point.verdict != Verdict::Pass)
    });
    let bad = state == RunState::Failed || refused;
    lamps.yellow.set_level(Level::from(busy));
    lamps.red.set_level(Level::from(bad));
    lamps.green.set_level(Level::from(!busy && !bad));
}
