//! Samples in: from the DMA ring to whole blocks, with losses counted, and a
//! copy for the host that asked for one. None is handed over before both
//! channels are shown to be of the same instants.

use crate::board::{BLOCK_PAIRS, Digitiser};
use crate::state::{self, Order};
use crate::tasks::drive::SILENCE;
use calib_core::alignment::{Alignment, judge};
use calib_core::verdict::Reason;
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
    let mut gap = false;
    // From here on blocks begin where the common signal does.
    let _ = digitiser.next(&mut blocks.send().await.pairs).await;
    align(&mut digitiser, &mut blocks.send().await.pairs).await;
    loop {
        let block = blocks.send().await;
        match digitiser.next(&mut block.pairs).await {
            Ok(()) => {
                block.gap = core::mem::take(&mut gap);
                let first = state::status().samples;
                state::timed(Work::Acquire, || {
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
async fn align(digitiser: &mut Digitiser, pairs: &mut [u32; BLOCK_PAIRS]) {
    for start in 1..=STARTS {
        let shown = match digitiser.common_signal(pairs).await {
            Ok(()) => judge(pairs),
            Err(_) => Alignment::Unclear,
        };
        state::ACQUIRE_ALIVE.fetch_add(1, Ordering::Relaxed);
        let aligned = shown == Alignment::Aligned;
        state::ALIGNED.store(aligned, Ordering::Relaxed);
        if aligned {
            return;
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
}
