//! Reads of flash words whose check bits do not fit, and the option bytes.

use rigless::device::ResetCause;
use rigless::mcu::{Mcu, Operate};
use rigless::soc::stm32h743::generated::flash::Register as Flash;
use rigless::soc::stm32h743::generated::{DAC, DMA1, DMAMUX1, FLASH, dac, dma1, dmamux1};
use rigless::time::VirtualNanos;

use super::Rigged;
use crate::board::{PartFault, RECORD_FLASH};
use rigless::soc::Width;

/// Writes that `./run brown-out` has the probe do.
#[path = "../../../../xtask/src/option_writes.rs"]
mod option_writes;

const CORRECTED: u64 = 1 << 25;
const POISONED: u64 = 1 << 26;
/// `TCIF`, `HTIF` and `TEIF` of stream 1.
const DONE: u64 = 1 << 11;
const HALF: u64 = 1 << 10;
const FAILED: u64 = 1 << 9;

/// DMA1 stream 1 plays 32 codes from flash: words 1 and 2 of the bank.
fn play_from_flash(rigged: &mut Rigged) {
    use dma1::Register as Dma;
    rigged.write(&DAC, dac::Register::Dhr12r1, 2048);
    rigged.write(&DAC, dac::Register::Cr, 1 | 1 << 1 | 5 << 2 | 1 << 12);
    rigged.write(&DMAMUX1, dmamux1::Register::DmamuxC1cr, 67);
    rigged.write(&DMA1, Dma::S1par, DAC.base + 8);
    rigged.write(&DMA1, Dma::S1m0ar, RECORD_FLASH + 32);
    rigged.write(&DMA1, Dma::S1ndtr, 32);
    // Memory to peripheral, memory increment, halfwords, enabled.
    rigged.write(
        &DMA1,
        Dma::S1cr,
        0b01 << 6 | 1 << 10 | 0b01 << 11 | 0b01 << 13 | 1,
    );
    rigged.start_sample_clock(1280);
    rigged.run(34 * 20_000);
}

#[test]
fn a_dma_read_of_a_word_that_does_not_fit_sets_its_flag_and_goes_on() {
    let second = RECORD_FLASH + 64;
    for (fault, flag) in [
        (None, 0),
        (
            Some(PartFault::PoisonedWord {
                address: second + 9,
            }),
            POISONED,
        ),
        (
            Some(PartFault::WeakWord {
                address: second + 9,
            }),
            CORRECTED,
        ),
        // Of a word nobody reads nothing is known.
        (
            Some(PartFault::PoisonedWord {
                address: second + 32,
            }),
            0,
        ),
    ] {
        let mut rigged = Rigged::new();
        if let Some(fault) = fault {
            rigged.part.fail(VirtualNanos(0), fault);
        }
        play_from_flash(&mut rigged);
        // All 32 items were moved, and no transfer error.
        let flags = rigged.read(&DMA1, dma1::Register::Lisr) & (DONE | HALF | FAILED);
        assert_eq!(flags, DONE | HALF, "{fault:?}");
        assert_eq!(
            rigged.read(&FLASH, Flash::Sr2) & (CORRECTED | POISONED),
            flag
        );
        // Word 2 of the bank, in flash words of 32 bytes.
        let failing = if flag == 0 { 0 } else { 2 };
        assert_eq!(rigged.read(&FLASH, Flash::EccFa2r), failing, "{fault:?}");
        assert_eq!(rigged.read(&FLASH, Flash::Sr1) & (CORRECTED | POISONED), 0);
        rigged.write(&FLASH, Flash::Ccr2, CORRECTED | POISONED);
        assert_eq!(rigged.read(&FLASH, Flash::Sr2) & (CORRECTED | POISONED), 0);
        assert_eq!(rigged.read(&FLASH, Flash::EccFa2r), 0);
    }
}

/// RM0433 Rev 9, 4.9.8: brown-out level in bits 2 and 3, watchdog by software in 4, protection in 8 to 15.
#[test]
fn a_board_is_set_up_with_brown_out_level_3_and_a_part_of_the_factory_is_not() {
    let mut rigged = Rigged::new();
    assert_eq!(rigged.read(&FLASH, Flash::OptsrCur), 0x0006_AAFC);
    let factory = PartFault::OptionBytes {
        status: 0x0006_AAF0,
    };
    rigged.part.fail(VirtualNanos(0), factory);
    rigged.part.reset(VirtualNanos(0), ResetCause::PowerOn);
    assert_eq!(rigged.read(&FLASH, Flash::OptsrCur), 0x0006_AAF0);
    assert_eq!(rigged.read(&FLASH, Flash::OptsrPrg), 0x0006_AAF0);
    rigged.part.mend();
    assert_eq!(rigged.read(&FLASH, Flash::OptsrCur), 0x0006_AAFC);
}

#[test]
fn what_the_probe_writes_sets_the_level_and_nothing_else() {
    use option_writes::{CURRENT, is_set, writes};
    // As the factory leaves it; and with a read-out protection of level 1, which must stay.
    for before in [0x0006_AAF0_u32, 0x0006_11F0] {
        let mut rigged = Rigged::new();
        let fault = PartFault::OptionBytes { status: before };
        rigged.part.fail(VirtualNanos(0), fault);
        let read = |rigged: &mut Rigged| {
            let at = VirtualNanos(rigged.now);
            let word = rigged.part.read(at, u64::from(CURRENT), Width::W32);
            word.unwrap() as u32
        };
        assert_eq!(read(&mut rigged), before);
        assert!(!is_set(before));
        for (address, word) in writes(before) {
            let at = VirtualNanos(rigged.now);
            let written = rigged
                .part
                .write(at, u64::from(address), Width::W32, u64::from(word));
            written.unwrap();
            rigged.settle();
            rigged.run(100_000_000);
        }
        rigged.run(3_000_000_000);
        assert_eq!(read(&mut rigged), before | 0b1100);
        assert!(is_set(before | 0b1100));
        rigged
            .part
            .reset(VirtualNanos(rigged.now), ResetCause::PowerOn);
        assert_eq!(read(&mut rigged), before | 0b1100, "after power off");
    }
}
