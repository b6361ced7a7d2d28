//! Caches of the Cortex-M7.

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
