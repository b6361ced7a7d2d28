//! Flash bank 1, where the code is: the loader's note, the journal, and the slot an update goes to.
//!
//! While bank 1 programs or erases, the core waits for its next instruction from there: 0.2 ms for a word,
//! up to 2.2 s for a sector (DS12110 Rev 10, table 150), and the watchdog waits 250 ms. So a sector is erased
//! from ITCM, interrupts off, since their vectors and most of their code are in the bank as well. The caller
//! sees to it that the exciter is at rest; its converter goes on with the silence in its ring.

use calib_boot::layout::{Slot, WORD};
use calib_boot::{BootFlash, SlotFlash, part};
use core::arch::asm;
use cortex_m::peripheral::SCB;

/// Key register of the watchdog, and what feeds it (RM0433 Rev 9, 45.4.1).
const WATCHDOG_KEY: u32 = 0x5800_4800;
const FEED: u32 = 0xAAAA;
/// Turns of a loop between two looks at an erase, a cycle each at least, and looks before it is given up and
/// the watchdog ends it: 5 s at 480 MHz.
const TURNS: u32 = 1_000;
const LOOKS: u32 = 2_500_000;

/// Bank 1. Nobody else writes there, and only between two awaits.
pub(crate) struct CodeFlash;

impl BootFlash for CodeFlash {
    fn read(&mut self, address: u32) -> Option<[u8; WORD]> {
        part::read_word(address)
    }

    fn write(&mut self, address: u32, word: &[u8; WORD]) -> bool {
        part::write_word(address, word)
    }
}

impl SlotFlash for CodeFlash {
    fn erase(&mut self, sector: u32) -> bool {
        let start = part::prepare_erase(sector);
        // Note(unsafe): it lies in ITCM, and the slot that runs is never erased.
        unsafe { erase_from_itcm(start) };
        part::end_erase()
    }
}

/// The slot the code runs from.
pub(crate) fn running_slot() -> Slot {
    // Note(unsafe): a register of the core, which the start-up code has set.
    let vectors = unsafe { (*SCB::PTR).vtor.read() };
    Slot::around(vectors).unwrap_or(Slot::A)
}

/// Erases what is prepared, and feeds the watchdog until it is done. Calls nothing: all else is in the bank.
///
/// # Safety
/// `start` is of [`part::prepare_erase`].
#[inline(never)]
#[unsafe(link_section = ".itcm.erase")]
unsafe fn erase_from_itcm(start: u32) {
    let masked: u32;
    // Note(unsafe): interrupts are let in again as they were; the rest is the caller's promise.
    unsafe {
        asm!("mrs {}, primask", "cpsid i", out(reg) masked, options(nomem, nostack));
        part::start_erase(start);
        asm!("dsb", options(nostack));
        let mut looks = 0;
        while part::is_busy() && looks < LOOKS {
            (WATCHDOG_KEY as *mut u32).write_volatile(FEED);
            asm!("2:", "subs {0}, #1", "bne 2b", inout(reg) TURNS => _, options(nomem, nostack));
            looks += 1;
        }
        asm!("msr primask, {}", in(reg) masked, options(nomem, nostack));
    }
}
