//! ITCM: code that never waits for the flash, nor for a cache that has just dropped it.
//!
//! `memory.x` says which. The core fetches from it at its own clock (RM0433 Rev 8, 2.2 and table 3); no
//! controller writes there, so it stays what [`load`] copied.

unsafe extern "C" {
    static mut __itcm_start: u32;
    static mut __itcm_end: u32;
    static __itcm_load: u32;
}

/// Copies the section from flash.
///
/// # Safety
/// Nothing in the section may have been called yet.
pub(crate) unsafe fn load() {
    let mut from = &raw const __itcm_load;
    let mut to = &raw mut __itcm_start;
    let end = &raw mut __itcm_end;
    while to < end {
        // Note(unsafe): between symbols of the linker, word aligned, and as long there as here.
        unsafe {
            to.write_volatile(from.read_volatile());
            from = from.add(1);
            to = to.add(1);
        }
    }
    // What was written is fetched from now on.
    cortex_m::asm::dsb();
    cortex_m::asm::isb();
}
