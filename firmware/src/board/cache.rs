//! Caches and cycle counter of the Cortex-M7.

/// Turns the instruction cache on and leaves the data cache off.
///
/// Data and stack are in DTCM, which is never cached; the DMA buffers in AXI
/// SRAM would need maintenance around every transfer, and the 25 kHz of bus
/// reads they cost is nothing. So no line of data can ever be stale.
pub(super) fn enable_instruction_cache() {
    // Note(unwrap): init; taken once, here.
    let mut core = unsafe { cortex_m::Peripherals::steal() };
    core.SCB.enable_icache();
}

/// Starts the cycle counter, by which work is timed.
pub(super) fn count_cycles() {
    // Note(unsafe): init; nobody else has either.
    let mut core = unsafe { cortex_m::Peripherals::steal() };
    core.DCB.enable_trace();
    // The M7's counter is locked against software (PM0253 Rev 6, 4.9).
    cortex_m::peripheral::DWT::unlock();
    core.DWT.enable_cycle_counter();
}
