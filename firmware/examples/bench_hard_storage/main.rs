//! `./run bench hard-storage [CUTS]`: the archive on a strict flash of the
//! part's size. How many records fit, how the sectors wear over 100 000
//! records, and what random power cuts leave.
//!
//! Flash, desk and session are those of the archive's own tests: words are
//! programmed once, a cut leaves torn words and torn sectors that cannot be read.
//! Every second cut is followed by one in the start that mends it.

#[path = "../../src/archive/tests/desk.rs"]
mod desk;
#[path = "../../src/archive/tests/flash.rs"]
#[allow(dead_code, reason = "tests use more of it")]
mod flash;
#[path = "../../src/archive/tests/told.rs"]
mod told;

use calib_core::settings::Settings;
use desk::{Desk, store};
use embassy_futures::block_on;
use flash::MockFlash;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::io::Write as _;

/// Sectors of bank 2, and of a part small enough to go round quickly.
const REAL: usize = 128 * 1024;
const SMALL: usize = 16 * 1024;
/// Records of the wear test, and points of each: a one-third-octave list.
const RECORDS: u32 = 100_000;
const POINTS: usize = 31;
/// The part's endurance, erases of a sector (DS12110 Rev 11, table 141).
const ENDURANCE: u32 = 10_000;

type Fault = Box<dyn std::error::Error>;

fn main() -> Result<(), Fault> {
    let cuts = std::env::args().nth(1).and_then(|text| text.parse().ok());
    let fit = capacity()?;
    println!("records of {POINTS} points that fit:       {fit}");
    let (least, most) = wear()?;
    let spread_percent = 100.0 * f64::from(most - least) / f64::from(least);
    println!(
        "erases per sector after {RECORDS} records: {least} to {most}, {spread_percent:.1} % apart, \
         {ENDURANCE} allowed"
    );
    let cuts = cuts.unwrap_or(20_000);
    let met = random_cuts(cuts)?;
    println!(
        "random power cuts: {cuts}, and {} in the mending start after; torn words {}, torn sectors {}, \
         reads of poisoned words {}; records checked {}, lost 0, half there 0, starts that failed 0",
        met.in_starts, met.torn_words, met.torn_sectors, met.poisoned_reads, met.checked
    );
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        let mut file = std::fs::File::create(path)?;
        write!(
            file,
            "{{\"records_that_fit\": {fit}, \"erases_least\": {least}, \"erases_most\": {most}, \
             \"spread_percent\": {spread_percent:.2}, \"cuts\": {cuts}, \"cuts_in_starts\": {}, \
             \"torn_words\": {}, \"torn_sectors\": {}, \"poisoned_reads\": {}, \"lost\": 0}}",
            met.in_starts, met.torn_words, met.torn_sectors, met.poisoned_reads
        )?;
    }
    if fit < 500 || spread_percent > 20.0 || most > ENDURANCE {
        return Err("a figure is outside of what docs/reliability.md promises".into());
    }
    Ok(())
}

/// Stores until the area refuses the next run.
fn capacity() -> Result<u32, Fault> {
    let flash = MockFlash::<REAL>::erased(calib_firmware::archive::SECTORS);
    let mut desk = Desk::new();
    let mut archive = desk.open(&flash)?;
    let settings = Settings::field_calibrator();
    let mut stored = 0;
    while block_on(archive.check_room(POINTS)).is_ok() {
        store(&mut archive, POINTS, stored, &settings)?;
        stored += 1;
    }
    Ok(stored)
}

/// Stores and releases; the least and the most erases of a sector.
fn wear() -> Result<(u32, u32), Fault> {
    let flash = MockFlash::<REAL>::erased(calib_firmware::archive::SECTORS);
    let mut desk = Desk::new();
    let mut archive = desk.open(&flash)?;
    let settings = Settings::field_calibrator();
    for seed in 0..RECORDS {
        block_on(archive.check_room(POINTS))?;
        let (id, _) = store(&mut archive, POINTS, seed, &settings)?;
        if seed % 50 == 49 {
            block_on(archive.release(id))?;
        }
    }
    let erases = flash.0.borrow().erases.clone();
    let least = erases.iter().min().copied().unwrap_or(0);
    Ok((least, erases.iter().max().copied().unwrap_or(0)))
}

/// Counts over the cuts.
#[derive(Default)]
struct Met {
    /// Records compared with what was told.
    checked: u64,
    /// Cuts in a start that mended.
    in_starts: u64,
    torn_words: u64,
    torn_sectors: u64,
    poisoned_reads: u64,
}

/// A session of stores, settings, releases and restarts, cut again and again
/// at a random operation; after each cut everything that was reported is
/// compared.
fn random_cuts(cuts: u64) -> Result<Met, Fault> {
    let flash = MockFlash::<SMALL>::erased(calib_firmware::archive::SECTORS);
    let mut told = told::Told::default();
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut number = 0;
    let mut met = Met::default();
    for cut in 0..cuts {
        // From at once to the length of a dozen records.
        let ahead = random.next_u64() % 400 + 1;
        let at = flash.0.borrow().operations + ahead;
        flash.0.borrow_mut().cut_at = Some(at);
        let mut desk = Desk::new();
        if let Ok(mut archive) = desk.open(&flash) {
            while told::step(&mut archive, &mut told, number).is_ok() {
                number += 1;
            }
        }
        flash.0.borrow_mut().cut_at = None;
        number += 1;
        if cut % 2 == 1 {
            met.in_starts += u64::from(cut_start(&mut desk, &flash));
        }
        let context = |fault: String| format!("cut {cut}, operation {at}: {fault}");
        met.checked += told.check(&mut desk.open(&flash)?).map_err(context)?;
    }
    let cells = flash.0.borrow();
    (met.torn_words, met.torn_sectors) = (cells.torn_words, cells.torn_sectors);
    met.poisoned_reads = cells.poisoned_reads;
    Ok(met)
}

/// Starts, with a cut in the first operation on the flash; whether there was one.
fn cut_start(desk: &mut Desk, flash: &MockFlash<SMALL>) -> bool {
    let at = flash.0.borrow().operations + 1;
    flash.0.borrow_mut().cut_at = Some(at);
    let was_cut = desk.open(flash).is_err();
    flash.0.borrow_mut().cut_at = None;
    was_cut
}
