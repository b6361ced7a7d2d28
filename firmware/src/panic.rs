//! The one exit: exciter to rest, reason kept over the reset, the flash left to
//! finish its word, reset.
//!
//! Panics, hard faults, clock failures, a supply that falls and unexpected interrupts all end
//! here. The reason is
//! written to a part of RAM that no start-up code touches, with a checksum,
//! and reported by the next start.

use crate::board;
use calib_protocol::frame::CRC;
use core::cell::UnsafeCell;
use core::fmt::Write;
use core::panic::PanicInfo;
use core::sync::atomic::{AtomicBool, Ordering, compiler_fence};
use cortex_m_rt::{ExceptionFrame, exception};
use embassy_stm32::interrupt;
use heapless::String;

/// Longest reason kept, bytes.
pub(crate) const REASON_BYTES: usize = 160;

#[repr(C)]
struct Retained {
    checksum: u32,
    length: u32,
    text: [u8; REASON_BYTES],
}

struct RetainedCell(UnsafeCell<Retained>);
// Note(unsafe): written only with interrupts off on the way into a reset, and
// read once before any task runs.
unsafe impl Sync for RetainedCell {}

#[unsafe(link_section = ".retained")]
static RETAINED: RetainedCell = RetainedCell(UnsafeCell::new(Retained {
    checksum: 0,
    length: 0,
    text: [0; REASON_BYTES],
}));

fn checksum(length: u32, text: &[u8]) -> u32 {
    let mut digest = CRC.digest();
    digest.update(b"panic");
    digest.update(&length.to_le_bytes());
    digest.update(text);
    digest.finalize()
}

/// The reason of the last panic, once; the memory is cleared.
pub(crate) fn take_reason() -> Option<String<REASON_BYTES>> {
    // Note(unsafe): called before interrupts and tasks; volatile, because the
    // compiler believes that nobody wrote here.
    let retained = unsafe {
        let kept = RETAINED.0.get().read_volatile();
        (&raw mut (*RETAINED.0.get()).checksum).write_volatile(0);
        kept
    };
    let text = retained.text.get(..retained.length as usize)?;
    if retained.checksum != checksum(retained.length, text) {
        return None;
    }
    core::str::from_utf8(text).ok()?.try_into().ok()
}

fn keep(reason: &str) {
    let mut kept = Retained {
        checksum: 0,
        length: reason.len().min(REASON_BYTES) as u32,
        text: [0; REASON_BYTES],
    };
    for (to, from) in kept.text.iter_mut().zip(reason.bytes()) {
        *to = from;
    }
    let text = kept.text.get(..kept.length as usize).unwrap_or_default();
    kept.checksum = checksum(kept.length, text);
    // Note(unsafe): interrupts are off and the board is about to reset.
    unsafe { RETAINED.0.get().write_volatile(kept) };
}

/// Keeps as much as fits: a long message must not lose its beginning.
struct Truncating(String<REASON_BYTES>);

impl Write for Truncating {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        for character in text.chars() {
            if self.0.push(character).is_err() {
                break;
            }
        }
        Ok(())
    }
}

/// Rest, remember, let the flash finish its word, reset. With interrupts off no new operation on
/// the flash begins.
fn leave(reason: core::fmt::Arguments<'_>) -> ! {
    static LEAVING: AtomicBool = AtomicBool::new(false);
    cortex_m::interrupt::disable();
    board::silence_now();
    // A fault while formatting must not keep the board from resetting.
    if !LEAVING.swap(true, Ordering::AcqRel) {
        let mut text = Truncating(String::new());
        let _ = text.write_fmt(reason);
        keep(&text.0);
        defmt::error!("{=str}", text.0.as_str());
    }
    compiler_fence(Ordering::SeqCst);
    board::restart()
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    match info.location() {
        // The place first: it is what must not be cut off.
        Some(place) => leave(format_args!(
            "{}:{}: {}",
            place.file(),
            place.line(),
            info.message()
        )),
        None => leave(format_args!("{}", info.message())),
    }
}

/// Drivers log their message and then come here, without it: what is left to
/// tell is where, and what the DMA says.
#[defmt::panic_handler]
fn driver_panic() -> ! {
    let active = cortex_m::peripheral::SCB::vect_active();
    let flags = [0, 1].map(|half| embassy_stm32::pac::DMA1.isr(half).read().0);
    leave(format_args!(
        "a driver gave up in {active:?}, DMA1 flags {:#010x} {:#010x}",
        flags[0], flags[1]
    ))
}

#[exception]
unsafe fn HardFault(frame: &ExceptionFrame) -> ! {
    // Note(unsafe): a read of a status register that always exists.
    let cause = unsafe { (*cortex_m::peripheral::SCB::PTR).cfsr.read() };
    leave(format_args!(
        "hard fault at {:#010x}, caller {:#010x}, cause {:#010x}",
        frame.pc(),
        frame.lr(),
        cause
    ))
}

/// The clock security system found the clock at OSC_IN gone; nothing else raises it here.
#[exception]
unsafe fn NonMaskableInt() -> ! {
    leave(format_args!("clock failure: the clock at OSC_IN is gone"))
}

/// The supply falls: silent while there is still enough of it to be silent with.
#[interrupt]
fn PVD_AVD() {
    leave(format_args!("the supply fell below 2.8 V"))
}

#[exception]
unsafe fn DefaultHandler(number: i16) -> ! {
    leave(format_args!("interrupt {number} has no handler"))
}
