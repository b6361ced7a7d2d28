//! Speed of the diagnosis: 214 rows with all columns, all candidates and pairs.
//!
//! Every dataset is written by the digital twin. Times of single datasets are of one core
//! of this computer while nothing else of this program runs; the last line is one call.

use calib_gap::{Options, diagnose, diagnose_all};
use calib_host::gap::draw;
use calib_twin::dataset::{self, Nominal, generate, standard_design};
use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::SeedableRng;
use rayon::prelude::*;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Datasets of one call.
const MANY: usize = 1000;
/// Datasets timed one by one: each effect three times, and nine without any.
const SINGLE: usize = 135;

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    let sets: Vec<PathBuf> = (0..MANY)
        .into_par_iter()
        .map(|index| make(folder.path(), index))
        .collect();
    let options = Options::default();
    let mut times: Vec<(f64, usize)> = (0..SINGLE)
        .map(|index| {
            let begun = Instant::now();
            diagnose(&sets[index], &options).expect("an answer");
            (begun.elapsed().as_secs_f64(), index)
        })
        .collect();
    times.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (median_s, p90_s) = (times[SINGLE / 2].0, times[9 * SINGLE / 10].0);
    let (worst_s, worst) = times[SINGLE - 1];
    let begun = Instant::now();
    let answers = diagnose_all(&sets, &options, |_, _| ());
    let call_s = begun.elapsed().as_secs_f64();
    assert!(answers.iter().all(Result::is_ok));
    let cores = rayon::current_num_threads();
    println!("214 rows, all columns, 42 effects and their pairs   aim");
    println!("  median on one core      {median_s:>8.3} s            0.3 s");
    println!("  nine of ten below       {p90_s:>8.3} s");
    println!(
        "  worst on one core       {worst_s:>8.3} s            1.0 s  ({})",
        name(worst)
    );
    println!("{MANY} datasets in one call  {call_s:>8.1} s on {cores} cores");
    if let Some(file) = std::env::var_os("CALIB_BENCH_JSON") {
        let table = json!({
            "median_s": median_s, "p90_s": p90_s, "worst_s": worst_s,
            "worst": name(worst), "datasets": MANY, "call_s": call_s, "cores": cores,
        });
        std::fs::write(file, table.to_string()).expect("written");
    }
}

/// Effects take turns; every fifteenth dataset has none.
fn name(index: usize) -> &'static str {
    let all = draw::nameable();
    match index % 15 {
        14 => "no effect",
        _ => all[(index - index / 15) % all.len()].id,
    }
}

fn make(folder: &Path, index: usize) -> PathBuf {
    let nominal = Nominal::standard();
    let design = standard_design(&nominal);
    let mut random = ChaCha12Rng::seed_from_u64(index as u64);
    let all = draw::nameable();
    let effect = all.into_iter().find(|effect| effect.id == name(index));
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
