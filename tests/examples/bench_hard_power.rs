//! `./run bench hard-power [CUTS [SEED]]`: the supply of the board fails while a host measures, stores,
//! downloads and releases: in words and erases of the flash, in starts, and at any other instant. Words
//! and sectors are left torn and cannot be read, every RAM comes up with other content.
//!
//! Most cuts are seen on a second board that gets the flash such a cut leaves; a second host, who knows
//! what the first one was told by then, looks for all of it. One in 25 comes on the first board as well,
//! which must then start to the same flash, byte for byte.

use calib_tests::rigged::Fault;
use calib_tests::supply::{Desk, Survey};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

fn main() -> Result<(), Fault> {
    let mut numbers = std::env::args()
        .skip(1)
        .map_while(|text| text.parse::<u64>().ok());
    let cuts = u32::try_from(numbers.next().unwrap_or(2000))?;
    let seed = numbers.next().unwrap_or(1);
    let start = Instant::now();
    let folders = [tempfile::tempdir()?, tempfile::tempdir()?];
    let mut desk = Desk::new(folders[0].path())?;
    desk.fill()?;
    let survey = Survey::new(&desk, folders[1].path(), cuts, seed)?;
    let survey = Arc::new(Mutex::new(survey));
    println!(
        "record area filled after {:.0} s",
        start.elapsed().as_secs_f64()
    );
    while !of(&survey).is_done() {
        desk.surveyed(&survey)?;
        println!(
            "{} cuts, {:.0} s",
            of(&survey).tally().cuts(),
            start.elapsed().as_secs_f64()
        );
    }
    desk.end(&survey)?;
    let survey = of(&survey);
    report(&survey, &desk, start)
}

fn of(survey: &Mutex<Survey>) -> MutexGuard<'_, Survey> {
    survey.lock().unwrap_or_else(PoisonError::into_inner)
}

/// After a failure nothing is reported: `main` has ended with what was lost.
fn report(survey: &Survey, desk: &Desk, start: Instant) -> Result<(), Fault> {
    let tally = survey.tally();
    println!(
        "\ncut while          cuts   between   in a word   in an erase   lost   failed starts"
    );
    let rows = tally
        .rows
        .iter()
        .map(|(doing, row)| (format!("{doing:?}"), *row));
    let again = [("start, again".to_owned(), tally.again)];
    for (name, row) in rows.chain(again) {
        println!(
            "  {name:<14} {:>6} {:>9} {:>11} {:>13}      0               0",
            row.cuts(),
            row.between,
            row.words,
            row.sectors
        );
    }
    let poisoned = desk.poisoned_loads() + survey.poisoned_loads();
    let compared = desk.compared() + tally.compared;
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "{} cuts, {} starts, {} rounds of work after one; {} cuts came, and the first board had the \
         second one's flash;\nloads of words that could not be read {poisoned}; records told {}, \
         compared {compared} times: none lost, none half there; sector erases {}; {seconds:.0} s",
        tally.cuts(),
        tally.starts,
        tally.rounds,
        tally.came,
        desk.records(),
        desk.erases(),
    );
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        let json = serde_json::json!({
            "cuts": tally.cuts(), "starts": tally.starts, "came": tally.came,
            "poisoned_loads": poisoned, "records": desk.records(),
            "compared": compared, "lost": 0, "failed_starts": 0, "seconds": seconds,
        });
        std::fs::write(path, json.to_string())?;
    }
    Ok(())
}
