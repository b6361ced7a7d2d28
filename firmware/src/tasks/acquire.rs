//! Samples in: from the DMA ring to whole blocks, with losses counted, and a
//! copy for the host that asked for one. None is handed over before both
//! channels are shown to be of the same instants.

use crate::board::{BLOCK_PAIRS, Digitiser, axi_static};
use crate::self_test::{self, Heard, LISTEN, TONE};
use crate::state::{self, Order};
use crate::tasks::drive::SILENCE;
use crate::timing;
use calib_core::alignment::{Alignment, judge};
use calib_core::point_state::Reason;
use calib_core::self_test::{AtRest, Loopback, at_rest, loopback};
use calib_firmware::capture::Capture;
use calib_protocol::health::Work;
use core::sync::atomic::Ordering;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::zerocopy_channel::Sender;

/// Consecutive sample pairs.
pub(crate) struct Block {
    /// Low half reference, high half device under test, samples of [`calib_core::converter`].
    pub(crate) pairs: [u32; BLOCK_PAIRS],
    /// Pairs are missing between the block before and this one.
    pub(crate) gap: bool,
}

impl Block {
    /// A block to be filled.
    pub(crate) const EMPTY: Self = Self {
        pairs: [0; BLOCK_PAIRS],
        gap: false,
    };
}

/// Hands over block after block.
///
/// A late reader is noticed as an overrun of the ring, and told by the gap.
#[embassy_executor::task]
pub(crate) async fn acquire(
    mut digitiser: Digitiser,
    mut blocks: Sender<'static, CriticalSectionRawMutex, Block>,
) -> ! {
    axi_static!(TONE_BLOCK: [u32; BLOCK_PAIRS]);
    let tone_block = TONE_BLOCK.take();
    let mut gap = false;
    // From here on blocks begin where the common signal does.
    let _ = digitiser.next(&mut blocks.send().await.pairs).await;
    align(&mut digitiser, &mut blocks.send().await.pairs).await;
    loop {
        if LISTEN.try_take().is_some() {
            state::with_capture(Capture::lose);
            self_test::tell(listen(&mut digitiser, &mut blocks, tone_block).await);
            gap = true;
        }
        let block = blocks.send().await;
        match digitiser.next(&mut block.pairs).await {
            Ok(()) => {
                block.gap = core::mem::take(&mut gap);
                let first = state::status().samples;
                timing::timed(Work::Acquire, || {
                    state::with_capture(|capture| capture.take(first, &block.pairs));
                });
                blocks.send_done();
                state::update_status(|status| status.samples += BLOCK_PAIRS as u64);
                state::ACQUIRE_ALIVE.fetch_add(1, Ordering::Relaxed);
            }
            Err(fault) => {
                defmt::warn!("samples lost: {}", fault);
                gap = true;
                state::with_capture(Capture::lose);
                state::update_status(|status| status.overruns += 1);
                // What is measured is lost, and a table at rest shows the common signal best.
                SILENCE.signal(());
                digitiser.restart();
                align(&mut digitiser, &mut block.pairs).await;
            }
        }
    }
}

/// Starts of the converters in which the channels may fail to be of the same instants.
const STARTS: usize = 3;

/// Shows that the channels are of the same instants, starting the converters again where they are
/// not; what comes of it is in [`state::ALIGNED`]. 10 ms, and as much for each further start.
async fn align(digitiser: &mut Digitiser, pairs: &mut [u32; BLOCK_PAIRS]) -> Alignment {
    let mut shown = Alignment::Unclear;
    for start in 1..=STARTS {
        shown = match digitiser.common_signal(pairs).await {
            Ok(()) => judge(pairs),
            Err(_) => Alignment::Unclear,
        };
        state::ACQUIRE_ALIVE.fetch_add(1, Ordering::Relaxed);
        let aligned = shown == Alignment::Aligned;
        state::ALIGNED.store(aligned, Ordering::Relaxed);
        if aligned {
            return shown;
        }
        defmt::warn!("channels: {}, start {=usize}", shown, start);
        if start < STARTS {
            digitiser.restart();
        }
    }
    defmt::error!("the channels are not of the same instants");
    if state::status().state.is_exciting() {
        // Behind a full queue there is a stop, or the gap that follows ends the run.
        let _ = state::ORDERS.try_send(Order::Stop(Reason::ChannelsNotAligned));
    }
    shown
}

/// Blocks until the tone is what comes: the drive hears of it within two, and writes a ring of two.
const TONE_COMES: usize = 8;

type Blocks = Sender<'static, CriticalSectionRawMutex, Block>;

/// The converters' part of the self-test: see [`self_test`].
async fn listen(
    digitiser: &mut Digitiser,
    blocks: &mut Blocks,
    first: &mut [u32; BLOCK_PAIRS],
) -> Heard {
    let quiet = take(digitiser, blocks, inputs).await;
    digitiser.convert_once(true);
    let dithered = take(digitiser, blocks, inputs).await;
    digitiser.convert_once(false);
    TONE.signal(true);
    digitiser.hear_drive(true);
    let loopback = hear_tone(digitiser, blocks, first).await;
    TONE.signal(false);
    digitiser.hear_drive(false);
    // The alignment begins where a block does, and finds the drive at rest.
    for _ in 0..TONE_COMES {
        take(digitiser, blocks, |_| ()).await;
    }
    Heard {
        at_rest: quiet,
        dithered,
        loopback,
        alignment: align(digitiser, &mut blocks.send().await.pairs).await,
    }
}

/// Both inputs, by a block. One function, so that one copy of [`take`] does for both looks at them.
fn inputs(pairs: &[u32; BLOCK_PAIRS]) -> [AtRest; 2] {
    at_rest(pairs)
}

async fn hear_tone(
    digitiser: &mut Digitiser,
    blocks: &mut Blocks,
    first: &mut [u32; BLOCK_PAIRS],
) -> Option<Loopback> {
    for _ in 0..TONE_COMES {
        take(digitiser, blocks, |_| ()).await;
    }
    take(digitiser, blocks, |pairs| first.copy_from_slice(pairs)).await?;
    take(digitiser, blocks, |pairs| loopback(first, pairs)).await
}

/// Looks at the next block and hands it over as one that follows a gap: measuring goes on, and nothing
/// is measured by it. None if pairs were lost.
async fn take<T>(
    digitiser: &mut Digitiser,
    blocks: &mut Blocks,
    look: impl FnOnce(&[u32; BLOCK_PAIRS]) -> T,
) -> Option<T> {
    let block = blocks.send().await;
    let taken = digitiser.next(&mut block.pairs).await;
    let seen = taken.ok().map(|()| look(&block.pairs));
    block.gap = true;
    blocks.send_done();
    state::ACQUIRE_ALIVE.fetch_add(1, Ordering::Relaxed);
    if seen.is_none() {
        digitiser.restart();
    }
    seen
}
