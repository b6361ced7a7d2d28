//! `./run bench hard-power [CUTS [SEED]]`: the supply of the board fails while a host measures, stores,
//! downloads and releases, every second time in a flash operation. Words and sectors are left torn and
//! cannot be read, every RAM comes up with other content, and after a cut in an erase the next is in the
//! start that mends it. After each cut the host looks for all it was told before.

use calib_tests::bench::Fault;
use calib_tests::supply::{Cut, Desk, Doing, Met};
use calib_twin::runner::Torn;
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// Longest time from power-on to a cut: the session of a round, a sector erase and a good deal more.
const SPELL_MS: u64 = 3000;
/// A start, with the scan of a full area.
const START_MS: u64 = 300;
/// Operations on the flash in a round: two copies of settings, a record, a release. Every one of
/// them is cut in turn.
const OPERATIONS: u64 = 130;
/// How far into an operation.
const FRACTIONS: [f64; 5] = [0.02, 0.25, 0.5, 0.75, 0.98];

/// Circumstances of the cuts.
#[derive(Default)]
struct Tally {
    cuts: u32,
    words: u32,
    sectors: u32,
    doing: BTreeMap<Doing, u32>,
}

impl Tally {
    fn note(&mut self, met: Met) {
        self.cuts += 1;
        *self.doing.entry(met.doing).or_default() += 1;
        match met.torn {
            Torn::Nothing => {}
            Torn::Word { .. } => self.words += 1,
            Torn::Sector { .. } => self.sectors += 1,
        }
    }
}

fn main() -> Result<(), Fault> {
    let mut numbers = std::env::args()
        .skip(1)
        .map_while(|text| text.parse::<u64>().ok());
    let cuts = numbers.next().unwrap_or(2000);
    let mut random = numbers.next().unwrap_or(1);
    let folder = tempfile::tempdir()?;
    let mut desk = Desk::new(folder.path())?;
    desk.fill()?;
    let start = Instant::now();
    let mut tally = Tally::default();
    for number in 0..cuts {
        let cut = draw(number, &mut random);
        let met = desk.cut(cut);
        tally.note(met.map_err(|fault| format!("cut {number}, {cut:?}: {fault}"))?);
        if tally.cuts.is_multiple_of(50) {
            report(&tally, &desk, start)?;
        }
    }
    desk.look()?;
    report(&tally, &desk, start)
}

/// Random instants and flash operations in turn.
fn draw(number: u64, random: &mut u64) -> Cut {
    // Numerical Recipes' linear congruence; its upper bits are good enough to spread instants.
    *random = random
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    let drawn = *random >> 33;
    let fraction = FRACTIONS[drawn as usize % FRACTIONS.len()];
    match number % 8 {
        7 => Cut::InErase(fraction),
        // The erase that mends that sector, if there is one.
        0 => Cut::InOperation { nth: 1, fraction },
        2 => Cut::After(Duration::from_micros(drawn % (START_MS * 1000))),
        1 | 3 | 5 => Cut::InOperation {
            nth: 1 + (number / 8 * 3 + number % 8 / 2) % OPERATIONS,
            fraction,
        },
        _ => Cut::After(Duration::from_micros(drawn % (SPELL_MS * 1000))),
    }
}

/// After a failure nothing is reported: `main` has ended with what was lost.
fn report(tally: &Tally, desk: &Desk, start: Instant) -> Result<(), Fault> {
    let Tally {
        cuts,
        words,
        sectors,
        doing,
    } = tally;
    let (records, compared, erases) = (desk.records(), desk.compared(), desk.erases());
    let poisoned = desk.poisoned_loads();
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "cuts of the supply: {cuts}, with {words} torn words and {sectors} torn sectors; while {doing:?}\n\
         loads of words that could not be read {poisoned}, starts that failed 0\n\
         records told {records}, compared {compared} times: none lost, none half there; \
         sector erases {erases}; {seconds:.0} s"
    );
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        let json = serde_json::json!({
            "cuts": cuts, "torn_words": words, "torn_sectors": sectors,
            "poisoned_loads": poisoned, "records": records,
            "compared": compared, "lost": 0, "seconds": seconds,
        });
        std::fs::write(path, json.to_string())?;
    }
    Ok(())
}
