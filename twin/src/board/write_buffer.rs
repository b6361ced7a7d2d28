//! The write buffer of AXI SRAM, as far as memory kept over a reset is concerned.
//!
//! The check bits of this memory are those of double words. A write of less waits in a buffer for the
//! rest of its double word; the next such write elsewhere, or a whole one in its place, puts it into the
//! memory, and a reset forgets it (RM0433 Rev 8, 2.4, as quoted in zephyr issue 103501; ST's FAQ on
//! contents of SRAM that are not preserved). Watched are the last KiB, which the firmware keeps
//! (`memory.x`): what is written there shortly before a reset is what can be lost. Later on the DMA has
//! written elsewhere.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use rigless::emulator::Watch;
use rigless::time::VirtualNanos;

/// The memory that is watched.
const KEPT: u64 = 0x2407_FC00;
const KEPT_BYTES: u64 = 1024;
const DOUBLE: u64 = 8;
/// After this the DMA of the converters has written to the same memory: two samples.
const FLUSHED_NS: u64 = 40_000;

/// The buffer. A shared handle.
#[derive(Debug, Clone, Default)]
pub struct WriteBuffer(Arc<Shared>);

#[derive(Debug, Default)]
struct Shared {
    state: Mutex<State>,
    has_lost: AtomicBool,
}

#[derive(Debug, Default)]
struct State {
    /// Content of the memory as it was seen last, by address.
    seen: BTreeMap<u64, u64>,
    /// Double words not yet in the memory, with what is there instead.
    waiting: BTreeMap<u64, u64>,
    written_ns: u64,
    lost: Vec<(u64, u64)>,
}

impl WriteBuffer {
    /// Writes the emulator is to look at.
    pub(crate) fn watch() -> Watch {
        Watch::Writes {
            address: KEPT,
            length: KEPT_BYTES,
        }
    }

    /// Addresses of the double words that are watched.
    pub(crate) fn addresses() -> impl Iterator<Item = u64> {
        (KEPT..KEPT + KEPT_BYTES).step_by(DOUBLE as usize)
    }

    /// Whether this address is watched.
    pub(crate) fn covers(address: u64) -> bool {
        (KEPT..KEPT + KEPT_BYTES).contains(&address)
    }

    /// The memory has this content, and nothing waits.
    pub(crate) fn set(&self, content: BTreeMap<u64, u64>) {
        let mut state = self.lock();
        state.waiting.clear();
        state.seen = content;
    }

    /// A store to `address` has made the double word around it `value`.
    ///
    /// How much it wrote is told by where it began and by what changed: where that leaves it open, it
    /// is taken for less than a double word as far as it can be lost itself, and for a whole one as far
    /// as it could have saved another.
    pub(crate) fn on_write(&self, address: u64, value: u64, at: VirtualNanos) {
        let double = address - address % DOUBLE;
        let mut state = self.lock();
        state.written_ns = at.0;
        let before = state.seen.insert(double, value).unwrap_or(value);
        let is_part = address != double;
        let is_whole = !is_part && (before ^ value) >> 32 != 0;
        if is_part {
            state.waiting.retain(|waiting, _| *waiting == double);
        }
        if is_whole {
            state.waiting.remove(&double);
        } else {
            state.waiting.entry(double).or_insert(before);
        }
    }

    /// The part was reset.
    pub(super) fn on_reset(&self, at: VirtualNanos) {
        let mut state = self.lock();
        let waiting = std::mem::take(&mut state.waiting);
        if at.0 < state.written_ns + FLUSHED_NS {
            state.lost.extend(waiting);
            self.0.has_lost.store(true, Ordering::Relaxed);
        }
    }

    /// Writes the last reset has undone: addresses of double words, and what they hold instead.
    pub(crate) fn take_lost(&self) -> Vec<(u64, u64)> {
        if !self.0.has_lost.swap(false, Ordering::Relaxed) {
            return Vec::new();
        }
        let mut state = self.lock();
        let lost = std::mem::take(&mut state.lost);
        state.seen.extend(lost.iter().copied());
        lost
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.0.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOW: VirtualNanos = VirtualNanos(1_000_000);

    fn empty() -> WriteBuffer {
        let buffer = WriteBuffer::default();
        buffer.set(WriteBuffer::addresses().map(|at| (at, 0)).collect());
        buffer
    }

    #[test]
    fn a_word_is_lost_until_another_is_written_elsewhere() {
        let buffer = empty();
        buffer.on_write(KEPT + 4, 7 << 32, NOW);
        buffer.on_reset(NOW);
        assert_eq!(buffer.take_lost(), [(KEPT, 0)]);
        buffer.on_write(KEPT + 4, 7 << 32, NOW);
        buffer.on_write(KEPT + 20, 1 << 32, NOW);
        buffer.on_reset(NOW);
        assert_eq!(buffer.take_lost(), [(KEPT + 16, 0)]);
    }

    #[test]
    fn whole_double_words_are_there_at_once_and_save_no_other() {
        let buffer = empty();
        buffer.on_write(KEPT + 4, 7 << 32, NOW);
        buffer.on_write(KEPT + 8, u64::MAX, NOW);
        buffer.on_reset(NOW);
        assert_eq!(buffer.take_lost(), [(KEPT, 0)]);
        buffer.on_write(KEPT, u64::MAX, NOW);
        buffer.on_reset(NOW);
        assert_eq!(buffer.take_lost(), []);
    }

    #[test]
    fn what_was_written_long_ago_is_there() {
        let buffer = empty();
        buffer.on_write(KEPT + 4, 7 << 32, NOW);
        buffer.on_reset(VirtualNanos(NOW.0 + FLUSHED_NS));
        assert_eq!(buffer.take_lost(), []);
    }
}
