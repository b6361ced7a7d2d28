//! Flash of the STM32H743 without a driver: checked reads, and words of bank 1.
//!
//! A word whose programming or erase was cut has check bits that do not fit, and a plain load of it is a
//! bus fault (RM0433 Rev 9, 4.7.8). A *checked read* has the core ignore bus faults meanwhile (FAULTMASK
//! with BFHFNMIGN: PM0253, CCR) and asks the flash afterwards whether it met two wrong bits (`DBECCERR`).
//! The failing address in `FLASH_ECC_FAR` is not used: revisions Y and W may not update it (ES0392 2.2.7).
//!
//! The flag is the bank's, not the load's. Should a torn word that something else met get the blame, the
//! read is repeated.

use crate::layout::{FLASH, SECTOR, WORD};
use core::arch::asm;
use cortex_m::asm::{dsb, isb};
use cortex_m::peripheral::SCB;

/// How often a word is read before it is called poisoned.
const TRIES: usize = 3;
/// `CCR.BFHFNMIGN`, and the bits of a bus fault that was ignored in `CFSR`.
const IGNORE_BUS_FAULTS: u32 = 1 << 8;
const PRECISE_BUS_FAULT: u32 = 1 << 9 | 1 << 15;

/// Registers of bank 1; those of bank 2 lie [`BANK_STRIDE`] behind (RM0433 Rev 9, 4.9).
const REGISTERS: u32 = 0x5200_2000;
const BANK_STRIDE: u32 = 0x100;
/// Bytes of a bank.
const BANK: u32 = 0x10_0000;
const KEYR: u32 = 0x04;
const CR: u32 = 0x0C;
const SR: u32 = 0x10;
const CCR: u32 = 0x14;
/// Keys that unlock `CR`, in this order (4.5.1).
const KEYS: [u32; 2] = [0x4567_0123, 0xCDEF_89AB];
const LOCK: u32 = 1;
const PG: u32 = 1 << 1;
const SER: u32 = 1 << 2;
/// `PSIZE`: 32 bits at once.
const PARALLELISM: u32 = 2 << 4;
const START: u32 = 1 << 7;
const BUSY: u32 = 1 | 1 << 2;
/// `WRPERR`, `PGSERR`, `STRBERR`, `INCERR`, `OPERR`.
const REFUSED: u32 = 1 << 17 | 1 << 18 | 1 << 19 | 1 << 21 | 1 << 22;
const CORRECTED: u32 = 1 << 25;
const POISONED: u32 = 1 << 26;
/// Everything that `CCR` clears but the end of a CRC.
const ALL_FLAGS: u32 = 0x07EF_0000;

/// How the check bits of what was loaded fit.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Fit {
    /// They do.
    Good,
    /// A bit was wrong, and is mended.
    Corrected,
    /// Two were: what was loaded means nothing.
    Poisoned,
}

/// Loads words of the core from flash, all of one bank, `address` a multiple of 4.
pub fn load(address: u32, words: &mut [u32]) -> Fit {
    let bank = (address - FLASH) / BANK;
    // Note(unsafe): the registers exist and no other code looks at the fault bits while faults are
    // masked; whole aligned words of the flash.
    unsafe {
        let core = &*SCB::PTR;
        asm!("cpsid f", options(nostack));
        let before = core.ccr.read();
        core.ccr.write(before | IGNORE_BUS_FAULTS);
        set(bank, CCR, ALL_FLAGS);
        barrier();
        for (place, at) in words.iter_mut().zip((address..).step_by(4)) {
            *place = (at as *const u32).read_volatile();
        }
        dsb();
        let fit = match get(bank, SR) {
            status if status & POISONED != 0 => Fit::Poisoned,
            status if status & CORRECTED != 0 => Fit::Corrected,
            _ => Fit::Good,
        };
        set(bank, CCR, ALL_FLAGS);
        if fit == Fit::Poisoned {
            core.cfsr.write(PRECISE_BUS_FAULT);
        }
        core.ccr.write(before);
        barrier();
        asm!("cpsie f", options(nostack));
        fit
    }
}

/// The flash word at an address; none where its check bits do not fit.
pub fn read_word(address: u32) -> Option<[u8; WORD]> {
    let mut words = [0; WORD / 4];
    if !(0..TRIES).any(|_| load(address, &mut words) != Fit::Poisoned) {
        return None;
    }
    let mut bytes = [0; WORD];
    let (places, _) = bytes.as_chunks_mut::<4>();
    let values = words.iter().map(|word| word.to_le_bytes());
    places
        .iter_mut()
        .zip(values)
        .for_each(|(place, value)| *place = value);
    Some(bytes)
}

/// Programs a word of bank 1 that is erased; whether the flash says that it did.
///
/// # Timing
/// Some 0.2 ms, in which the core waits for its next instruction from bank 1.
pub fn write_word(address: u32, word: &[u8; WORD]) -> bool {
    unlock();
    // Note(unsafe): registers of the flash; a whole aligned word of bank 1, which nothing that runs is in.
    unsafe {
        set(0, CR, PG | PARALLELISM);
        barrier();
        let (values, _) = word.as_chunks::<4>();
        for (at, value) in (address..).step_by(4).zip(values) {
            (at as *mut u32).write_volatile(u32::from_le_bytes(*value));
        }
        barrier();
        while get(0, SR) & BUSY != 0 {}
        let is_done = get(0, SR) & REFUSED == 0;
        set(0, CR, 0);
        set(0, CR, LOCK);
        is_done
    }
}

/// Prepares the erase of the sector of bank 1 at an address: the value for `CR` that starts it. What
/// starts it and waits for its end must not lie in bank 1.
pub fn prepare_erase(sector: u32) -> u32 {
    unlock();
    let prepared = SER | PARALLELISM | ((sector - FLASH) / SECTOR) << 8;
    // Note(unsafe): a register of the flash.
    unsafe { set(0, CR, prepared) };
    prepared | START
}

/// Ends what [`prepare_erase`] began; whether the flash says that it did.
pub fn end_erase() -> bool {
    // Note(unsafe): registers of the flash.
    unsafe {
        let is_done = get(0, SR) & REFUSED == 0;
        set(0, CR, 0);
        set(0, CR, LOCK);
        is_done
    }
}

/// Starts what was prepared.
///
/// # Safety
/// `start` is what [`prepare_erase`] returned, and the caller does not lie in bank 1.
#[inline(always)]
pub unsafe fn start_erase(start: u32) {
    // Note(unsafe): the caller's promise.
    unsafe { set(0, CR, start) };
}

/// Whether bank 1 is at work.
#[inline(always)]
pub fn is_busy() -> bool {
    // Note(unsafe): a register of the flash.
    unsafe { get(0, SR) & BUSY != 0 }
}

/// The register, and no error of before: they stay until they are cleared.
fn unlock() {
    // Note(unsafe): registers of the flash.
    unsafe {
        set(0, CCR, ALL_FLAGS);
        if get(0, CR) & LOCK != 0 {
            for key in KEYS {
                set(0, KEYR, key);
            }
        }
    }
}

#[inline(always)]
unsafe fn get(bank: u32, register: u32) -> u32 {
    // Note(unsafe): registers of the flash.
    unsafe { ((REGISTERS + bank * BANK_STRIDE + register) as *const u32).read_volatile() }
}

#[inline(always)]
unsafe fn set(bank: u32, register: u32, value: u32) {
    // Note(unsafe): as above.
    unsafe { ((REGISTERS + bank * BANK_STRIDE + register) as *mut u32).write_volatile(value) };
}

fn barrier() {
    isb();
    dsb();
}
