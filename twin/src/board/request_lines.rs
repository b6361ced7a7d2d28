//! The request lines between those who want data moved and the DMA controller.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use rigless::snapshot::{self, Reader, Store, Writer};

/// `DMAREQ_ID` of the lines the converters set (RM0433 Rev 9, table 124). The two input converters'
/// line is driven by their common block: in dual mode the pair has one.
pub(super) const ADC1: usize = 9;
pub(super) const DAC_CHANNELS: [usize; 2] = [67, 68];

/// Channels of the multiplexer.
pub(super) const CHANNELS: usize = 16;
/// Values of `DMAREQ_ID`.
const IDS: usize = 128;

/// Every request line's level, and the line each channel listens to: a handle for those who drive a
/// line and those who serve it.
#[derive(Debug, Clone)]
pub(super) struct RequestLines(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    /// By `DMAREQ_ID`.
    levels: [AtomicBool; IDS],
    selected: [AtomicUsize; CHANNELS],
}

impl RequestLines {
    pub(super) fn new() -> Self {
        Self(Arc::new(Shared {
            levels: std::array::from_fn(|_| AtomicBool::new(false)),
            selected: std::array::from_fn(|_| AtomicUsize::new(0)),
        }))
    }

    /// Sets the level of line `id`.
    pub(super) fn drive(&self, id: usize, high: bool) {
        self.0.levels[id].store(high, Ordering::Relaxed);
    }

    /// Whether the line `channel` listens to is high.
    pub(super) fn stands(&self, channel: usize) -> bool {
        self.0.levels[self.selected(channel)].load(Ordering::Relaxed)
    }

    /// `DMAREQ_ID` of the line `channel` listens to.
    pub(super) fn selected(&self, channel: usize) -> usize {
        self.0.selected[channel].load(Ordering::Relaxed)
    }

    /// Lets `channel` listen to line `id`.
    pub(super) fn select(&self, channel: usize, id: usize) {
        self.0.selected[channel].store(id, Ordering::Relaxed);
    }
}

impl Store for RequestLines {
    fn store(&self, to: &mut Writer) -> Result<(), snapshot::Error> {
        let Shared { levels, selected } = &*self.0;
        let levels = levels.iter().map(|level| level.load(Ordering::Relaxed));
        let selected = selected.iter().map(|id| id.load(Ordering::Relaxed));
        to.put(&levels.collect::<Vec<bool>>())?;
        to.put(&selected.collect::<Vec<usize>>())
    }

    fn load(&mut self, from: &mut Reader) -> Result<(), snapshot::Error> {
        let (levels, selected): (Vec<bool>, Vec<usize>) = (from.take()?, from.take()?);
        for (id, level) in levels.into_iter().enumerate().take(IDS) {
            self.drive(id, level);
        }
        for (channel, id) in selected.into_iter().enumerate().take(CHANNELS) {
            self.select(channel, id.min(IDS - 1));
        }
        Ok(())
    }
}
