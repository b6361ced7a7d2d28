//! The loader on the part.

use calib_boot::choice::choose;
use calib_boot::layout::{Slot, WORD};
use calib_boot::manifest::PublicKey;
use calib_boot::trusted::{NOTE_BYTES, note, seed_of};
use calib_boot::{BootFlash, part};
use core::panic::PanicInfo;
use cortex_m::peripheral::{Peripherals, SCB};
// Its linker script is asked for.
use defmt as _;

/// The key whose images are started.
const TRUSTED: PublicKey = seed_of(env!("CALIB_TRUSTED_KEY"));

/// Where the firmware reads it.
#[used]
#[unsafe(link_section = ".trusted")]
static TRUSTED_NOTE: [u8; NOTE_BYTES] = note(&TRUSTED);

/// Independent watchdog: key, prescaler and reload register, and their values (RM0433 Rev 9, 45.4). 1000
/// counts of 32 kHz / 256 are 8 s: two images are read and two signatures verified in some 2 s at the 64 MHz
/// of a reset, if every byte of an image takes 100 cycles.
const WATCHDOG: [(u32, u32); 5] = [
    (0x5800_4800, 0xCCCC),
    (0x5800_4800, 0x5555),
    (0x5800_4804, 6),
    (0x5800_4808, 1000),
    FEED,
];
const FEED: (u32, u32) = (0x5800_4800, 0xAAAA);

#[cortex_m_rt::entry]
fn main() -> ! {
    WATCHDOG.into_iter().for_each(set);
    // Note(unsafe): the only code there is.
    let mut core = unsafe { Peripherals::steal() };
    core.SCB.enable_icache();
    match choose(&mut Part, &TRUSTED) {
        Some(slot) => start(slot),
        // Nothing to start: the watchdog has the part look again, and a probe finds it here.
        None => rest(),
    }
}

/// Writes a register of the watchdog.
fn set((register, value): (u32, u32)) {
    // Note(unsafe): nobody else has it yet.
    unsafe { (register as *mut u32).write_volatile(value) };
}

/// Leaves for an image, which has as long as the loader had.
fn start(slot: Slot) -> ! {
    set(FEED);
    // Note(unsafe): a whole image begins with its vectors, stack and entry first.
    unsafe {
        (*SCB::PTR).vtor.write(slot.start());
        cortex_m::asm::dsb();
        cortex_m::asm::bootload(slot.start() as *const u32)
    }
}

fn rest() -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}

/// Flash of the part.
struct Part;

impl BootFlash for Part {
    fn read(&mut self, address: u32) -> Option<[u8; WORD]> {
        part::read_word(address)
    }

    fn write(&mut self, address: u32, word: &[u8; WORD]) -> bool {
        part::write_word(address, word)
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    SCB::sys_reset()
}
