//! Memory kept over a reset: the history of starts ([`calib_firmware::restarts`]).
//!
//! The last KiB of AXI SRAM, which no start-up code touches. Its check bits (ECC) are those of double
//! words: a write of less is held back until the next one elsewhere in the same memory, and a reset
//! forgets it (RM0433 Rev 8, 2.4, as quoted in zephyr issue 103501). So whole double words are
//! written, and a word beside them behind the last.

use calib_firmware::restarts::{History, Reached, Reason, WORDS, Way};
use calib_protocol::message::ResetCause;
use core::cell::UnsafeCell;

#[repr(C, align(8))]
struct Kept {
    history: [u64; WORDS],
    /// Written behind everything else, and never read.
    beside: [u32; 2],
}

struct KeptCell(UnsafeCell<Kept>);
// Note(unsafe): written at the start before any task runs, by tasks of one executor, and with
// interrupts off on the way into a reset.
unsafe impl Sync for KeptCell {}

#[unsafe(link_section = ".retained")]
static KEPT: KeptCell = KeptCell(UnsafeCell::new(Kept {
    history: [0; WORDS],
    beside: [0; 2],
}));

/// The history of this start, and the words the one before left. To be called once, before
/// everything else.
pub(crate) fn begin(cause: ResetCause) -> (History, Option<Reason>) {
    let (history, told) = History::begin(load(), cause);
    store(&history);
    (history, told)
}

/// The start has come to `reached`.
pub(crate) fn enter(reached: Reached) {
    change(|history| history.enter(reached));
}

/// The start ends.
pub(crate) fn leave(way: Way, reason: Reason) {
    change(|history| history.leave(way, reason));
}

/// A minute has passed since the start.
pub(crate) fn live_on() {
    change(History::live_on);
}

fn change(change: impl FnOnce(&mut History)) {
    cortex_m::interrupt::free(|_| {
        let mut history = load().unwrap_or_default();
        change(&mut history);
        store(&history);
    });
}

fn load() -> Option<History> {
    // Note(unsafe): volatile, because the compiler believes that nobody wrote here.
    let words = unsafe { (&raw const (*KEPT.0.get()).history).read_volatile() };
    History::from_words(&words)
}

fn store(history: &History) {
    let words = history.to_words();
    // Note(unsafe): see `KeptCell`.
    unsafe {
        let place = (&raw mut (*KEPT.0.get()).history).cast::<u64>();
        for (index, word) in words.into_iter().enumerate() {
            place.add(index).write_volatile(word);
        }
        (&raw mut (*KEPT.0.get()).beside[1]).write_volatile(0);
    }
    cortex_m::asm::dsb();
}
