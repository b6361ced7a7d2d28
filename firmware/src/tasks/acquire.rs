//! Samples in: from the DMA ring to whole blocks, with losses counted, and a
//! copy for the host that asked for one.

use crate::board::{BLOCK_PAIRS, Digitiser};
use crate::state;
use calib_firmware::capture::Capture;
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
    loop {
        let block = blocks.send().await;
        match digitiser.next(&mut block.pairs).await {
            Ok(()) => {
                block.gap = core::mem::take(&mut gap);
                let first = state::status().samples;
                state::with_capture(|capture| capture.take(first, &block.pairs));
                blocks.send_done();
                state::update_status(|status| status.samples += BLOCK_PAIRS as u64);
                state::ACQUIRE_ALIVE.fetch_add(1, Ordering::Relaxed);
            }
            Err(fault) => {
                defmt::warn!("samples lost: {}", fault);
                gap = true;
                state::with_capture(Capture::lose);
                state::update_status(|status| status.overruns += 1);
                digitiser.restart();
            }
        }
    }
}
