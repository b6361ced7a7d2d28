//! `./run bench hard-long [MINUTES [faults]]`: calibrating, storing, downloading and releasing without a
//! pause, for 24 virtual hours when nothing else is said; with `faults`, both cables are short once in
//! ten minutes. No restart, no overrun, and exactly 50 000 pairs in a second.

use calib_core::verdict::Verdict;
use calib_host::session;
use calib_protocol::message::RunState;
use calib_protocol::record::{self, Sha256Sum};
use calib_tests::bench::{Bench, Fault, point};
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::rig_port::ShortedInputs;
use std::path::Path;
use std::time::{Duration, Instant};

const SAMPLE_RATE_HZ: f64 = 50_000.0;
/// Time between two faults, and between two reports.
const TEN_MINUTES: Duration = Duration::from_secs(600);

/// What a long run has come to.
#[derive(Default)]
struct Tally {
    runs: u32,
    faults: u32,
    /// SHA-256 of every record so far, chained: equal where two runs did the same.
    records: Sha256Sum,
    /// From power on to the first pair, s, as the first report has it.
    begun_s: Option<f64>,
}

fn main() -> Result<(), Fault> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let minutes = arguments.first().and_then(|text| text.parse().ok());
    let with_faults = arguments.iter().any(|word| word == "faults");
    let goal = Duration::from_secs(60 * minutes.unwrap_or(24 * 60_u64));
    let start = Instant::now();
    let mut bench = Bench::with_rig(&Rig::standard())?;
    let folder = tempfile::tempdir()?;
    let mut tally = Tally::default();
    let (mut next_report, mut next_fault) = (TEN_MINUTES, Duration::ZERO);
    while bench.board().elapsed() < goal {
        let faulty = with_faults && bench.board().elapsed() >= next_fault;
        if faulty {
            next_fault += TEN_MINUTES;
        }
        let record = calibrate(&mut bench, faulty, folder.path())?;
        tally.records = record::digest(&[tally.records.as_slice(), &record].concat());
        tally.runs += 1;
        tally.faults += u32::from(faulty);
        if bench.board().elapsed() >= next_report {
            next_report += TEN_MINUTES;
            report(&mut bench, &mut tally, start)?;
        }
    }
    report(&mut bench, &mut tally, start)
}

/// One run with its download and release, and the record's bytes; a reference that is dead stops it,
/// and it is stored as such.
fn calibrate(bench: &mut Bench, faulty: bool, folder: &Path) -> Result<Vec<u8>, Fault> {
    let points = [20.0, 160.0, 1000.0, 5000.0].map(|frequency_hz| point(frequency_hz, 10.0));
    if faulty {
        drop(bench.board().replace_rig(Box::new(ShortedInputs)));
    }
    let outcome = bench.run(&points)?;
    if faulty {
        let rig = Box::new(Plant::new(&Rig::standard()));
        drop(bench.board().replace_rig(rig));
    }
    let passed = outcome
        .points
        .iter()
        .all(|point| point.verdict == Verdict::Pass);
    let wanted = match faulty {
        true => RunState::Stopped,
        false => RunState::Finished,
    };
    if outcome.state != wanted || passed == faulty {
        return Err(format!("a run ends {:?}: {:?}", outcome.state, outcome.points).into());
    }
    let file = session::download(&mut bench.client, outcome.record_id, folder, |_| ())?;
    if file.record.points.as_slice() != outcome.points.as_slice() {
        return Err(format!("record {} is another one", outcome.record_id).into());
    }
    let content = std::fs::read(&file.path)?;
    std::fs::remove_file(file.path)?;
    bench.client.release(outcome.record_id)?;
    Ok(content)
}

/// The first bytes of a sum, enough to see that two are the same.
fn short(sum: &Sha256Sum) -> String {
    sum.iter()
        .take(8)
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// Prints where it is, and fails when a sample, or the firmware, was lost.
fn report(bench: &mut Bench, tally: &mut Tally, start: Instant) -> Result<(), Fault> {
    let status = bench.client.status()?;
    let (pairs, elapsed_s, restarts, erases) = {
        let mut board = bench.board();
        let erases: u64 = board.flash_watch().erases().iter().sum();
        let restarts = board.resets()?.len();
        (
            board.sample_pairs(),
            board.elapsed().as_secs_f64(),
            restarts,
            erases,
        )
    };
    // The clock starts with the firmware, some milliseconds after power: what is compared is a span.
    let missing = (elapsed_s * SAMPLE_RATE_HZ - pairs as f64) / SAMPLE_RATE_HZ;
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "{:.1} virtual minutes, {} runs, {} with a fault; {pairs} pairs, begun {:.6} s after power; \
         {} overruns, {restarts} restarts, {erases} erases; records {}; {seconds:.0} s",
        elapsed_s / 60.0,
        tally.runs,
        tally.faults,
        missing,
        status.overruns,
        short(&tally.records),
    );
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        let json = serde_json::json!({
            "virtual_s": elapsed_s, "runs": tally.runs, "faults": tally.faults, "pairs": pairs,
            "begun_s": missing, "overruns": status.overruns, "restarts": restarts,
        });
        std::fs::write(path, json.to_string())?;
    }
    let drift_s = missing - *tally.begun_s.get_or_insert(missing);
    if drift_s.abs() > 1.0 / SAMPLE_RATE_HZ {
        return Err(format!("the pairs are {drift_s} s off their rate").into());
    }
    match (status.overruns, restarts) {
        (0, 0) => Ok(()),
        _ => Err("samples were lost, or the firmware restarted".into()),
    }
}
