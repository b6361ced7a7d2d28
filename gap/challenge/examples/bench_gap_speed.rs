//! Speed of the diagnosis: 214 rows with all columns, all candidates and pairs. `bench_gap_speed [DATASETS]`
//!
//! Every dataset is written by the digital twin. Times of single datasets are processor
//! time of one core of this computer; then many in one call, and
//! then the same task done plainly with numpy and scipy (`xtask/bench/gap_scipy.py`), on
//! the same datasets, beside ours.

use calib_effects::{Of, entries};
use calib_gap::{Answer, Options, diagnose, diagnose_all};
use calib_gap_challenge::draw;
use calib_twin::dataset::{self, Nominal, generate, standard_design};
use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::SeedableRng;
use rayon::prelude::*;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

/// Datasets of one call when nothing else is said.
const MANY: usize = 1000;
/// Datasets timed one by one: each effect three times, and nine without any.
const SINGLE: usize = 135;

/// Datasets that the peer diagnoses too: each effect once, and three without any.
const PEER: usize = 45;

/// One dataset diagnosed.
struct Run {
    seconds: f64,
    /// Whether what leads is what the dataset was made with.
    right: bool,
}

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    let stated = std::env::args().nth(1).and_then(|n| n.parse().ok());
    let many: usize = stated.unwrap_or(MANY).max(PEER);
    let sets: Vec<PathBuf> = (0..many)
        .into_par_iter()
        .map(|index| make(folder.path(), index))
        .collect();
    let runs = one_by_one(&sets[..SINGLE.min(many)]);
    let begun = Instant::now();
    let answers = diagnose_all(&sets, &Options::default(), |_, _| ());
    let call_s = begun.elapsed().as_secs_f64();
    assert!(answers.iter().all(Result::is_ok));
    let cores = rayon::current_num_threads();
    let slowest = slowest(&runs);
    print(&runs, slowest);
    println!("{many} datasets in one call  {call_s:>8.1} s on {cores} cores");
    let peer = peer(&sets[..PEER]);
    if let Some(peer) = &peer {
        beside(&runs[..PEER], peer);
    }
    if let Some(file) = std::env::var_os("CALIB_BENCH_JSON") {
        let [median_s, p90_s, worst_s] = quantiles(&runs);
        let table = json!({
            "median_s": median_s, "p90_s": p90_s, "worst_s": worst_s,
            "worst": slowest, "datasets": many, "call_s": call_s, "cores": cores,
            "beside": { "calib": side(&runs[..PEER]), "scipy": peer.as_deref().map(side) },
        });
        std::fs::write(file, table.to_string()).expect("written");
    }
}

/// Each set diagnosed on one core, and the processor time of that.
fn one_by_one(sets: &[PathBuf]) -> Vec<Run> {
    let options = Options::default();
    let run = |(index, set): (usize, &PathBuf)| {
        let begun = processor_s();
        let answer = diagnose(set, &options).expect("an answer");
        Run {
            seconds: processor_s() - begun,
            right: leads(&answer) == truth(index),
        }
    };
    sets.iter().enumerate().map(run).collect()
}

/// Effect of the slowest dataset.
fn slowest(runs: &[Run]) -> &'static str {
    let by_time = |(_, a): &(usize, &Run), (_, b): &(usize, &Run)| a.seconds.total_cmp(&b.seconds);
    name(runs.iter().enumerate().max_by(by_time).map_or(0, |r| r.0))
}

fn print(runs: &[Run], slowest: &str) {
    let [median_s, p90_s, worst_s] = quantiles(runs);
    let effects = entries(Of::Calibrator).count();
    println!("214 rows, all columns, {effects} effects and their pairs   aim");
    println!("  median on one core      {median_s:>8.3} s            0.3 s");
    println!("  nine of ten below       {p90_s:>8.3} s");
    println!("  worst on one core       {worst_s:>8.3} s            1.5 s  ({slowest})");
}

/// Runs on the sets that the peer has too, as JSON.
fn side(runs: &[Run]) -> Value {
    let [median_s, _, worst_s] = quantiles(runs);
    let right = runs.iter().filter(|r| r.right).count();
    json!({"datasets": runs.len(), "median_s": median_s, "worst_s": worst_s, "right": right})
}

/// Both on the same datasets.
fn beside(ours: &[Run], theirs: &[Run]) {
    let ([our_median, _, our_worst], [median, _, worst]) = (quantiles(ours), quantiles(theirs));
    let right = |runs: &[Run]| runs.iter().filter(|r| r.right).count();
    println!("\n{PEER} of them, one core       calib gap   numpy/scipy");
    println!(
        "  median                  {our_median:>8.3} s  {median:>10.3} s   {:>6.1} x",
        median / our_median
    );
    println!(
        "  worst                   {our_worst:>8.3} s  {worst:>10.3} s   {:>6.1} x",
        worst / our_worst
    );
    println!(
        "  what it was made with leads  {:>3}  {:>12}",
        right(ours),
        right(theirs)
    );
}

/// Median, ninth decile and longest time.
fn quantiles(runs: &[Run]) -> [f64; 3] {
    let mut times: Vec<f64> = runs.iter().map(|r| r.seconds).collect();
    times.sort_by(f64::total_cmp);
    let last = times.len() - 1;
    [times[last / 2], times[9 * last / 10], times[last]]
}

/// Processor time of this thread, in s: what else the computer does takes no part. Wall time where
/// there is no such figure.
fn processor_s() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = text
        .split_whitespace()
        .next()
        .and_then(|t| t.parse::<f64>().ok());
    let since = || std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    nanoseconds.map_or_else(|| since().map_or(0.0, |t| t.as_secs_f64()), |t| t * 1e-9)
}

/// Names that lead, none where there is no gap.
fn leads(answer: &Answer) -> Vec<&str> {
    match answer.verdict {
        calib_gap::Verdict::NoGap => Vec::new(),
        _ => answer
            .causes
            .first()
            .map_or(Vec::new(), |c| c.effects.clone()),
    }
}

fn truth(index: usize) -> Vec<&'static str> {
    Some(name(index))
        .filter(|n| *n != NONE)
        .into_iter()
        .collect()
}

/// Runs numpy and scipy on these datasets, if there is an interpreter that has them.
fn peer(sets: &[PathBuf]) -> Option<Vec<Run>> {
    let interpreter = std::env::var_os("CALIB_PYTHON").unwrap_or_else(|| "python3".into());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../xtask/bench/gap_scipy.py");
    let mut command = Command::new(interpreter);
    command.arg(script).args(sets).stderr(Stdio::inherit());
    let output = command.output().ok()?;
    if !output.status.success() {
        println!("(numpy and scipy are not installed: no comparison)");
        return None;
    }
    let lines = output
        .stdout
        .split(|byte| *byte == b'\n')
        .filter(|l| !l.is_empty());
    let run = |(index, line): (usize, &[u8])| {
        let value: Value = serde_json::from_slice(line).ok()?;
        let first: Vec<&str> = value["first"]
            .as_array()?
            .iter()
            .filter_map(Value::as_str)
            .collect();
        Some(Run {
            seconds: value["seconds"].as_f64()?,
            right: first == truth(index),
        })
    };
    lines.enumerate().map(run).collect()
}

const NONE: &str = "no effect";

/// Effects take turns; every fifteenth dataset has none.
fn name(index: usize) -> &'static str {
    let all = draw::nameable();
    match index % 15 {
        14 => NONE,
        _ => all[(index - index / 15) % all.len()].entry.id,
    }
}

fn make(folder: &Path, index: usize) -> PathBuf {
    let nominal = Nominal::standard();
    let design = standard_design(&nominal);
    let mut random = ChaCha12Rng::seed_from_u64(index as u64);
    let all = draw::nameable();
    let effect = all
        .into_iter()
        .find(|effect| effect.entry.id == name(index));
    let effects: Vec<_> = effect
        .map(|effect| draw::draw(effect, &mut random))
        .into_iter()
        .collect();
    let options = dataset::Options {
        seed: index as u64,
        ..dataset::Options::default()
    };
    let made = generate(&nominal, &design, &effects, &options);
    let path = folder.join(format!("{index:04}"));
    dataset::write(&path, &nominal, &made.points).expect("written");
    path
}
