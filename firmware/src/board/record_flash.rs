//! Flash bank 2, where the records are: reads that survive a torn word, words, sectors.
//!
//! Reads are checked reads ([`calib_boot::part`]), which the loader makes as well.
//!
//! A word with one wrong bit is mended by the part and read like any other; the self-test counts those.
//!
//! The flag is the bank's, not the load's, so nothing else may read the bank
//! meanwhile. No DMA is pointed at it, and to the core it is device memory that is
//! never executed, by a region of the MPU: then it reads nothing ahead and caches
//! nothing, nor does an instruction fetch on speculation wait for an erase of the
//! bank (field report: FOME 685). All loads are aligned, as such memory needs.
//! Should a torn word get the blame all the same, the read is repeated.

use core::future::poll_fn;
use core::slice;
use core::task::Poll;

use calib_boot::layout::SLOT_BYTES;
use calib_boot::part::{Fit, load};
use calib_core::self_test::WrongWords;
use calib_firmware::archive::CheckedFlash;
use cortex_m::asm::{delay, dsb, isb};
use cortex_m::peripheral::MPU;
use embassy_futures::yield_now;
use embassy_stm32::interrupt::{self, InterruptExt};
use embassy_stm32::pac::flash::{Bank, regs};
use embassy_stm32::{Peri, pac, peripherals};
use embassy_sync::waitqueue::AtomicWaker;
use embassy_time::{Duration, with_timeout};
use embedded_storage_async::nor_flash::{
    ErrorType, NorFlash, NorFlashError, NorFlashErrorKind, ReadNorFlash,
};

/// The record area: all of bank 2, as offsets in flash (see `memory.x`).
pub(crate) const RECORD_AREA: core::ops::Range<u32> = 0x10_0000..0x20_0000;
/// Address of offset 0.
const FLASH_START: u32 = 0x0800_0000;
/// Bytes programmed at once, with check bits of their own.
const WORD: usize = 32;
/// Bytes of a sector.
const SECTOR: usize = 128 * 1024;
/// Keys that unlock them, in this order (RM0433 Rev 9, 4.5.1).
const KEYS: [u32; 2] = [0x4567_0123, 0xCDEF_89AB];
/// `PSIZE`: 32 bits at once.
const PARALLELISM: u8 = 2;
/// Longest time of an operation; a sector takes 2.2 s at most with this (DS12110 Rev 10, table 150).
const LONGEST: Duration = Duration::from_secs(10);
/// Words of the core loaded while faults are ignored: some microseconds.
const LOADED_AT_ONCE: usize = 64;
/// How often a word is read before it is called poisoned.
const TRIES: usize = 3;

/// Region of the MPU, the one with the last word, and its attributes (PM0253, MPU): device memory,
/// full access, never executed, 2 to the power of 20 bytes.
const REGION: u32 = 15;
const REGION_ATTRIBUTES: u32 = 1 << 28 | 0b011 << 24 | 1 << 18 | 1 << 16 | (20 - 1) << 1 | 1;
/// `MPU_CTRL`: on, with the default map where there is no region.
const MPU_ON: u32 = 1 << 2 | 1;

static ENDED: AtomicWaker = AtomicWaker::new();

/// Bank 2, by offsets in flash.
pub(crate) struct RecordFlash {
    /// Held, so that nothing else erases or programs.
    _flash: Peri<'static, peripherals::FLASH>,
}

/// Why the flash did not do it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, defmt::Format)]
pub(crate) enum FlashFailed {
    /// The check bits of a word do not fit.
    Poisoned,
    /// The operation ended with an error, or not at all.
    Operation,
    /// Not a whole word or sector.
    Alignment,
    /// Outside of the record area.
    Range,
}

impl NorFlashError for FlashFailed {
    fn kind(&self) -> NorFlashErrorKind {
        match self {
            Self::Alignment => NorFlashErrorKind::NotAligned,
            Self::Range => NorFlashErrorKind::OutOfBounds,
            Self::Poisoned | Self::Operation => NorFlashErrorKind::Other,
        }
    }
}

#[embassy_stm32::interrupt]
fn FLASH() {
    // The flags stay for whoever waits.
    bank().cr().modify(|w| {
        w.set_eopie(false);
        w.set_operrie(false);
    });
    ENDED.wake();
}

impl RecordFlash {
    pub(super) fn new(flash: Peri<'static, peripherals::FLASH>) -> Self {
        make_device_memory();
        interrupt::FLASH.unpend();
        // Note(unsafe): its handler is the one above.
        unsafe { interrupt::FLASH.enable() };
        Self { _flash: flash }
    }

    /// Programs one word that is erased.
    async fn program(&mut self, offset: u32, word: &[u8]) -> Result<(), FlashFailed> {
        unlock();
        bank().cr().modify(|w| {
            w.set_pg(true);
            w.set_psize(PARALLELISM);
        });
        barrier();
        let (values, _) = word.as_chunks::<4>();
        for (address, value) in (FLASH_START + offset..).step_by(4).zip(values) {
            // Note(unsafe): a whole aligned word within the record area; the flash
            // gathers what is stored there and starts with its last byte.
            unsafe { (address as *mut u32).write_volatile(u32::from_le_bytes(*value)) };
        }
        barrier();
        let ended = end().await;
        bank().cr().modify(|w| w.set_pg(false));
        lock();
        ended
    }

    async fn erase_sector(&mut self, offset: u32) -> Result<(), FlashFailed> {
        unlock();
        bank().cr().modify(|w| {
            w.set_ser(true);
            w.set_psize(PARALLELISM);
            w.set_snb(((offset - RECORD_AREA.start) / SECTOR as u32) as u8);
        });
        bank().cr().modify(|w| w.set_start(true));
        barrier();
        let ended = end().await;
        bank().cr().modify(|w| w.set_ser(false));
        lock();
        ended
    }
}

impl CheckedFlash for RecordFlash {
    fn is_poisoned(error: &FlashFailed) -> bool {
        *error == FlashFailed::Poisoned
    }
}

impl ErrorType for RecordFlash {
    type Error = FlashFailed;
}

impl ReadNorFlash for RecordFlash {
    const READ_SIZE: usize = 1;

    async fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), FlashFailed> {
        check_range(offset, bytes.len())?;
        let mut buffer = [0; LOADED_AT_ONCE];
        let (mut at, mut rest) = (offset, bytes);
        while !rest.is_empty() {
            let skipped = at as usize % 4;
            let length = rest.len().min(4 * LOADED_AT_ONCE - skipped);
            let words = buffer.split_at_mut((skipped + length).div_ceil(4)).0;
            let address = FLASH_START + at - skipped as u32;
            if !(0..TRIES).any(|_| load(address, words) != Fit::Poisoned) {
                return Err(FlashFailed::Poisoned);
            }
            let (part, behind) = rest.split_at_mut(length);
            // Note(unsafe): the words that were loaded, as the bytes they are.
            let loaded = unsafe { slice::from_raw_parts(words.as_ptr().cast(), 4 * words.len()) };
            if let Some(loaded) = loaded.get(skipped..skipped + length) {
                part.copy_from_slice(loaded);
            }
            at += length as u32;
            rest = behind;
        }
        Ok(())
    }

    fn capacity(&self) -> usize {
        RECORD_AREA.end as usize
    }
}

impl NorFlash for RecordFlash {
    const WRITE_SIZE: usize = WORD;
    const ERASE_SIZE: usize = SECTOR;

    async fn erase(&mut self, from: u32, to: u32) -> Result<(), FlashFailed> {
        check_range(from, to.saturating_sub(from) as usize)?;
        check_alignment(from, to as usize, SECTOR)?;
        for sector in (from..to).step_by(SECTOR) {
            self.erase_sector(sector).await?;
        }
        Ok(())
    }

    async fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), FlashFailed> {
        check_range(offset, bytes.len())?;
        check_alignment(offset, bytes.len(), WORD)?;
        for (at, word) in (offset..).step_by(WORD).zip(bytes.chunks(WORD)) {
            self.program(at, word).await?;
        }
        Ok(())
    }
}

/// Waits for the word that is being programmed: 0.3 ms at most, so that a restart does not tear it.
/// A sector that is being erased is not waited for, which would take seconds: the next start
/// erases it again.
///
/// # Timing
/// Returns after some milliseconds whatever the flash says; interrupts may be off.
// A function of its own: `./run no-panic` follows it.
#[inline(never)]
pub(crate) fn finish_word() {
    // At 480 MHz a microsecond each, at the 64 MHz of a start more.
    for _ in 0..2000 {
        if !is_busy() || bank().cr().read().ser() {
            break;
        }
        delay(480);
    }
}

/// Reads all of the image, or of the record area, and counts the words whose check bits do not fit. The
/// record area must not be written or erased meanwhile.
///
/// # Timing
/// Some 10 ms for a MiB, in pieces of microseconds.
async fn wrong_words(range: core::ops::Range<u32>) -> WrongWords {
    let mut wrong = WrongWords::default();
    let mut buffer = [0; LOADED_AT_ONCE];
    for at in range.step_by(size_of_val(&buffer)) {
        let address = FLASH_START + at;
        if load(address, &mut buffer) != Fit::Good {
            for (at, word) in (address..).step_by(WORD).zip(buffer.chunks_mut(WORD / 4)) {
                match load(at, word) {
                    Fit::Good => {}
                    Fit::Corrected => wrong.corrected += 1,
                    Fit::Poisoned => wrong.unreadable += 1,
                }
            }
        }
        yield_now().await;
    }
    wrong
}

/// Words of the image whose check bits do not fit.
pub(crate) async fn wrong_words_of_image() -> WrongWords {
    let start = super::running_slot().start() - FLASH_START;
    wrong_words(start..start + SLOT_BYTES).await
}

/// Wrong words of the record area, which must be at rest.
pub(crate) async fn wrong_words_of_records() -> WrongWords {
    wrong_words(RECORD_AREA).await
}

/// Registers of bank 2.
fn bank() -> Bank {
    pac::FLASH.bank(1)
}

/// Keeps the core from reading or fetching from the bank on speculation.
fn make_device_memory() {
    // Note(unsafe): the registers exist; what is mapped here is only loaded and stored aligned.
    unsafe {
        let mpu = &*MPU::PTR;
        cortex_m::asm::dmb();
        mpu.rnr.write(REGION);
        mpu.rbar.write(FLASH_START + RECORD_AREA.start);
        mpu.rasr.write(REGION_ATTRIBUTES);
        mpu.ctrl.modify(|before| before | MPU_ON);
        barrier();
    }
}

fn check_range(offset: u32, length: usize) -> Result<(), FlashFailed> {
    let end = (offset as usize).saturating_add(length);
    match offset >= RECORD_AREA.start && end <= RECORD_AREA.end as usize {
        true => Ok(()),
        false => Err(FlashFailed::Range),
    }
}

fn check_alignment(offset: u32, length: usize, unit: usize) -> Result<(), FlashFailed> {
    match (offset as usize).is_multiple_of(unit) && length.is_multiple_of(unit) {
        true => Ok(()),
        false => Err(FlashFailed::Alignment),
    }
}

/// Waits for the end of an operation and says how it was.
async fn end() -> Result<(), FlashFailed> {
    let ended = poll_fn(|context| {
        ENDED.register(context.waker());
        bank().cr().modify(|w| {
            w.set_eopie(true);
            w.set_operrie(true);
        });
        match is_busy() {
            true => Poll::Pending,
            false => Poll::Ready(bank().sr().read()),
        }
    });
    let ended = with_timeout(LONGEST, ended).await;
    bank().cr().modify(|w| {
        w.set_eopie(false);
        w.set_operrie(false);
    });
    let status = ended.map_err(|_| FlashFailed::Operation)?;
    clear_flags(bank());
    match is_clean(status) {
        true => Ok(()),
        false => Err(FlashFailed::Operation),
    }
}

fn is_clean(status: regs::Sr) -> bool {
    let refused = status.wrperr() || status.pgserr() || status.strberr() || status.incerr();
    !refused && !status.operr()
}

fn is_busy() -> bool {
    let status = bank().sr().read();
    status.bsy() || status.qw()
}

/// The flags are cleared by a register of their own; writing them does nothing.
fn clear_flags(bank: Bank) {
    bank.ccr().write(|w| {
        w.set_clr_eop(true);
        w.set_clr_wrperr(true);
        w.set_clr_pgserr(true);
        w.set_clr_strberr(true);
        w.set_clr_incerr(true);
        w.set_clr_operr(true);
        w.set_clr_rdperr(true);
        w.set_clr_rdserr(true);
        w.set_clr_sneccerr(true);
        w.set_clr_dbeccerr(true);
    });
}

fn unlock() {
    clear_flags(bank());
    if bank().cr().read().lock() {
        for key in KEYS {
            bank().keyr().write_value(key);
        }
    }
}

fn lock() {
    bank().cr().modify(|w| w.set_lock(true));
}

fn barrier() {
    isb();
    dsb();
}
