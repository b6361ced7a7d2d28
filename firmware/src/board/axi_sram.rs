//! AXI SRAM: DMA buffers, and what is too large for the tightly coupled RAM.
//!
//! DMA1 and DMA2 have no path to the tightly coupled memories where stack and
//! small statics live (RM0433 Rev 8, table 3). The start-up code leaves this
//! memory alone, so [`clear`] comes first: then everything in the section
//! `.axisram` is zero, which also sets the memory's check bits (ECC). So only
//! values that are all zero may be declared there: see [`AllZero`].

use super::description::Silicon;
use super::selected::CLOCKS;
use calib_core::broadband::{PeriodMemory, SpectraMemory};
use calib_core::correlation::FoldMemory;
use calib_core::stored_list::StoredLists;
use calib_firmware::archive::Directory;
use calib_firmware::link::Link;
use calib_protocol::record::Record;

unsafe extern "C" {
    static mut __axisram_start: u32;
    static mut __axisram_end: u32;
}

/// `AXI_TARG7_FN_MOD`: how the interconnect issues accesses to AXI SRAM (RM0433 Rev 8, 2.2.4).
const TARGET_7_FN_MOD: *mut u32 = 0x5100_8108 as *mut u32;
/// `READ_ISS_OVERRIDE`: one read at a time.
const READ_ISS_OVERRIDE: u32 = 1;

/// Fills the section with zeros.
///
/// # Safety
/// Nothing in the section may have been used yet.
pub(crate) unsafe fn clear() {
    if matches!(CLOCKS.silicon, Silicon::Y) {
        // Note(unsafe): a register of the interconnect, which always answers. Without it a read
        // that waits for another master may return wrong data (ES0392 Rev 13, 2.2.9).
        unsafe { TARGET_7_FN_MOD.write_volatile(READ_ISS_OVERRIDE) };
    }
    let mut word = &raw mut __axisram_start;
    let end = &raw mut __axisram_end;
    while word < end {
        // Note(unsafe): between two symbols of the linker, word aligned.
        unsafe {
            word.write_volatile(0);
            word = word.add(1);
        }
    }
}

/// Types with a value whose bytes are all zero.
///
/// # Safety
/// Every byte of `ZERO` that is initialised must be zero.
pub(crate) unsafe trait AllZero {
    /// That value.
    const ZERO: Self;
}

// Note(unsafe): numbers; sums of zero; a vector of length zero; a link on which
// nothing came; a record of empty texts and lists, first variants and zeros; no lists.
unsafe impl<const N: usize> AllZero for [u8; N] {
    const ZERO: Self = [0; N];
}
unsafe impl<const N: usize> AllZero for [u16; N] {
    const ZERO: Self = [0; N];
}
unsafe impl<const N: usize> AllZero for [u32; N] {
    const ZERO: Self = [0; N];
}
unsafe impl AllZero for FoldMemory {
    const ZERO: Self = FoldMemory::new();
}
unsafe impl AllZero for SpectraMemory {
    const ZERO: Self = SpectraMemory::new();
}
unsafe impl AllZero for PeriodMemory {
    const ZERO: Self = PeriodMemory::new();
}
unsafe impl AllZero for Directory {
    const ZERO: Self = Directory::new();
}
unsafe impl AllZero for Link {
    const ZERO: Self = Link::new();
}
unsafe impl AllZero for StoredLists {
    const ZERO: Self = StoredLists::NONE;
}
unsafe impl AllZero for Record {
    const ZERO: Self = Record::BLANK;
}

/// A value that lies in AXI SRAM once more, in the ELF file alone: a test looks whether it is all
/// zero there, since of the section itself no content is kept.
#[repr(transparent)]
pub(crate) struct Promise<T>(pub(crate) T);
// Note(unsafe): nobody ever looks at it.
unsafe impl<T> Sync for Promise<T> {}

/// Puts a value that lies in AXI SRAM where a test sees it.
macro_rules! promise {
    ($type:ty, $zero:expr) => {
        const _: () = {
            #[used]
            #[unsafe(link_section = ".axisram_promise")]
            static PROMISE: $crate::board::Promise<$type> = $crate::board::Promise($zero);
        };
    };
}
pub(crate) use promise;

/// Declares a static in AXI SRAM, to be taken once.
macro_rules! axi_static {
    ($name:ident: $type:ty) => {
        $crate::board::promise!($type, <$type as $crate::board::AllZero>::ZERO);
        #[unsafe(link_section = ".axisram")]
        static $name: static_cell::ConstStaticCell<$type> =
            static_cell::ConstStaticCell::new(<$type as $crate::board::AllZero>::ZERO);
    };
}
pub(crate) use axi_static;
