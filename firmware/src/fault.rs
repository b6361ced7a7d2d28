//! Faults of the processor, on a stack of their own.
//!
//! A fault whose frame finds no room on the stack is a fault in turn. Where memory, bus and usage
//! faults have exceptions of their own, the second one is a hard fault, and its handler runs; in a hard
//! fault it would lock the processor up, with the exciter driven until the watchdog ends it (ARMv7-M
//! architecture reference manual, B1.5.11 and B1.5.15). So they are switched on, all four come here,
//! and nothing is pushed before the stack is another one.

use crate::board::promise;
use crate::panic::leave;
use calib_firmware::restarts::Way;
use core::arch::naked_asm;
use core::cell::UnsafeCell;

/// To silence, to format the reason and to keep it takes less than half of it.
const STACK_BYTES: usize = 8192;

#[repr(C, align(8))]
struct Stack(UnsafeCell<[u8; STACK_BYTES]>);
// Note(unsafe): used as a stack alone, and once: who comes here never returns. In AXI SRAM, where
// there is room, and all zero.
unsafe impl Sync for Stack {}

#[unsafe(link_section = ".axisram")]
static STACK: Stack = Stack(UnsafeCell::new([0; STACK_BYTES]));
promise!(Stack, Stack(UnsafeCell::new([0; STACK_BYTES])));

unsafe extern "C" {
    static _stack_start: u32;
    static _stack_end: u32;
}

/// Registers as an exception leaves them on the stack (ARMv7-M, B1.5.6).
#[repr(C)]
struct Frame {
    registers: [u32; 5],
    link: u32,
    place: u32,
    status: u32,
}

/// Gives memory, bus and usage faults exceptions of their own.
pub(crate) fn enable() {
    /// `USGFAULTENA`, `BUSFAULTENA` and `MEMFAULTENA` of SHCSR (ARMv7-M, B3.2.13).
    const ALL: u32 = 0b111 << 16;
    // Note(unsafe): every handler is there.
    unsafe {
        (*cortex_m::peripheral::SCB::PTR)
            .shcsr
            .modify(|value| value | ALL)
    };
}

/// From now on a debugger catches no fault before its handler has run: it would halt the core with
/// the exciter driven. `VC_HARDERR` to `VC_MMERR` and `VC_CORERESET` of DEMCR (ARMv7-M, C1.6.5).
pub(crate) fn let_through() {
    const CATCHES: u32 = 0x7F1;
    // Note(unsafe): no other bit changes.
    unsafe {
        (*cortex_m::peripheral::DCB::PTR)
            .demcr
            .modify(|value| value & !CATCHES)
    };
}

/// Takes the other stack, and hands on where the frame should be.
#[unsafe(naked)]
#[unsafe(no_mangle)]
unsafe extern "C" fn HardFault() {
    naked_asm!(
        "mrs r0, msp",
        "movw r1, #:lower16:({stack} + {bytes})",
        "movt r1, #:upper16:({stack} + {bytes})",
        "msr msp, r1",
        "b {fault}",
        stack = sym STACK,
        bytes = const STACK_BYTES,
        fault = sym fault,
    )
}

#[unsafe(naked)]
#[unsafe(no_mangle)]
unsafe extern "C" fn MemoryManagement() {
    naked_asm!("b {fault}", fault = sym HardFault)
}

#[unsafe(naked)]
#[unsafe(no_mangle)]
unsafe extern "C" fn BusFault() {
    naked_asm!("b {fault}", fault = sym HardFault)
}

#[unsafe(naked)]
#[unsafe(no_mangle)]
unsafe extern "C" fn UsageFault() {
    naked_asm!("b {fault}", fault = sym HardFault)
}

/// The end of every fault.
extern "C" fn fault(frame: *const Frame) -> ! {
    crate::board::silence_now();
    let (end, start) = (
        &raw const _stack_end as usize,
        &raw const _stack_start as usize,
    );
    let fits = start - size_of::<Frame>();
    // Note(unsafe): status registers that always exist; the frame only where the stack is.
    let cause = unsafe { (*cortex_m::peripheral::SCB::PTR).cfsr.read() };
    if !(end..=fits).contains(&(frame as usize)) {
        leave(
            Way::Fault,
            format_args!(
                "the stack overflowed: {:#010x}, cause {cause:#010x}",
                frame as usize
            ),
        )
    }
    let Frame { link, place, .. } = unsafe { frame.read_volatile() };
    leave(
        Way::Fault,
        format_args!("hard fault at {place:#010x}, caller {link:#010x}, cause {cause:#010x}"),
    )
}
