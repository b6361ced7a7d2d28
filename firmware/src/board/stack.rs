//! How deep the stack ever was.
//!
//! The start-up code fills the stack with [`cortex_m_rt::STACK_PAINT_VALUE`];
//! what still holds it was never used.

unsafe extern "C" {
    static _stack_end: u32;
    static _stack_start: u32;
}

/// Bytes of the stack that were never used.
///
/// # Timing
/// Some 4 instructions for each unused word.
pub(crate) fn unused_bytes() -> u32 {
    let (mut word, start) = (&raw const _stack_end, &raw const _stack_start);
    let mut unused = 0;
    // Note(unsafe): between two symbols of the linker, word aligned; the words
    // below the stack pointer belong to nobody.
    while word < start && unsafe { word.read_volatile() } == cortex_m_rt::STACK_PAINT_VALUE {
        unused += 4;
        word = unsafe { word.add(1) };
    }
    unused
}
