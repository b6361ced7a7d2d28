//! Start, the loop over all kernels, and what every image needs.

use crate::lock_in::{LockIn, kernel_lock_in};
use crate::shipping::{kernel_estimate, kernel_fold};
use crate::sines::{kernel_sines, kernel_sines_libm, kernel_sines_micromath};
use crate::table::{Table, kernel_table};
use crate::{PAIRS, itcm, shipping};
use calib_core::converter::Width;
use calib_core::correlation::{Block, Correlator, FoldMemory};
use calib_core::phase::PhaseWalk;
use calib_core::tone::Tone;
use core::hint::black_box;
use core::panic::PanicInfo;
use defmt_rtt as _;
use static_cell::ConstStaticCell;

/// Where every kernel ends for the bench.
#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn kernel_done() {
    // Keeps the call: an empty function would be left out.
    cortex_m::asm::nop();
}

#[cortex_m_rt::entry]
fn main() -> ! {
    // Where the firmware has it; empty, it is all zero.
    #[unsafe(link_section = ".axisram")]
    static FOLD: ConstStaticCell<FoldMemory> = ConstStaticCell::new(FoldMemory::new());
    static TABLE: ConstStaticCell<Table> = ConstStaticCell::new(Table::EMPTY);
    // The start-up code leaves this memory alone.
    // Note(unsafe): nobody has used it yet, and its value is all zero.
    unsafe {
        (&raw const FOLD).cast_mut().write_bytes(0, 1);
        itcm::load();
    }
    let tone = shipping::TONE;
    let block = Block::measuring(tone, 10 * PAIRS as u32);
    // Note(unwrap): nothing else takes them.
    let mut correlator = Correlator::new(FOLD.take(), Width::of_bits(16), block, 0);
    let table = TABLE.take();
    table.fill(tone);
    let mut lock_in = LockIn::new(tone);
    let pairs = pairs(tone);
    // Up to a turn, as `libm` and `micromath` are called.
    let mut index = 0.0;
    let angles = [(); PAIRS].map(|()| {
        index += 1.0;
        index * core::f32::consts::TAU / PAIRS as f32
    });
    loop {
        correlator.start(block, 0);
        for _ in 0..10 {
            kernel_fold(&mut correlator, black_box(&pairs));
            kernel_done();
        }
        black_box(kernel_estimate(&correlator));
        kernel_done();
        black_box(kernel_lock_in(&mut lock_in, black_box(&pairs)));
        kernel_done();
        black_box(kernel_table(table, black_box(&pairs)));
        kernel_done();
        black_box(kernel_sines(PhaseWalk::new(tone, 0)));
        kernel_done();
        black_box(kernel_sines_libm(black_box(&angles)));
        kernel_done();
        black_box(kernel_sines_micromath(black_box(&angles)));
        kernel_done();
    }
}

/// A sine of 30 000 codes on the reference, half of it on the other channel.
fn pairs(tone: Tone) -> [u32; PAIRS] {
    let mut walk = PhaseWalk::new(tone, 0);
    [(); PAIRS].map(|()| {
        let (cosine, _) = walk.next_cos_sin();
        let code = |peak: f32| (32_768.0 + peak * cosine) as u32;
        code(30_000.0) | (code(15_000.0) << 16)
    })
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    loop {
        cortex_m::asm::nop();
    }
}
