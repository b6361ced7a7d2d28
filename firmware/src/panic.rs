//! The one exit: exciter to rest, reason kept over the reset, the flash left to
//! finish its word, reset.
//!
//! Panics, hard faults, clock failures, a supply that falls and unexpected interrupts all end
//! here. The reason is kept over the reset ([`crate::retained`]) and reported by the next start.

use crate::{board, retained};
use calib_firmware::restarts::{Reason, Way};
use core::fmt::Write;
use core::panic::PanicInfo;
use core::sync::atomic::{AtomicBool, Ordering, compiler_fence};
use cortex_m_rt::exception;
use embassy_stm32::interrupt;

/// Keeps as much as fits: a long message must not lose its beginning.
struct Truncating(Reason);

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
pub(crate) fn leave(way: Way, reason: core::fmt::Arguments<'_>) -> ! {
    static LEAVING: AtomicBool = AtomicBool::new(false);
    cortex_m::interrupt::disable();
    board::silence_now();
    // A fault while formatting must not keep the board from resetting.
    if !LEAVING.swap(true, Ordering::AcqRel) {
        let mut text = Truncating(Reason::new());
        let _ = text.write_fmt(reason);
        defmt::error!("{=str}", text.0.as_str());
        retained::leave(way, text.0);
    }
    compiler_fence(Ordering::SeqCst);
    #[cfg(feature = "hitl")]
    end_tests(false);
    #[cfg(not(feature = "hitl"))]
    board::restart()
}

/// The end of the tests on the target: of the debugger's run, or by the watchdog.
#[cfg(feature = "hitl")]
pub(crate) fn end_tests(passed: bool) -> ! {
    /// `C_DEBUGEN` of DHCSR: somebody hears a call of the host (ARMv7-M, C1.6.2).
    const DEBUGGER: u32 = 1;
    // Note(unsafe): a register that always exists.
    if unsafe { (*cortex_m::peripheral::DCB::PTR).dhcsr.read() } & DEBUGGER != 0 {
        semihosting::process::exit(i32::from(!passed));
    }
    loop {
        cortex_m::asm::nop();
    }
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    match info.location() {
        // The place first: it is what must not be cut off.
        Some(place) => leave(
            Way::Fault,
            format_args!("{}:{}: {}", place.file(), place.line(), info.message()),
        ),
        None => leave(Way::Fault, format_args!("{}", info.message())),
    }
}

/// Drivers log their message and then come here, without it: what is left to
/// tell is where, and what the DMA says.
#[defmt::panic_handler]
fn driver_panic() -> ! {
    let active = cortex_m::peripheral::SCB::vect_active();
    let flags = [0, 1].map(|half| embassy_stm32::pac::DMA1.isr(half).read().0);
    leave(
        Way::Fault,
        format_args!(
            "a driver gave up in {active:?}, DMA1 flags {:#010x} {:#010x}",
            flags[0], flags[1]
        ),
    )
}

/// The clock security system found the clock at OSC_IN gone; nothing else raises it here.
#[exception]
unsafe fn NonMaskableInt() -> ! {
    leave(
        Way::Outside,
        format_args!("clock failure: the clock at OSC_IN is gone"),
    )
}

/// The supply falls: silent while there is still enough of it to be silent with.
#[interrupt]
fn PVD_AVD() {
    leave(Way::Outside, format_args!("the supply fell below 2.8 V"))
}

#[exception]
unsafe fn DefaultHandler(number: i16) -> ! {
    leave(
        Way::Fault,
        format_args!("interrupt {number} has no handler"),
    )
}
