//! The self-test: the board looks at itself, with the table at rest.
//!
//! | step | acquire | drive |
//! |---|---|---|
//! | 1 | a block of both inputs at rest, and one of single conversions, which show the dither | silent |
//! | 2 | ADC2 turns from its pin to the DAC, on the chip | lets go of its pin at mid-scale, plays a tone |
//! | 3 | two blocks of the tone | |
//! | 4 | ADC2 turns back; both channels are shown to be of the same instants | silent for 18 ms, takes its pin again |
//!
//! The pin is let go before the first code of the tone and taken after the last; in between the bias
//! network of the output stage holds it (docs/safety.md).

use crate::board::{option_bytes, wrong_words_of_image};
use crate::state;
use calib_core::alignment::Alignment;
use calib_core::self_test::{AtRest, Evidence, Line, Loopback, MAX_LINES, WrongWords, judge};
use calib_protocol::health::Health;
use calib_protocol::message::ResetCause;
use core::sync::atomic::{AtomicBool, Ordering};
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::signal::Signal;
use embassy_time::{Duration, with_timeout};
use heapless::Vec;

/// Findings of the acquiring task.
#[derive(Clone, Copy)]
pub(crate) struct Heard {
    pub(crate) at_rest: Option<[AtRest; 2]>,
    /// At rest by single conversions.
    pub(crate) dithered: Option<[AtRest; 2]>,
    pub(crate) loopback: Option<Loopback>,
    pub(crate) alignment: Alignment,
}

/// The acquiring task is to listen.
pub(crate) static LISTEN: Signal<CriticalSectionRawMutex, ()> = Signal::new();
/// It has.
static HEARD: Signal<CriticalSectionRawMutex, Heard> = Signal::new();
/// The drive is to play the tone where only ADC2 hears it, or to end it.
pub(crate) static TONE: Signal<CriticalSectionRawMutex, bool> = Signal::new();

/// The acquiring task needs 0.2 s.
const PATIENCE: Duration = Duration::from_secs(2);

static UNDER_WAY: AtomicBool = AtomicBool::new(false);

/// Whether a self-test is going on: no run begins.
pub(crate) fn is_under_way() -> bool {
    UNDER_WAY.load(Ordering::Relaxed)
}

/// A self-test, until this is dropped: a host that goes away ends it as well.
pub(crate) struct SelfTest;

impl SelfTest {
    /// Begins one; none while another goes on.
    // Both links are on one executor, and nothing is awaited here.
    pub(crate) fn begin() -> Option<Self> {
        if is_under_way() {
            return None;
        }
        UNDER_WAY.store(true, Ordering::Relaxed);
        Some(Self)
    }

    /// Has the converters listened to, and judges the board.
    pub(crate) async fn carry_out(
        &self,
        records: Option<(u32, WrongWords)>,
        health: &Health,
        reset_cause: ResetCause,
        panicked: bool,
    ) -> Vec<Line, MAX_LINES> {
        let lost_pairs = state::status().overruns;
        HEARD.reset();
        LISTEN.signal(());
        let heard = with_timeout(PATIENCE, HEARD.wait()).await.ok();
        let unwanted = matches!(reset_cause, ResetCause::Watchdog | ResetCause::BrownOut);
        judge(&Evidence {
            supply_v: state::SUPPLY_V.get(),
            temperature_c: state::TEMPERATURE_C.get(),
            at_rest: heard.and_then(|heard| heard.at_rest),
            dithered: heard.and_then(|heard| heard.dithered),
            loopback: heard.and_then(|heard| heard.loopback),
            alignment: heard.map_or(Alignment::Unclear, |heard| heard.alignment),
            lost_pairs,
            stack_unused_bytes: crate::board::unused_stack_bytes(),
            records_unreadable: records.map(|(unreadable, _)| unreadable),
            option_bytes: option_bytes(),
            image: wrong_words_of_image().await,
            record_area: records.map(|(_, wrong)| wrong),
            unwanted_start: unwanted || panicked,
            defects: health.defects.iter().count() as u32,
            deadline_rel: health
                .deadlines
                .iter()
                .map(|deadline| deadline.longest_us / deadline.allowed_us)
                .fold(0.0, f32::max),
            timebase_ppm: health.timebase_ppm,
        })
    }
}

impl Drop for SelfTest {
    fn drop(&mut self) {
        UNDER_WAY.store(false, Ordering::Relaxed);
    }
}

/// Hands over what was found.
pub(crate) fn tell(heard: Heard) {
    HEARD.signal(heard);
}
