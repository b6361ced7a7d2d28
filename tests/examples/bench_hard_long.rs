//! `./run bench hard-long [MINUTES [faults] [resume]]`: calibrating, storing, downloading and releasing
//! without a pause, for 24 virtual hours when nothing else is said; with `faults`, both cables are short
//! once in ten minutes. No restart, no overrun, and exactly 50 000 pairs in a second.
//!
//! Every virtual hour the run is kept; with `resume` the last one kept goes on. What it comes to is the
//! same either way, down to the chained sum of all records.

use calib_core::point_state::PointState;
use calib_protocol::message::RunState;
use calib_protocol::record::{self, Sha256Sum};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::rig_port::ShortedInputs;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

const SAMPLE_RATE_HZ: f64 = 50_000.0;
/// Time between two faults, and between two reports.
const TEN_MINUTES: Duration = Duration::from_secs(600);
/// Time between two instants at which the run is kept.
const HOUR: Duration = Duration::from_secs(3600);

/// Result of a long run.
#[derive(Serialize, Deserialize)]
struct Tally {
    runs: u32,
    faults: u32,
    /// SHA-256 of every record so far, chained: equal where two runs did the same.
    records: Sha256Sum,
    /// From power on to the first pair, s, as the first report has it.
    begun_s: Option<f64>,
    next_report: Duration,
    next_fault: Duration,
    next_keep: Duration,
}

impl Default for Tally {
    fn default() -> Self {
        Self {
            runs: 0,
            faults: 0,
            records: Sha256Sum::default(),
            begun_s: None,
            next_report: TEN_MINUTES,
            next_fault: Duration::ZERO,
            next_keep: HOUR,
        }
    }
}

fn main() -> Result<(), Fault> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let said = |word: &str| arguments.iter().any(|argument| argument == word);
    let minutes = arguments.first().and_then(|text| text.parse().ok());
    let goal = Duration::from_secs(60 * minutes.unwrap_or(24 * 60_u64));
    let with_faults = said("faults");
    let start = Instant::now();
    let kept = Kept::place(with_faults);
    let (mut rigged, mut tally) = match said("resume") {
        true => kept.go_on()?,
        false => (Rigged::with_rig(&Rig::standard())?, Tally::default()),
    };
    while rigged.board().elapsed() < goal {
        let faulty = with_faults && rigged.board().elapsed() >= tally.next_fault;
        if faulty {
            tally.next_fault += TEN_MINUTES;
        }
        let record = calibrate(&mut rigged, faulty)?;
        tally.records = record::digest(&[tally.records.as_slice(), &record].concat());
        tally.runs += 1;
        tally.faults += u32::from(faulty);
        if rigged.board().elapsed() >= tally.next_report {
            tally.next_report += TEN_MINUTES;
            report(&mut rigged, &mut tally, start)?;
        }
        if rigged.board().elapsed() >= tally.next_keep {
            tally.next_keep += HOUR;
            kept.keep(&mut rigged, &tally)?;
        }
    }
    report(&mut rigged, &mut tally, start)
}

/// Where a run is kept every hour: the board, and what was counted so far.
struct Kept {
    board: PathBuf,
    tally: PathBuf,
}

impl Kept {
    /// Beside the figures of the bench; a run with faults is another one.
    fn place(with_faults: bool) -> Self {
        let figures = std::env::var_os("CALIB_BENCH_JSON").map(PathBuf::from);
        let folder = figures.as_ref().and_then(|path| path.parent());
        let name = match with_faults {
            true => "hard-long-faults",
            false => "hard-long",
        };
        let path = folder.unwrap_or(Path::new(".")).join(name);
        Self {
            board: path.with_extension("run"),
            tally: path.with_extension("tally"),
        }
    }

    fn keep(&self, rigged: &mut Rigged, tally: &Tally) -> Result<(), Fault> {
        rigged.keep(&self.board)?;
        std::fs::write(&self.tally, serde_json::to_string(tally)?)?;
        println!("kept in {}", self.board.display());
        Ok(())
    }

    fn go_on(&self) -> Result<(Rigged, Tally), Fault> {
        let tally = std::fs::read_to_string(&self.tally)
            .map_err(|error| format!("no run is kept in {}: {error}", self.tally.display()))?;
        let rigged = Rigged::go_on(&Rig::standard(), &self.board)?;
        Ok((rigged, serde_json::from_str(&tally)?))
    }
}

/// One run with its download and release, and the record's bytes; a reference that is dead stops it,
/// and it is stored as such.
fn calibrate(rigged: &mut Rigged, faulty: bool) -> Result<Vec<u8>, Fault> {
    let points = [20.0, 160.0, 1000.0, 5000.0].map(|frequency_hz| point(frequency_hz, 10.0));
    if faulty {
        drop(rigged.board().replace_rig(Box::new(ShortedInputs)));
    }
    let outcome = rigged.run(&points)?;
    if faulty {
        let rig = Box::new(Plant::new(&Rig::standard()));
        drop(rigged.board().replace_rig(rig));
    }
    let passed = outcome
        .points
        .iter()
        .all(|point| point.state == PointState::Valid);
    let wanted = match faulty {
        true => RunState::Stopped,
        false => RunState::Finished,
    };
    if outcome.state != wanted || passed == faulty {
        return Err(format!("a run ends {:?}: {:?}", outcome.state, outcome.points).into());
    }
    let content = rigged.record(outcome.record_id)?;
    if record::decode(&content)?.points.as_slice() != outcome.points.as_slice() {
        return Err(format!("record {} is another one", outcome.record_id).into());
    }
    rigged.client.release(outcome.record_id)?;
    Ok(content)
}

/// The first bytes of a sum, enough to see that two are the same.
fn short(sum: &Sha256Sum) -> String {
    hex::encode(&sum[..8])
}

/// Prints where it is, and fails when a sample, or the firmware, was lost.
fn report(rigged: &mut Rigged, tally: &mut Tally, start: Instant) -> Result<(), Fault> {
    let status = rigged.client.status()?;
    let (pairs, elapsed_s, restarts, erases) = {
        let mut board = rigged.board();
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
