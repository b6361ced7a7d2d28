//! Drive out: one block of codes for each block of samples.
//!
//! Measuring commands the drive anew with every block. Without a command in
//! time the exciter goes silent by itself: a hung measurement does not leave
//! a tone on the table. One block is played as before while a block is being
//! evaluated, which takes longest at some low frequencies; the command that
//! comes late then finds its block made. And a mute does not wait for the blocks in the ring:
//! it overwrites them.

use crate::board::{BLOCK_PAIRS, CONVERTERS, Exciter, MID_SCALE, axi_static};
use crate::self_test::TONE;
use crate::{state, timing};
use calib_core::broadband::PeriodMemory;
use calib_core::output::{Command, Output};
use calib_core::self_test::fill_tone;
use calib_protocol::health::Work;
use core::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use embassy_futures::select::{Either, select};
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::signal::Signal;
use embassy_time::{Duration, Timer, with_timeout};

/// Task of the exciter during the next block.
#[derive(Clone, Copy, Debug, PartialEq, defmt::Format)]
pub(crate) struct DriveOrder {
    /// Command of the core.
    pub(crate) command: Command,
    /// End of the block with which it came, for [`Exciter::way`].
    pub(crate) block_end: u32,
    /// Volts peak at the exciter for half of the converter's range.
    pub(crate) full_scale_peak_v: f32,
}

/// The order for the next block.
pub(crate) static COMMAND: Signal<CriticalSectionRawMutex, DriveOrder> = Signal::new();

/// Pairs from the end of the block with which an order came to the first taken under it: of the last order.
pub(crate) static WAY_PAIRS: AtomicU32 = AtomicU32::new(3 * BLOCK_PAIRS as u32);

/// An order came late, and is played a block later.
pub(crate) static LATE: AtomicBool = AtomicBool::new(false);

/// Silence now, whatever is queued; the order that says so follows.
pub(crate) static SILENCE: Signal<CriticalSectionRawMutex, ()> = Signal::new();

/// The ring runs dry two blocks, 20 ms, after a block was written: until then
/// the next one must be there, be it a tone or silence.
const PATIENCE: Duration = Duration::from_millis(18);

/// Without commands a block of silence is written so often: a little faster than it
/// is played, and after a silence of [`PATIENCE`] some 8 ms behind the place that
/// became free. So for some blocks there is room when a command comes, and it is
/// played with the next block, not the one after.
const PACE: Duration = Duration::from_millis(9);

/// After it what is hushed has come out: 50 samples.
const HUSHED: Duration = Duration::from_millis(1);

/// Start of the dither: the same tone is the same codes, run after run.
const SEED: u32 = 1;

/// Plays what it is told.
#[embassy_executor::task]
pub(crate) async fn drive(mut exciter: Exciter) -> ! {
    axi_static!(PERIOD: PeriodMemory);
    let mut full_scale_peak_v = 0.0;
    let mut output = Output::new(PERIOD.take(), CONVERTERS.drive, f32::INFINITY, SEED);
    let mut codes = [MID_SCALE; BLOCK_PAIRS];
    let mut patience = PATIENCE;
    // A block was played as before, in place of a command that is late.
    let mut spared = false;
    loop {
        if TONE.try_take() == Some(true) {
            play_unheard(&mut exciter, &mut output, &mut codes).await;
        }
        if let Ok(order) = with_timeout(patience, COMMAND.wait()).await {
            patience = PATIENCE;
            // The scale only changes between runs, in silence.
            if order.full_scale_peak_v != full_scale_peak_v {
                full_scale_peak_v = order.full_scale_peak_v;
                output.scale(full_scale_peak_v);
            }
            if order.command == Command::Mute {
                silence(&mut exciter, &mut output);
            } else {
                output.apply(order.command);
                state::DRIVEN.store(!output.is_silent(), Ordering::Relaxed);
            }
            if core::mem::take(&mut spared) {
                LATE.store(true, Ordering::Relaxed);
                continue;
            }
            if let Some(pairs) = exciter.way(order.block_end) {
                WAY_PAIRS.store(pairs, Ordering::Relaxed);
            }
        } else if !spared && state::EVALUATING.load(Ordering::Relaxed) {
            spared = true;
        } else {
            spared = false;
            if !output.is_silent() {
                defmt::error!("no drive command in time: silent");
            }
            silence(&mut exciter, &mut output);
            // From now on the ring sets the pace.
            patience = PACE;
        }
        state::DRIVE_ALIVE.fetch_add(1, Ordering::Relaxed);
        timing::timed(Work::Drive, || output.fill(&mut codes));
        match select(SILENCE.wait(), exciter.play(&codes)).await {
            Either::First(()) => silence(&mut exciter, &mut output),
            Either::Second(Ok(())) => {}
            Either::Second(Err(_)) => {
                defmt::warn!("drive written late");
                silence(&mut exciter, &mut output);
            }
        }
    }
}

/// Plays the tone of the self-test, with the pin let go, until it is told to end. The ring keeps its
/// pace, and orders of the measurement wait: it measures nothing meanwhile.
async fn play_unheard(
    exciter: &mut Exciter,
    output: &mut Output<'_>,
    codes: &mut [u16; BLOCK_PAIRS],
) {
    if !output.is_silent() {
        silence(exciter, output);
        Timer::after(HUSHED).await;
    }
    exciter.disconnect();
    fill_tone(codes, CONVERTERS.drive);
    while TONE.try_take() != Some(false) {
        if exciter.play(codes).await.is_err() {
            defmt::warn!("tone of the self-test written late");
        }
        state::DRIVE_ALIVE.fetch_add(1, Ordering::Relaxed);
    }
    exciter.hush();
    // Two blocks of silence are ahead. The next is written as it is in a silence: behind the place
    // that became free, so that a command is played with the next block and not the one after.
    Timer::after(PATIENCE).await;
    exciter.connect();
}

/// Rest now: nothing more is generated, and nothing queued is played.
fn silence(exciter: &mut Exciter, output: &mut Output<'_>) {
    SILENCE.reset();
    if !output.is_silent() {
        exciter.hush();
    }
    output.mute();
    state::DRIVEN.store(false, Ordering::Relaxed);
}
