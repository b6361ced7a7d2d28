//! Tests on the part itself, in place of the instrument: what an emulator takes on trust.
//!
//! Built into the image with the feature `hitl`, so that the drivers tested are those that ship. Each test
//! says what it found, which is worth more than that it passed. The last one leaves the board to its
//! watchdog.

use crate::board::{
    BLOCK_PAIRS, Board, CORE_MHZ, Lamp, RECORD_AREA, RecordFlash, SILICON, Silicon, axi_static,
    option_bytes,
};
use calib_core::converter::Width;
use calib_core::correlation::{Block, Correlator, FoldMemory};
use calib_core::self_test::BROWN_OUT_LEVEL;
use calib_core::tone::Tone;
use calib_firmware::archive::CheckedFlash;
use calib_firmware::restarts::LeftOut;
use cortex_m::peripheral::DWT;
use embassy_futures::select::{Either, select};
use embassy_futures::yield_now;
use embassy_stm32::pac::{DBGMCU, IWDG1};
use embassy_time::{Instant, Timer};
use embedded_storage_async::nor_flash::{NorFlash, ReadNorFlash};

/// The last sector of the record area, in offsets of the flash; erased at both ends of the tests.
const SPARE: u32 = RECORD_AREA.end - SECTOR;
const SECTOR: u32 = 128 << 10;
/// A bank that erases must not stop the core for longer: a fortieth of the watchdog's time.
const LONGEST_STALL_MS: f32 = 6.0;
/// Longest evaluation of a block, ms (docs/safety.md).
const EVALUATION_MS: f32 = 17.0;

/// Fault that a test found.
type Wrong = &'static str;

/// Carries out all tests. Ends the program of a debugger that hears it, with 0 if all passed.
pub(crate) async fn run() -> ! {
    crate::fault::enable();
    let mut board = Board::start(LeftOut::NOTHING).await;
    let mut failed = 0;
    let mut note = |name: &str, found: Result<(), Wrong>| match found {
        Ok(()) => defmt::println!("test {=str} ... ok", name),
        Err(wrong) => {
            failed += 1;
            defmt::println!("test {=str} ... FAILED: {=str}", name, wrong);
        }
    };
    note("silicon", silicon());
    note("option bytes", options());
    note("clock", clock().await);
    note("panel", panel(&mut board).await);
    let answer = board.digitiser.is_some();
    note("converters", check(answer, "a converter does not answer"));
    note("evaluation", evaluation());
    board.watchdog.pet();
    note(
        "flash",
        flash(&mut board.flash, || board.watchdog.pet()).await,
    );
    note("watchdog", watchdog().await);
    match failed {
        0 => defmt::println!("all tests passed"),
        failed => defmt::println!("{=u32} tests FAILED", failed),
    }
    crate::panic::end_tests(failed == 0)
}

fn check(holds: bool, wrong: Wrong) -> Result<(), Wrong> {
    if holds { Ok(()) } else { Err(wrong) }
}

/// The part is of the silicon the image is for (RM0433 Rev 9, 60.5.8).
fn silicon() -> Result<(), Wrong> {
    let code = DBGMCU.idc().read().0;
    let (device, revision) = (code & 0xFFF, code >> 16);
    defmt::println!("  device {=u32:#x}, revision {=u32:#x}", device, revision);
    check(device == 0x450, "this is no STM32H743")?;
    let is_v = revision >= 0x2001;
    check(
        is_v == matches!(SILICON, Silicon::V),
        "the image is for other silicon: do not run it",
    )
}

fn options() -> Result<(), Wrong> {
    let options = option_bytes();
    defmt::println!("  {=u32:#010x}", options.0);
    check(
        options.brown_out_level() == BROWN_OUT_LEVEL,
        "the brown-out level is not set: `./run brown-out`",
    )?;
    match options.deviations().next() {
        Some(deviation) => Err(deviation.text()),
        None => Ok(()),
    }
}

/// The core's cycles in 100 ms of the timer that keeps the time: both come of one PLL, by dividers and a
/// voltage scale that a mistake shows in.
async fn clock() -> Result<(), Wrong> {
    let (cycles, since) = (DWT::cycle_count(), Instant::now());
    Timer::after_millis(100).await;
    let cycles = DWT::cycle_count().wrapping_sub(cycles);
    let measured_mhz = cycles as f32 / since.elapsed().as_micros() as f32;
    defmt::println!(
        "  core {=f32} MHz by the timer, {=f32} set",
        measured_mhz,
        CORE_MHZ
    );
    // The timer ticks in 31 us.
    check(
        (measured_mhz / CORE_MHZ - 1.0).abs() < 1e-3,
        "the core and the timer run at different clocks",
    )
}

/// Lamps to look at, and a button nobody holds.
async fn panel(board: &mut Board) -> Result<(), Wrong> {
    let lamps = &mut board.lamps;
    for lamp in [&mut lamps.green, &mut lamps.yellow, &mut lamps.red] {
        let lamp: &mut Lamp = lamp;
        lamp.set(true);
        Timer::after_millis(150).await;
        lamp.set(false);
        board.watchdog.pet();
    }
    check(
        !board.button.is_down(),
        "the button is held, or its pin is another one",
    )
}

/// Correlates a second of samples, and times the longest piece of work.
fn evaluation() -> Result<(), Wrong> {
    axi_static!(FOLD: FoldMemory);
    /// 160 Hz: the fold does not fit the buffers.
    const TONE: Tone = Tone {
        cycles: 2,
        period_samples: 625,
    };
    let block = Block::measuring(TONE, 50_000);
    let mut correlator = Correlator::new(FOLD.take(), Width::of_bits(16), block, 0);
    let mut pairs = [0; BLOCK_PAIRS];
    let mut longest_push = 0;
    for start in (0..50_000).step_by(BLOCK_PAIRS) {
        for (place, pair) in (start..).zip(&mut pairs) {
            // A square wave of the tone: any samples take the same time.
            let high = place * 2 % 625 < 312;
            *pair = if high { 0xC000_C000 } else { 0x4000_4000 };
        }
        let before = DWT::cycle_count();
        correlator.push(&pairs);
        longest_push = longest_push.max(DWT::cycle_count().wrapping_sub(before));
    }
    let before = DWT::cycle_count();
    let estimate = correlator.estimate();
    let evaluated = DWT::cycle_count().wrapping_sub(before);
    let ms = |cycles: u32| cycles as f32 / CORE_MHZ / 1e3;
    defmt::println!(
        "  {=u32} cycles for a buffer, {=u32} for an evaluation: {=f32} ms of {=f32}",
        longest_push,
        evaluated,
        ms(evaluated),
        EVALUATION_MS
    );
    check(estimate.is_some(), "the block is not full")?;
    check(
        ms(evaluated) < EVALUATION_MS,
        "an evaluation takes too long",
    )?;
    check(ms(longest_push) < 1.0, "a buffer takes too long")
}

/// A word and a sector: written, read, spoiled, erased. That reads of a word programmed twice do not fault
/// is the instrument's life after a power cut; that an erase does not stop the core is its watchdog's.
async fn flash(flash: &mut RecordFlash, mut pet: impl FnMut()) -> Result<(), Wrong> {
    let mut word = [0; 32];
    for at in (SPARE..RECORD_AREA.end).step_by(word.len()) {
        let read = flash.read(at, &mut word).await;
        let is_free = read.is_ok() && word == [0xFF; 32];
        check(
            is_free,
            "the last sector of the record area is in use: download and release the records first",
        )?;
    }
    let pattern: [u8; 32] = core::array::from_fn(|place| place as u8 ^ 0xA5);
    let since = Instant::now();
    let written = flash.write(SPARE, &pattern).await;
    let took_us = since.elapsed().as_micros();
    check(written.is_ok(), "a word cannot be programmed")?;
    let read = flash.read(SPARE, &mut word).await;
    check(
        read.is_ok() && word == pattern,
        "a word is not what was programmed",
    )?;
    pet();
    // Over it: its check bits are those of no word.
    let again = flash.write(SPARE, &[0x3C; 32]).await;
    let read = flash.read(SPARE, &mut word).await;
    let told = match &read {
        Err(error) if RecordFlash::is_poisoned(error) => "cannot be read",
        Err(_) => "fails otherwise",
        Ok(()) => "is read",
    };
    defmt::println!(
        "  a word takes {=u64} us; written over ({=bool}) it {=str}",
        took_us,
        again.is_ok(),
        told
    );
    check(
        told != "fails otherwise",
        "a spoiled word is not told as one",
    )?;
    let stall_ms = erase(flash, pet).await?;
    let read = flash.read(SPARE, &mut word).await;
    check(
        read.is_ok() && word == [0xFF; 32],
        "an erase did not heal the word",
    )?;
    check(
        stall_ms < LONGEST_STALL_MS,
        "an erase of the record area stops the core",
    )
}

/// Erases the sector; the longest time the core stood meanwhile, ms.
async fn erase(flash: &mut RecordFlash, mut pet: impl FnMut()) -> Result<f32, Wrong> {
    let since = Instant::now();
    let mut longest = 0;
    let look = async {
        let mut before = DWT::cycle_count();
        loop {
            let now = DWT::cycle_count();
            longest = longest.max(now.wrapping_sub(before));
            before = now;
            pet();
            yield_now().await;
        }
    };
    let erased = match select(flash.erase(SPARE, RECORD_AREA.end), look).await {
        Either::First(erased) => erased,
        Either::Second(never) => never,
    };
    let stall_ms = longest as f32 / CORE_MHZ / 1e3;
    defmt::println!(
        "  a sector takes {=u64} ms, the core stood for {=f32} ms at most",
        since.elapsed().as_millis(),
        stall_ms
    );
    check(erased.is_ok(), "the sector cannot be erased")?;
    Ok(stall_ms)
}

/// Without its key the watchdog takes no other time.
async fn watchdog() -> Result<(), Wrong> {
    let before = IWDG1.rlr().read().rl();
    IWDG1.rlr().write(|w| w.set_rl(0xFFF));
    Timer::after_millis(5).await;
    let after = IWDG1.rlr().read().rl();
    defmt::println!("  reload {=u16}, then {=u16}", before, after);
    check(
        before == after && before != 0xFFF,
        "the watchdog lets itself be set without its key",
    )
}
